// Plays the scenes that play_scenes wrote, by the module and with the same calls, and compares every line.
//
// Usage: node play_scenes.js lodlab_live.js FOLDER    exits 1 with a line for each scene of other bits
"use strict";

const crypto = require("crypto");
const fs = require("fs");
const path = require("path");

const [, , modulePath, folder] = process.argv;

const callsOf = (module) => (name, gives, ...takes) => module.cwrap(`lodlab_live_${name}`, gives, takes);

const opened = (module, scene) => {
  const bytes = module.lengthBytesUTF8(scene) + 1;
  const place = module._malloc(bytes);
  module.stringToUTF8(scene, place, bytes);
  const live = module._lodlab_live_open(place);
  module._free(place);
  return live;
};

const play = (module, scene) => {
  const wrap = callsOf(module);
  const error = wrap("error", "string");
  const need = (code) => { if (code !== 0) throw new Error(error()); };
  const live = opened(module, scene);
  if (!live) throw new Error(error());
  const [state, figure] = [wrap("state", "string", "number"), wrap("figure", "string", "number")];
  const [step, reset] = [wrap("step", "number", "number", "number"), wrap("reset", "number", "number")];
  const five = ["number", "number", "number", "number", "number"];
  const [place, move] = [wrap("place", "number", ...five), wrap("move", "number", ...five)];
  const fixate = wrap("fixate", "number", "number", "number", "number");
  const set = wrap("set", "number", "number", "string", "number");
  const choose = wrap("choose", "number", "number", "string", "string");
  let lines = "";
  const tell = () => {
    const hash = crypto.createHash("sha256").update(figure(live)).digest("hex");
    lines += `${JSON.parse(state(live)).hash} ${hash}\n`;
  };
  const sha256 = (text) => crypto.createHash("sha256").update(text).digest("hex");
  const turn = (frames) => {
    need(step(live, frames));
    tell();
    lines += `${sha256(wrap("events", "string", "number")(live))}\n`;
    for (let event = 0; event < 60; event += event < 12 ? 1 : 7) {
      if (set(live, "event", event) !== 0) break;
      tell();
    }
    need(set(live, "event", -1));
  };
  tell();
  turn(100);
  need(set(live, "level", 1));
  need(place(live, 0, 0.125, -0.25, 0.5));
  turn(60);
  need(set(live, "level", 1000));
  need(set(live, "budget", 40));
  need(set(live, "pair_cost", 2));
  need(choose(live, "policy", "perceptual"));
  need(fixate(live, 0.5, 0.25));
  turn(60);
  need(set(live, "restitution", 0.5));
  need(choose(live, "contact_model", "node_normal"));
  need(choose(live, "response", "sum"));
  move(live, 1, -1, 0.5, 2);
  turn(60);
  need(reset(live));
  tell();
  wrap("close", null, "number")(live);
  return lines;
};

const main = async () => {
  const module = await require(path.resolve(modulePath))();
  const made = module._lodlab_live_sources ? module.cwrap("lodlab_live_sources", "string", [])() : "";
  const sources = fs.readFileSync(path.join(folder, "sources"), "utf8");
  if (made !== sources) console.log(`live: ${modulePath} was made of other sources than this build; scripts/wasm makes it anew`);
  let same = 0;
  let other = 0;
  for (const name of fs.readdirSync(folder).filter((file) => file.endsWith(".json")).sort()) {
    const scene = fs.readFileSync(path.join(folder, name), "utf8");
    const wanted = fs.readFileSync(path.join(folder, name.replace(/json$/, "txt")), "utf8");
    const made = play(module, scene);
    if (made === wanted) { same += 1; continue; }
    other += 1;
    console.log(`${name}: node makes\n${made}instead of\n${wanted}`);
  }
  console.log(`live: ${same} of ${same + other} scenes are played to the same bits`);
  process.exit(other > 0 || same === 0 ? 1 : 0);
};

main();
