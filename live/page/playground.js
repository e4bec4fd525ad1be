// The playground: outlines that the reader draws, or drops as an SVG, become bodies of the scene.
"use strict";

const lodlabPlayground = (live) => {
  const { make } = lodlabFigure;
  const mostCorners = 160;
  const root = live.root;
  const say = (words) => { root.querySelector(".told").textContent = words; };

  // The outlines of the scene that the page came with.
  const outlines = live.scene.bodies.map((body) => ({
    name: body.name, points: live.scene.shapes[body.shape].rings[0],
  }));
  let wanted = -1; // which body is drawn

  // Corners that stand out of the line between their neighbours most, Ramer's and Douglas and Peucker's.
  const simplified = (points, tolerance) => {
    if (points.length < 3) return points;
    const [a, b] = [points[0], points.at(-1)];
    const length = Math.hypot(b[0] - a[0], b[1] - a[1]);
    let [far, most] = [0, tolerance];
    for (let i = 1; i + 1 < points.length; ++i) {
      const [x, y] = points[i];
      const away = length > 0
        ? Math.abs((b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0])) / length
        : Math.hypot(x - a[0], y - a[1]);
      if (away > most) [far, most] = [i, away];
    }
    if (far === 0) return [a, b];
    return [...simplified(points.slice(0, far + 1), tolerance).slice(0, -1), ...simplified(points.slice(far), tolerance)];
  };

  const cornersOf = (points) => {
    const xs = points.map(([x]) => x);
    const ys = points.map(([, y]) => y);
    const size = Math.max(Math.max(...xs) - Math.min(...xs), Math.max(...ys) - Math.min(...ys));
    let corners = points;
    for (let tolerance = 0.002 * size; ; tolerance *= 1.5) {
      corners = simplified([...points, points[0]], tolerance).slice(0, -1);
      if (corners.length <= mostCorners) return corners;
    }
  };

  const use = (number, name, points) => {
    const before = outlines[number];
    outlines[number] = { name, points: cornersOf(points).flat() };
    const depth = Number(root.querySelector(".depth").value);
    const refused = live.reopen(JSON.stringify({ depth, outlines }));
    if (refused) {
      outlines[number] = before;
      say(`${refused}.`);
    } else say(`${name} has ${outlines[number].points.length / 2} corners.`);
  };

  const again = () => {
    const refused = live.reopen(JSON.stringify({ depth: Number(root.querySelector(".depth").value), outlines }));
    if (refused) say(`${refused}.`);
  };

  const pad = make("g", { class: "pad", visibility: "hidden" }, live.svg);
  const sheet = make("rect", { width: "100%", height: "100%" }, pad);
  const trace = make("path", {}, pad);
  const draw = (number) => {
    live.pause();
    wanted = number;
    pad.setAttribute("visibility", "visible");
    trace.setAttribute("d", "");
    say("Draw an outline in one stroke; it closes where you lift.");
  };
  sheet.addEventListener("touchstart", (event) => event.preventDefault(), { passive: false });
  sheet.addEventListener("pointerdown", (event) => {
    sheet.setPointerCapture(event.pointerId);
    const box = live.svg.getBoundingClientRect();
    const points = [];
    const follow = (later) => {
      points.push([later.clientX - box.left, later.clientY - box.top]);
      trace.setAttribute("d", `M${points.map((p) => p.join(" ")).join("L")}`);
    };
    follow(event);
    sheet.addEventListener("pointermove", follow);
    sheet.addEventListener("pointerup", () => {
      sheet.removeEventListener("pointermove", follow);
      pad.setAttribute("visibility", "hidden");
      use(wanted, wanted === 0 ? "A" : "B", points.map((p) => live.drawing.map.from(p)));
    }, { once: true });
  });

  // The first closed line of a drawing, as the browser sees it.
  const dropped = (number, name, text) => {
    const drawing = new DOMParser().parseFromString(text, "image/svg+xml");
    if (drawing.querySelector("parsererror")) return say(`${name} is no SVG that can be read; choose another file.`);
    const one = drawing.querySelector("path, polygon, circle, ellipse, rect");
    if (!one) return say(`${name} has no path; choose a drawing with one.`);
    const copy = make(one.localName, {}, make("g", { visibility: "hidden" }, live.svg));
    for (const { name: key, value } of one.attributes)
      if (/^(d|points|c[xy]|r[xy]?|[xy]|width|height)$/.test(key)) copy.setAttribute(key, value);
    try {
      // The first subpath alone: its length is where the second one begins.
      if (copy.hasAttribute("d")) copy.setAttribute("d", copy.getAttribute("d").replace(/(.[^Mm]*)[Mm][^]*$/, "$1"));
      const length = copy.getTotalLength();
      if (!(length > 0)) return say(`The first path of ${name} has no length; choose another drawing.`);
      const points = Array.from({ length: 480 }, (_, i) => copy.getPointAtLength((length * i) / 480)).map(({ x, y }) => [x, -y]);
      use(number, name.replace(/\.svgz?$/i, ""), points);
    } finally {
      copy.parentNode.remove();
    }
  };
  const read = async (number, file) => {
    if (file.size > 4e6) return say(`${file.name} is larger than 4 MB; choose a simpler drawing.`);
    dropped(number, file.name, await file.text());
  };
  const target = (x) => (live.drawing.map.from([x - live.svg.getBoundingClientRect().left, 0])[0] < 0 ? 0 : 1);
  root.addEventListener("dragover", (event) => event.preventDefault());
  root.addEventListener("drop", (event) => {
    event.preventDefault();
    if (event.dataTransfer.files.length > 0) read(target(event.clientX), event.dataTransfer.files[0]);
  });
  for (const number of [0, 1]) {
    root.querySelector(`.draw-${number}`).addEventListener("click", () => draw(number));
    root.querySelector(`.open-${number}`).addEventListener("change", (event) => {
      if (event.target.files.length > 0) read(number, event.target.files[0]);
      event.target.value = "";
    });
  }
  root.querySelector(".depth").addEventListener("input", () => {
    root.querySelector(".depth-value").textContent = root.querySelector(".depth").value;
    again();
  });

  // The scene as lodlab reads it: drawings, and a file that names them.
  root.querySelector(".save-scene").addEventListener("click", () => {
    const files = outlines.map((outline, i) => {
      const corners = outline.points.map((number, k) => (k % 2 ? -number : number).toFixed(6));
      const xs = corners.filter((_, k) => k % 2 === 0).map(Number);
      const ys = corners.filter((_, k) => k % 2 === 1).map(Number);
      const box = [Math.min(...xs), Math.min(...ys), Math.max(...xs) - Math.min(...xs), Math.max(...ys) - Math.min(...ys)];
      return [`body_${"ab"[i]}.svg`, `<svg xmlns="http://www.w3.org/2000/svg" viewBox="${box.map((x) => x.toFixed(6)).join(" ")}"><path d="M${corners.join(" ")}z"/></svg>\n`];
    });
    let toml = `# Made by lodlab's playground.\nname = "playground"\ndepth = ${root.querySelector(".depth").value}\nduration = 4\n`;
    live.state.bodies.forEach((body, i) => {
      toml += `\n[[body]]\nname = "${"AB"[i]}"\nshape = "${files[i][0]}"\nsize = 1\nposition = [${body.x}, ${body.y}]\nangle = ${(180 / Math.PI) * body.angle}\nvelocity = [${[0.6, -0.6][i]}, 0]\n`;
    });
    for (const [name, text] of [["playground.toml", toml], ...files]) live.save(name, new Blob([text]));
    say("Saved: playground.toml and a drawing for each body; keep them in one folder.");
  });
};

document.querySelector(".live").addEventListener("alive", (event) => lodlabPlayground(event.detail));
