// time_onnx.mjs FILE.onnx SECONDS: prints the median CPU time and wall time, in milliseconds, of one image's forward
// pass in ONNX Runtime (onnxruntime-node, found through NODE_PATH) on one thread.
import { createRequire } from "node:module";

const ort = createRequire(import.meta.url)("onnxruntime-node");
const [file, seconds] = process.argv.slice(2);
const session = await ort.InferenceSession.create(file, {
  intraOpNumThreads: 1,
  interOpNumThreads: 1,
  graphOptimizationLevel: "all",
});
const pixels = Float32Array.from({ length: 224 * 224 }, () => (Math.random() > 0.999 ? 1 : 0));
const image = { [session.inputNames[0]]: new ort.Tensor("float32", pixels, [1, 1, 224, 224]) };
await session.run(image);

const cpu = [];
const wall = [];
const end = performance.now() + 1000 * Number(seconds);
while (performance.now() < end || cpu.length < 5) {
  const before = process.cpuUsage();
  const start = performance.now();
  await session.run(image);
  wall.push(performance.now() - start);
  const used = process.cpuUsage(before);
  cpu.push((used.user + used.system) / 1000);
}
const median = (values) => values.sort((a, b) => a - b)[Math.floor(values.length / 2)];
console.log(median(cpu), median(wall));
