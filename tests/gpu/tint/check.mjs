// Chrome's WGSL compiler on the presets and on the whole port, without a browser, a GPU or a
// driver.
//
// `npm ci && node check.mjs [PROGRAM]`; the texts come from PROGRAM, the example `wgsl` where it is
// built, or from `cargo run --example wgsl`. Exit status: 0, or 1 with what Tint said.

import { execFileSync } from "node:child_process";
import { resolve } from "node:path";
import { fileURLToPath } from "node:url";
import { create } from "webgpu";

const root = fileURLToPath(new URL("../../..", import.meta.url));
const [program, ...start] = process.argv[2]
  ? [resolve(process.argv[2])]
  : ["cargo", "run", "--quiet", "--example", "wgsl", "--"];

/** What the example prints. */
function wgsl(...options) {
  const stdio = ["ignore", "pipe", "inherit"];
  return execFileSync(program, [...start, ...options], { cwd: root, encoding: "utf8", stdio });
}

/** First words of the lines below a heading. */
function names(list, heading) {
  const section = list.split("\n\n").find((part) => part.startsWith(heading));
  return section.trim().split("\n").slice(1).map((line) => line.split(" ")[0]);
}

// Global, so that it is not collected: the device does not keep it alive.
globalThis.gpu = create(["backend=null"]);
const device = await (await globalThis.gpu.requestAdapter()).requestDevice();

/** Tint's errors, one a line. */
async function errors(code) {
  // The same errors come back by the device; here they are expected.
  device.pushErrorScope("validation");
  const { messages } = await device.createShaderModule({ code }).getCompilationInfo();
  await device.popErrorScope();
  const wrong = messages.filter((message) => message.type === "error");
  return wrong.map(({ lineNum, linePos, message }) => `${lineNum}:${linePos} ${message}`);
}

const failures = [];
const list = wgsl("--list");
const presets = names(list, "Presets").map((name) => [name, ["--preset", name]]);
const items = names(list, "Items");
if (presets.length === 0 || items.length === 0) {
  failures.push("the list of items or presets is empty");
}
for (const [name, options] of [...presets, ["all items", ["--items", items.join(",")]]]) {
  const found = await errors(wgsl(...options, "--entry"));
  if (found.length > 0) failures.push(`${name}: ${found.join("\n    ")}`);
}

// A check that cannot fail checks nothing: what Tint must refuse, and what it says.
const text = wgsl("--items", "fragment_footprint");
const fragment = (body) => `${text}
  @fragment fn main(@location(0) h: vec3f) -> @location(0) vec4f {
    var footprint = LobeFootprint(vec2f(0.0), vec2f(0.0));
    ${body}
    return vec4f(footprint.u, footprint.v);
  }`;
const call = "footprint = lobe_fragment_footprint(h);";
for (const [name, code, said] of [
  ["an unknown name", fragment("footprint = lobe_fragment_foot(h);"), "unresolved"],
  ["derivatives in one branch", fragment(`if h.x > 0.0 { ${call} }`), "uniform"],
]) {
  const found = await errors(code);
  if (!found.some((line) => line.includes(said))) failures.push(`accepted: ${name}`);
}
if ((await errors(fragment(call))).length > 0) failures.push("refused: derivatives at top level");

console.log(`tint: ${presets.length} presets, ${items.length} items, ${failures.length} failures`);
for (const failure of failures) console.error(failure);
// The device would keep the program alive.
process.exit(failures.length > 0 ? 1 : 0);
