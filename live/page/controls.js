// The controls of a live scene, by name: all of them on a page of its own, in a lesson those that it has introduced.
// A name may be followed by choices: "policy level_order first_come" offers these two.
"use strict";

const lodlabControls = (() => {
  const slider = (name, words, range) =>
    `<label class="slider ${name}-row"><span>${words}</span><input type="range" class="${name}" ${range}><output class="${name}-value"></output></label>`;
  const choice = (name, words, options) => ({
    text: (wanted) => `<label class="choice"><span>${words}</span><select class="${name}">` +
      Object.entries(options).filter(([key]) => wanted.length === 0 || wanted.includes(key))
        .map(([key, told]) => `<option value="${key}">${told}</option>`).join("") + "</select></label>",
  });
  const reading = (name, words) => `<div><dt>${words}</dt><dd class="${name}"></dd></div>`;

  const parts = {
    time: '<button type="button" class="play">Play</button> <button type="button" class="step">Step</button>',
    speed: '<label class="pace">Speed <select class="speed"><option value="1">1</option><option value="0.25">1/4</option><option value="0.05">1/20</option></select></label>',
    contacts: reading("contacts", "contacts"),
    energy: reading("energy", "kinetic energy"),
    level: slider("level", "Deepest level", 'min="0" step="1"'),
    budget: slider("budget", "Frame budget", 'min="0" step="1"'),
    reserve: slider("reserve", "Reserve a pair", 'min="0" max="20" step="1" value="0"'),
    shown: choice("shown", "Circles shown", { near: "that were tested", circles: "all of the level", hulls: "hulls of the level" }),
    tests: '<ul class="levels" aria-label="Node tests of each level"></ul>',
    equation: '<dl class="equation" aria-label="The impulse at the deepest contact"></dl>',
    restitution: slider("restitution", "Restitution", 'min="0" max="1" step="0.05"'),
    policy: choice("policy", "Pairs refined first", {
      level_order: "level by level", closing_speed: "the fastest approach", first_come: "one after the other",
      perceptual: "where one looks", best_gain: "the most gain a test", trade: "trade of levels",
    }),
    contact_model: choice("contact_model", "Contacts from", {
      hull: "hulls of nodes", node_normal: "normals of nodes", centre_line: "centre lines (eq. 4)",
    }),
    response: choice("response", "Impulses", {
      net: "net, keeps energy", sum: "sum", mean: "mean", sequential: "sequential", lcp: "LCP", reflections: "reflections",
    }),
    pairs: '<div class="scrolls" tabindex="0" role="region" aria-label="Pairs that are near"><table class="pairs"><thead><tr><th scope="col">pair</th>' +
      '<th scope="col">level</th><th scope="col">collision</th><th scope="col" class="of-answers">contacts</th><th scope="col" class="of-answers">true gap</th>' +
      '<th scope="col" class="of-answers">stands out</th></tr></thead><tbody></tbody></table></div>',
    inside: '<section class="part inside" aria-label="Inside this frame"><p class="inside-head"><span>Inside this frame</span> <span class="count"></span></p>' +
      '<div class="stepper" role="group" aria-label="Events of the frame">' +
      ["first", "back", "next", "last", "leave"].map((way) => `<button type="button" class="go-${way}">${way[0].toUpperCase()}${way.slice(1)}</button>`).join("") +
      '</div><p class="now"></p><div class="events" hidden></div></section>',
    state: '<p class="quiet"><span class="frames"></span>, state <code class="hash"></code>.</p>',
    save: '<p class="quiet saves"><button type="button" class="save-svg">Save SVG</button> <button type="button" class="save-png">Save PNG</button></p>',
  };
  const quota = '<div class="quota" aria-hidden="true"><span class="spent"></span><span class="dropped"></span><span class="reserved"></span></div><p class="spending"></p>';
  const dots = "Drag a body, or turn it by the dot beside it; with the keyboard: Tab, arrows, comma and full stop (Shift: finer).";

  // "level, policy level_order first_come" -> { level: [], policy: ["level_order", "first_come"] }; "": all.
  const read = (names) =>
    Object.fromEntries(names.trim() === "" ? Object.keys(parts).map((name) => [name, []])
      : names.split(",").map((item) => item.trim().split(/\s+/)).map(([name, ...choices]) => [name, choices]));

  // Puts the controls into their place; what stands there already comes between detail and response.
  const put = (place, names) => {
    const wanted = read(names);
    const part = (name) => (wanted[name] ? parts[name].text?.(wanted[name]) ?? parts[name] : "");
    const some = (...those) => those.map(part).join("");
    const within = (open, inside, close) => (inside === "" ? "" : open + inside + close);
    const readings = (wanted.time ? reading("time", "time") : "") + some("contacts", "energy");
    place.insertAdjacentHTML("afterbegin",
      `<div class="run" role="group" aria-label="Time">${some("time")} <button type="button" class="reset">${wanted.time ? "Reset" : "Put back"}</button>${some("speed")}</div>` +
      within('<dl class="readings">', readings, "</dl>") +
      within('<section class="part" aria-label="Detail">', some("level", "budget", "reserve", "shown") + (wanted.budget ? quota : "") + some("tests"), "</section>"));
    const table = part("pairs");
    const isWhole = names.trim() === "";
    place.insertAdjacentHTML("beforeend",
      within('<section class="part" aria-label="Response">', some("equation", "restitution", "policy", "contact_model", "response"), "</section>") +
      (isWhole ? `<details><summary>Pairs that are near</summary>${table}<p class="quiet">The true gap is what a contact at a coarse level gets wrong; how far the circles of both bodies stand out at their level is an estimate of how wrong it can be.</p></details>` : within('<section class="part" aria-label="Pairs">', table, "</section>")) +
      part("inside") + `<p class="quiet hint">${dots}</p>` + some("state", "save"));
  };

  return { put, names: Object.keys(parts) };
})();
if (typeof module !== "undefined") module.exports = lodlabControls;
