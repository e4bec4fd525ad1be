// Draws a figure of one panel, as lodlab's JSON has it, into an SVG: lengths of the figure are scaled,
// lines and words keep their size. Neighbours of one style become one element, which is fast, and shows
// the inside of discs that overlap in one even tone.
"use strict";

const lodlabFigure = (() => {
  const namespace = "http://www.w3.org/2000/svg";
  const headLength = 11;
  const manyDiscs = 40; // of one style side by side: thinner lines

  const make = (name, attributes = {}, parent = null) => {
    const element = document.createElementNS(namespace, name);
    for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, value);
    if (parent) parent.append(element);
    return element;
  };

  // Sets what is another than before.
  const set = (element, attributes) => {
    const known = (element.known ??= {});
    for (const key in attributes) {
      if (known[key] === attributes[key]) continue;
      known[key] = attributes[key];
      element.setAttribute(key, attributes[key]);
    }
  };

  const short = (x) => Math.round(x * 100) / 100;

  // How metres lie on the page.
  class Mapping {
    constructor([lowX, lowY, highX, highY], width, height) {
      this.scale = Math.min(width / (highX - lowX), height / (highY - lowY));
      this.x = width / 2 - (this.scale * (lowX + highX)) / 2;
      this.y = height / 2 + (this.scale * (lowY + highY)) / 2;
    }
    at([x, y]) { return [this.x + this.scale * x, this.y - this.scale * y]; }
    from([x, y]) { return [(x - this.x) / this.scale, (this.y - y) / this.scale]; }
  }

  const circle = ([x, y], r) =>
    `M${short(x - r)} ${short(y)}a${short(r)} ${short(r)} 0 1 0 ${short(2 * r)} 0a${short(r)} ${short(r)} 0 1 0 ${short(-2 * r)} 0z`;

  const line = (points, map, close) => {
    let text = "";
    for (const point of points) {
      const [x, y] = map.at(point);
      text += `${text ? "L" : "M"}${short(x)} ${short(y)}`;
    }
    return close ? text + "z" : text;
  };

  const arrow = (mark, map) => {
    const [x, y] = map.at(mark.tail);
    const [u, v] = map.at(mark.tip);
    const length = Math.hypot(u - x, v - y);
    if (length < 2) return "";
    const head = Math.min(headLength, 0.6 * length);
    const [a, b] = [((u - x) / length) * head, ((v - y) / length) * head];
    return `M${short(x)} ${short(y)}L${short(u)} ${short(v)}M${short(u - a - 0.45 * b)} ${short(v - b + 0.45 * a)}` +
      `L${short(u)} ${short(v)}L${short(u - a + 0.45 * b)} ${short(v - b - 0.45 * a)}`;
  };

  const outlines = {
    disc: (mark, map) => {
      const r = mark.radius * map.scale;
      const inner = mark.role === "true_collision" && r > 11 ? circle(map.at(mark.centre), r - 4.5) : "";
      return circle(map.at(mark.centre), r) + inner;
    },
    dot: (mark, map) => circle(map.at(mark.at), 4.5 * (mark.size ?? 1)),
    path: (mark, map) => mark.rings.map((ring) => line(ring, map, true)).join(""),
    polyline: (mark, map) => line(mark.points, map, false),
    arrow,
  };

  const styleOf = (mark) => `${mark.mark} ${mark.role} body-${mark.body % 3}`;

  // Words to place: text, where they belong, how far away, and which way they would rather stand.
  const wordsOf = (mark, map) => {
    if (mark.mark === "label")
      return { text: mark.text, at: map.at(mark.anchor), away: (mark.clearance ?? 0) * map.scale };
    if (mark.mark === "arrow" && mark.label) {
      const [tail, tip] = [map.at(mark.tail), map.at(mark.tip)];
      return { text: mark.label, at: tip, away: 0, way: Math.atan2(tip[1] - tail[1], tip[0] - tail[0]) };
    }
    return null;
  };

  // Names before impulses before speeds: where there is no room, the last are left out.
  const rank = (mark) => (mark.mark === "label" ? 0 : mark.role === "velocity" ? 2 : 1);

  const overlap = (a, b) =>
    Math.max(0, Math.min(a.right, b.right) - Math.max(a.left, b.left)) *
    Math.max(0, Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top));

  class Drawing {
    constructor(svg) {
      this.svg = svg;
      this.marks = make("g", { class: "marks" }, svg);
      this.words = make("g", { class: "words" }, svg);
      this.ways = new Map(); // of each text: where it stood, so that words do not jump about
      this.pen = document.createElement("canvas").getContext("2d");
    }

    resize() {
      const box = this.svg.getBoundingClientRect();
      this.width = Math.max(1, box.width);
      this.height = Math.max(1, box.height);
      this.svg.setAttribute("viewBox", `0 0 ${this.width} ${this.height}`);
      this.font = getComputedStyle(this.svg);
      this.size = parseFloat(this.font.fontSize);
    }

    draw(figure) {
      if (!this.width) this.resize();
      const panel = figure.panels[0];
      this.map = new Mapping(panel.view, this.width, this.height);
      set(this.svg, { "aria-label": figure.alt });
      this.drawMarks(panel.marks);
      this.drawWords(panel.marks);
    }

    drawMarks(marks) {
      let next = this.marks.firstChild;
      for (let i = 0; i < marks.length; ) {
        const first = marks[i];
        const style = styleOf(first);
        let outline = "";
        let count = 0;
        let least = Infinity;
        for (; i < marks.length && styleOf(marks[i]) === style && marks[i].opacity === first.opacity; ++i) {
          outline += outlines[first.mark]?.(marks[i], this.map) ?? "";
          least = Math.min(least, marks[i].radius ?? Infinity);
          ++count;
          if (first.mark === "path") { ++i; break; } // each its own even-odd inside
        }
        if (!outline) continue;
        next ??= make("path", {}, this.marks);
        const many = first.mark === "disc" && (count > manyDiscs || least * this.map.scale < 9) ? " many" : "";
        set(next, { class: style + many, d: outline, opacity: first.opacity ?? 1 });
        next = next.nextSibling;
      }
      while (next) next = this.drop(next);
    }

    drop(element) {
      const next = element.nextSibling;
      element.remove();
      return next;
    }

    // Boxes that words had better not cover: along each arrow, round each dot; soft ones along the bodies' outlines.
    obstacles(marks) {
      const boxes = [];
      const add = ([x, y], half) => boxes.push({ left: x - half, right: x + half, top: y - half, bottom: y + half });
      for (const mark of marks) {
        if (mark.mark === "dot") add(this.map.at(mark.at), 6);
        if (mark.mark === "path" && mark.role === "body") for (const ring of mark.rings) this.addOutline(ring, boxes);
        if (mark.mark !== "arrow") continue;
        const [x, y] = this.map.at(mark.tail);
        const [u, v] = this.map.at(mark.tip);
        const parts = Math.min(12, Math.ceil(Math.hypot(u - x, v - y) / 8));
        for (let i = 0; i <= parts; ++i) add([x + ((u - x) * i) / parts, y + ((v - y) * i) / parts], 4);
      }
      return boxes;
    }

    addOutline(ring, boxes) {
      let [u, v] = this.map.at(ring.at(-1));
      for (const corner of ring) {
        const [x, y] = this.map.at(corner);
        const parts = Math.min(40, Math.ceil(Math.hypot(x - u, y - v) / 8));
        for (let i = 1; i <= parts; ++i) {
          const [p, q] = [u + ((x - u) * i) / parts, v + ((y - v) * i) / parts];
          boxes.push({ left: p - 4, right: p + 4, top: q - 4, bottom: q + 4, soft: true });
        }
        [u, v] = [x, y];
      }
    }

    drawWords(marks) {
      const worded = marks.filter((mark) => mark.mark === "label" || mark.label).sort((a, b) => rank(a) - rank(b));
      const taken = worded.length > 0 && marks.length < 400 ? this.obstacles(marks) : [];
      let next = this.words.firstChild;
      for (const mark of worded) {
        const words = wordsOf(mark, this.map);
        if (!words) continue;
        const place = this.place(words, taken);
        if (!place) continue;
        taken.push(place);
        next ??= make("text", {}, this.words);
        set(next, { class: styleOf(mark), x: short(place.left), y: short(place.bottom - 0.25 * this.size) });
        if (next.textContent !== words.text) next.textContent = words.text;
        next = next.nextSibling;
      }
      while (next) next = this.drop(next);
    }

    // The first place round the anchor, near or further away, that is free and within the picture; else the best one there
    // is, of a name wherever it is, of an arrow's words where next to nothing is covered.
    place(words, taken) {
      this.pen.font = `600 ${this.size}px ${this.font.fontFamily}`;
      const width = this.pen.measureText(words.text).width;
      const height = 1.15 * this.size;
      const [x, y] = words.at;
      const known = this.ways.get(words.text);
      const outward = words.way ?? Math.atan2(y - this.height / 2, x - this.width / 2);
      const spots = [9, 9 + 1.4 * height].flatMap((gap) => [0, 0.5, -0.5, 1, -1, 1.6, -1.6, 2.3, -2.3, 3.1].map((turn) => [gap, turn]));
      let best = null;
      for (const [gap, turn] of spots) {
        const way = (turn === 0 && known !== undefined && words.way === undefined ? known : outward + turn);
        const reach = words.away + gap;
        const middle = [x + Math.cos(way) * (reach + width / 2), y + Math.sin(way) * (reach + height / 2)];
        const box = { left: middle[0] - width / 2, right: middle[0] + width / 2, top: middle[1] - height / 2, bottom: middle[1] + height / 2 };
        const outside = width * height - overlap(box, { left: 2, top: 2, right: this.width - 2, bottom: this.height - 2 });
        let [cost, all] = [3 * outside, 3 * outside];
        for (const other of taken) {
          const covered = overlap(box, other);
          all += other.soft ? 0.5 * covered : covered;
          if (!other.soft) cost += covered;
        }
        if (best === null || all < best.all - 1) best = { ...box, cost, all, way };
        if (all < 1) break;
      }
      this.ways.set(words.text, best.way);
      return best.cost < (words.way === undefined ? 0.5 : 0.04) * width * height ? best : null;
    }
  }

  return { Drawing, make, set };
})();
