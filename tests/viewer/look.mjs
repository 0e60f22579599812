// Opens a run in the viewer, in headless Chromium, and checks what it shows:
//   node look.mjs MODULES CHROMIUM LAYOUT.json SOURCE TRAJECTORY.tum PICTURE.png [SECONDS]
// MODULES is the folder node_modules, SOURCE a file result.mcap, which is shown two seconds before its end, or the address of a run that is
// served (ws://...), TRAJECTORY.tum the path of that run. Fails unless all topics of a run are listed, no problem is, the map has walls
// and free space, path and scan have their colours, and degree and variance are plotted from the beginning of the run to its end.
import { createReadStream, readFileSync, statSync } from "node:fs";
import { createServer } from "node:http";
import { createRequire } from "node:module";
import path from "node:path";
import process from "node:process";

const [modules, chromium, layout, source, trajectory, picture, seconds = "60"] = process.argv.slice(2);
const puppeteer = createRequire(path.join(modules, "x.js"))("puppeteer-core");
const topics = ["/degeneracy", "/map", "/particlecloud", "/path", "/pose", "/scan", "/tf", "/tf_static"];
const types = { ".html": "text/html", ".js": "text/javascript", ".json": "application/json", ".wasm": "application/wasm" };

// Serves the page, the modules and the log, of which a viewer asks for ranges of bytes.
const server = createServer((request, response) => {
    const name = decodeURIComponent(new URL(request.url, "http://localhost").pathname);
    let file = path.join(modules, path.normalize(name));
    if (name === "/") {
        file = new URL("page.html", import.meta.url).pathname;
    } else if (name === "/layout.json") {
        file = layout;
    } else if (name === "/result.mcap") {
        file = source;
    }
    const size = statSync(file, { throwIfNoEntry: false })?.size;
    if (size === undefined) {
        response.writeHead(404).end();
        return;
    }
    const range = /^bytes=(\d+)-(\d*)$/.exec(request.headers.range ?? "");
    const start = range ? Number(range[1]) : 0;
    const end = range?.[2] ? Math.min(Number(range[2]), size - 1) : size - 1;
    response.writeHead(range ? 206 : 200, {
        "Accept-Ranges": "bytes", "Content-Length": end - start + 1,
        "Content-Type": types[path.extname(file)] ?? "application/octet-stream",
        ...(range ? { "Content-Range": `bytes ${start}-${end}/${size}` } : {}),
    });
    request.method === "HEAD" ? response.end() : createReadStream(file, { start, end }).pipe(response);
});
await new Promise((resolve) => server.listen(0, "127.0.0.1", resolve));
const place = `http://127.0.0.1:${server.address().port}`;

const track = readFileSync(trajectory, "utf8").trim().split("\n").filter((line) => !line.startsWith("#")).map((line) => Number(line.split(" ")[0]));
const duration = track.at(-1) - track[0];
const address = new URL(place);
address.searchParams.set("layoutId", "ddtool");
if (source.startsWith("ws:")) {
    address.searchParams.set("ds", "foxglove-websocket");
    address.searchParams.set("ds.url", source);
} else {
    const lastMs = Math.floor(track.at(-1) * 1000) - 2000;  // the viewer draws no scan at the very end
    address.searchParams.set("ds", "remote-file");
    address.searchParams.set("ds.url", `${place}/result.mcap`);
    address.searchParams.set("time", new Date(lastMs).toISOString());
}

const browser = await puppeteer.launch({
    executablePath: chromium, headless: true,
    args: ["--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--ignore-gpu-blocklist", "--disable-dev-shm-usage"],
});
const page = await browser.newPage();
await page.setViewport({ width: 1280, height: 800 });
const errors = [];
page.on("pageerror", (error) => errors.push(String(error.message ?? error)));
if (process.env.VIEWER_LOG) {
    page.on("console", (message) => console.error(message.type(), message.text().slice(0, 300)));
}
await page.goto(address.href, { timeout: 1000 * Number(seconds) });

