// watch.mjs DDTOOL LOG OUT: runs `ddtool slam --serve` on LOG and watches it with the client of Foxglove, from the
// start to the end and once more after the end. Decodes every message by the schema with which it was advertised.

import assert from "node:assert/strict";
import { spawn } from "node:child_process";
import { once } from "node:events";
import { createInterface } from "node:readline";
import { parse } from "@foxglove/rosmsg";
import { MessageReader } from "@foxglove/rosmsg2-serialization";
import wsProtocol from "@foxglove/ws-protocol"; // CommonJS
import { WebSocket } from "ws";

const { FoxgloveClient } = wsProtocol;

const expectedTypes = {
  "/degeneracy": "ddtool_msgs/msg/Degeneracy",
  "/map": "nav_msgs/msg/OccupancyGrid",
  "/particlecloud": "geometry_msgs/msg/PoseArray",
  "/path": "nav_msgs/msg/Path",
  "/pose": "geometry_msgs/msg/PoseWithCovarianceStamped",
  "/scan": "sensor_msgs/msg/LaserScan",
  "/tf": "tf2_msgs/msg/TFMessage",
  "/tf_static": "tf2_msgs/msg/TFMessage",
};

/** Subscribes to every channel that there is or will be; `onMessage` sees topic, type, stamp and decoded message. */
class Watcher {
  channels = new Map();
  times = [];
  serverInfo = undefined;
  counts = {};

  constructor(address, subprotocol, onMessage) {
    this.socket = new WebSocket(address, [subprotocol]);
    this.client = new FoxgloveClient({ ws: this.socket });
    this.client.on("serverInfo", (info) => (this.serverInfo = info));
    this.client.on("time", ({ timestamp }) => this.times.push(timestamp));
    this.client.on("error", (error) => assert.fail(error));
    this.client.on("status", (status) => assert.fail(JSON.stringify(status)));
    this.client.on("advertise", (channels) => channels.forEach((channel) => this.#subscribe(channel)));
    this.client.on("message", ({ subscriptionId, timestamp, data }) => {
      const { topic, schemaName, reader } = this.channels.get(subscriptionId);
      this.counts[topic] = (this.counts[topic] ?? 0) + 1;
      onMessage({ topic, type: schemaName, timestamp, message: reader.readMessage(data) });
    });
  }

  #subscribe(channel) {
    assert.equal(channel.encoding, "cdr");
    assert.equal(channel.schemaEncoding, "ros2msg");
    const reader = new MessageReader(parse(channel.schema, { ros2: true }));
    this.channels.set(this.client.subscribe(channel.id), { ...channel, reader });
  }
}

const nanoseconds = ({ sec, nsec, nanosec }) => BigInt(sec) * 1000000000n + BigInt(nsec ?? nanosec);

/** What must hold of every message. */
function check({ topic, type, timestamp, message }) {
  assert.equal(type, expectedTypes[topic], topic);
  const stamp = message.header?.stamp ?? message.transforms?.[0].header.stamp ?? message.stamp;
  assert.equal(nanoseconds(stamp), timestamp, topic);
  if (topic === "/map") {
    assert.equal(message.data.length, message.info.width * message.info.height);
  }
}

const [ddtool, log, out] = process.argv.slice(2);
const run = spawn(ddtool, ["slam", "--log", log, "--out", out, "--particles", "10", "--serve", "0"], {
  stdio: ["ignore", "ignore", "pipe"],
});
const lines = createInterface({ input: run.stderr });
const exited = once(run, "exit");
let address;
let early;
let ended = false;
for await (const line of lines) {
  address ??= line.match(/ws:\/\/\S+/)?.[0];
  if (address && !early) {
    early = new Watcher(address, "foxglove.websocket.v1", check);
  }
  if (line.includes("until Ctrl-C")) {
    ended = true;
    break;
  }
}
assert(ended, "the run failed");

// A client that connects now must get the latest message of every topic, and all of /degeneracy. After that the others
// are sent once more, since a viewer whose time jumps back forgets what it had.
const latest = new Map();
let interrupted = false; // once: a second Ctrl-C would end the program at once
const late = new Watcher(address, "foxglove.sdk.v1", (event) => {
  check(event);
  latest.set(event.topic, event);
  if (!interrupted && latest.size === Object.keys(expectedTypes).length) {
    interrupted = true;
    run.kill("SIGINT");
  }
});
const [code] = await exited;

assert.equal(code, 0);
assert.equal(early.serverInfo.name, "ddtool slam");
assert.equal(early.serverInfo.sessionId, late.serverInfo.sessionId);
assert.deepEqual([...latest.keys()].sort(), Object.keys(expectedTypes));
for (const [topic, count] of Object.entries(late.counts)) {
  assert(topic === "/degeneracy" ? count >= 1 : count === 1 || count === 2, `${topic} after the end: ${count}`);
}
// The history of /degeneracy begins with the run, so that the time may go back once, where a client subscribes to it.
const stepsBack = early.times.filter((time, place) => place > 0 && time < early.times[place - 1]).length;
assert(stepsBack <= 1, `the time goes back ${stepsBack} times`);
assert.equal(late.times.at(-1), latest.get("/map").timestamp);
assert(latest.get("/map").message.data.includes(100), "no wall in the map");
assert(early.counts["/pose"] > 10 && early.counts["/degeneracy"] > 10, JSON.stringify(early.counts));
console.log("while it ran:", JSON.stringify(early.counts), `and ${early.times.length} times`);
console.log("after the end:", JSON.stringify(late.counts));
process.exit(0);