// What a picture of a part of the page has: the number of pixels of each colour that the layout gives to the map and what lies on it,
// and from where to where, as parts of its width, anything is that is not grey, as the lines of a plot are.
const look = async (clip) => await page.evaluate(async (data) => {
    const image = new Image();
    image.src = `data:image/png;base64,${data}`;
    await image.decode();
    const canvas = new OffscreenCanvas(image.width, image.height);
    const context = canvas.getContext("2d");
    context.drawImage(image, 0, 0);
    const pixels = context.getImageData(0, 0, image.width, image.height).data;
    const wanted = { wall: [0, 0, 0], free: [255, 255, 255], unknown: [0xb0, 0xb0, 0xb0], path: [0x1f, 0x77, 0xb4],
                     scan: [0x2c, 0xa0, 0x2c] };
    const counts = Object.fromEntries(Object.keys(wanted).map((name) => [name, 0]));
    let [left, right] = [1, 0];
    for (let at = 0; at < pixels.length; at += 4) {
        const pixel = pixels.slice(at, at + 3);
        for (const [name, colour] of Object.entries(wanted)) {
            counts[name] += colour.every((value, index) => Math.abs(value - pixel[index]) < 24) ? 1 : 0;
        }
        if (Math.max(...pixel) - Math.min(...pixel) > 40) {
            const column = ((at / 4) % image.width) / image.width;
            [left, right] = [Math.min(left, column), Math.max(right, column)];
        }
    }
    return { counts, left, right };
}, Buffer.from(await page.screenshot({ clip })).toString("base64"));
// How many seconds the viewer takes the run to last: h:mm:ss.mmm.
const shownDuration = (text) => {
    const [, hours, minutes, rest] = /DURATION\s+(\d+):(\d+):([\d.]+)/i.exec(text) ?? [];
    return 3600 * Number(hours) + 60 * Number(minutes) + Number(rest);
};

// Looks again and again until everything is there, because messages come one by one.
const looked = async () => {
    const text = await page.evaluate(() => document.body.innerText);
    const panels = await page.evaluate(() => [...document.querySelectorAll("canvas")].map((each) => {
        const { x, y, width, height } = each.getBoundingClientRect();
        return { x, y, width, height };
    }));
    const missing = topics.filter((topic) => !text.split(/\s+/).includes(topic)).map((topic) => `the topic ${topic}`);
    const shown = shownDuration(text);
    if (!(Math.abs(shown - duration) < 1)) {
        missing.push(`a run of ${duration.toFixed(1)} s (${shown} s)`);
    }
    if (!(panels.length >= 3 && panels.every((panel) => panel.width > 0 && panel.height > 0))) {
        return { missing: [...missing, "the panels"] };
    }
    const { counts } = await look(panels[0]);
    const least = { wall: 100, free: 5000, unknown: 5000, path: 500, scan: 50 };
    for (const [name, count] of Object.entries(least)) {
        if (counts[name] < count) {
            missing.push(`${count} pixels of the colour of '${name}' (${counts[name]})`);
        }
    }
    for (const [name, panel] of [["degree", panels[1]], ["variance", panels[2]]]) {
        const { left, right } = await look(panel);
        if (left > 0.15 || right < 0.9) {
            missing.push(`'${name}' all along its plot (from ${left.toFixed(2)} to ${right.toFixed(2)} of its width)`);
        }
    }
    return { missing, counts, shown };
};
const end = Date.now() + 1000 * Number(seconds);
let found = await looked();
while (found.missing.length > 0 && Date.now() < end) {
    await new Promise((resolve) => setTimeout(resolve, 1000));
    found = await looked();
}
await page.screenshot({ path: picture });

// The tab that lists what the viewer found wrong.
const problems = await page.evaluate(async () => {
    const tab = [...document.querySelectorAll("button[role=tab]")].find((each) => each.innerText.trim().startsWith("Problems"));
    tab?.click();
    await new Promise((resolve) => setTimeout(resolve, 500));
    return tab ? (document.body.innerText.includes("No problems found") ? "" : document.body.innerText) : "no tab 'Problems'";
});
await browser.close();
server.close();
console.log(JSON.stringify({ source, ...found, errors }));
if (found.missing.length > 0 || problems !== "" || errors.length > 0) {
    console.log(`FAILED: missing: ${found.missing.join(", ") || "nothing"}; problems: ${problems || "none"}`);
    process.exit(1);
}
