// A scene that the reader plays with: the module (live/module.hpp) computes, figure.js draws, the controls of controls.js
// say what happens. A root element holds .picture with the stage, .controls, .finding, .spoken and .trouble.
"use strict";

const lodlabLive = (() => {
  const { Drawing, make, set } = lodlabFigure;
  const mostSteps = 24; // frames of the scene between two of the screen
  const inMetres = (length) =>
    length >= 0.1 ? `${length.toPrecision(2)} m` : length >= 0.001 ? `${(100 * length).toPrecision(2)} cm` : `${(1000 * length).toPrecision(2)} mm`;
  const whole = (number) => Math.round(number).toLocaleString("en").replaceAll(",", "\u2009");
  const counted = (count, noun) => `${whole(count)} ${noun}${count === 1 ? "" : "s"}`;

  // The functions of the module, under the names of live/module.hpp.
  const callsOf = (module) => {
    const wrap = (name, gives, takes) => module.cwrap(`lodlab_live_${name}`, gives, takes);
    // A scene is too long for the module's stack, on which cwrap would put it.
    const long = (call, text) => {
      const bytes = module.lengthBytesUTF8(text) + 1;
      const place = module._malloc(bytes);
      module.stringToUTF8(text, place, bytes);
      const live = call(place);
      module._free(place);
      return live;
    };
    return {
      open: (scene) => long(module._lodlab_live_open, scene),
      draw: (outlines) => long(module._lodlab_live_draw, outlines),
      close: wrap("close", null, ["number"]),
      error: wrap("error", "string", []),
      figure: wrap("figure", "string", ["number"]),
      state: wrap("state", "string", ["number"]),
      step: wrap("step", "number", ["number", "number"]),
      reset: wrap("reset", "number", ["number"]),
      place: wrap("place", "number", ["number", "number", "number", "number", "number"]),
      fixate: wrap("fixate", "number", ["number", "number", "number"]),
      set: wrap("set", "number", ["number", "string", "number"]),
      choose: wrap("choose", "number", ["number", "string", "string"]),
    };
  };

  class Live {
    constructor(root, module, scene, controls) {
      this.root = root;
      this.calls = callsOf(module);
      this.scene = JSON.parse(scene);
      this.live = this.calls.open(scene);
      if (!this.live) throw new Error(this.calls.error());
      lodlabControls.put(this.find(".controls"), controls);
      this.playing = false;
      this.speed = 1;
      this.owed = 0;
      this.selected = -1;
      this.svg = this.find("svg.stage");
      this.drawing = new Drawing(this.svg);
      this.handles = make("g", { class: "handles" }, this.svg);
      this.addControls();
      this.addHandles();
      new ResizeObserver(() => { this.drawing.resize(); this.show(); }).observe(this.svg);
      this.show();
    }

    find(selector) { return this.root.querySelector(selector); }

    told(code) {
      if (code === 0) return true;
      this.pause();
      this.find(".finding").textContent = this.calls.error();
      return false;
    }

    // --- controls

    addControls() {
      this.state = JSON.parse(this.calls.state(this.live));
      const on = (selector, event, work) => this.find(selector)?.addEventListener(event, work);
      on(".play", "click", () => (this.playing ? this.pause() : this.play()));
      on(".step", "click", () => { this.pause(); this.step(1); });
      on(".reset", "click", () => { this.pause(); this.told(this.calls.reset(this.live)); this.show(); this.say(); });
      on(".speed", "change", (event) => { this.speed = Number(event.target.value); });
      this.offer(".level", { max: this.state.levels - 1, value: Math.min(this.state.level, this.state.levels - 1) });
      on(".level", "input", (event) => this.change("level", Number(event.target.value)));
      this.addBudget();
      this.offer(".restitution", { value: Math.min(...this.scene.bodies.map((body) => body.restitution)) });
      on(".restitution", "input", (event) => this.change("restitution", Number(event.target.value)));
      this.offer(".reserve", { value: this.scene.pair_cost });
      on(".reserve", "input", (event) => this.change("pair_cost", Number(event.target.value)));
      on(".save-svg", "click", () => this.save(`${this.scene.name}.svg`, new Blob([this.svgText()], { type: "image/svg+xml" })));
      on(".save-png", "click", () => this.savePng());
      for (const what of ["policy", "contact_model", "response", "shown"]) {
        this.offer(`.${what}`, { value: this.state[what] ?? this.scene.shown ?? "near" });
        on(`.${what}`, "change", (event) => this.choose(what, event.target.value));
      }
    }

    // Sets what a control has, where there is such a control.
    offer(selector, properties) {
      const element = this.find(selector);
      if (element) for (const [name, value] of Object.entries(properties)) element[name] = value;
    }

    // The last place of the slider stands for no budget, the others for 0, 1, 2, 3, 5, ... node tests.
    addBudget() {
      const slider = this.find(".budget");
      if (!slider) return;
      this.budgets = [0];
      for (let tests = 1; tests < 20000; tests = Math.max(tests + 1, Math.round(tests * 1.3))) this.budgets.push(tests);
      if (this.state.budget !== null && !this.budgets.includes(this.state.budget)) {
        this.budgets.push(this.state.budget);
        this.budgets.sort((a, b) => a - b);
      }
      slider.max = this.budgets.length;
      slider.value = this.state.budget === null ? this.budgets.length : this.budgets.indexOf(this.state.budget);
      slider.addEventListener("input", () => this.change("budget", this.budgets[slider.value] ?? -1));
    }

    change(what, value) {
      if (this.told(this.calls.set(this.live, what, value))) this.show();
      this.say();
    }

    choose(what, name) {
      if (this.told(this.calls.choose(this.live, what, name))) this.show();
      this.say();
    }

    play() {
      this.playing = true;
      this.last = undefined;
      this.text(".play", "Pause");
      requestAnimationFrame((now) => this.turn(now));
    }

    pause() {
      this.playing = false;
      this.text(".play", "Play");
    }

    // One frame of the screen.
    turn(now) {
      if (!this.playing) return;
      const passed = this.last === undefined ? 1 / 60 : Math.min((now - this.last) / 1000, 0.1);
      this.last = now;
      this.owed += (this.speed * passed) / this.scene.settings.time_step;
      const steps = Math.min(Math.floor(this.owed), mostSteps);
      this.owed = Math.min(this.owed - steps, 1);
      if (!this.held) this.step(steps);
      requestAnimationFrame((later) => this.turn(later));
    }

    step(frames) {
      if (frames > 0 && this.told(this.calls.step(this.live, frames))) this.show();
    }

    // Another scene of as many bodies, of outlines, under what is set; gives why it was refused, or "".
    reopen(outlines) {
      const opened = this.calls.draw(outlines);
      if (!opened) return this.calls.error();
      this.pause();
      this.calls.close(this.live);
      this.live = opened;
      this.state = JSON.parse(this.calls.state(this.live));
      const level = this.find(".level");
      const wasLast = level.value === level.max;
      level.max = this.state.levels - 1;
      if (wasLast) level.value = level.max;
      this.calls.set(this.live, "level", Number(level.value));
      this.calls.set(this.live, "budget", this.budgets[this.find(".budget").value] ?? -1);
      this.calls.set(this.live, "pair_cost", Number(this.find(".reserve").value));
      this.calls.set(this.live, "restitution", Number(this.find(".restitution").value));
      for (const what of ["policy", "contact_model", "response", "shown"])
        this.calls.choose(this.live, what, this.find(`.${what}`).value);
      this.calls.fixate(this.live, ...this.fixation);
      const list = this.find(".levels");
      while (list.children.length > this.state.levels) list.lastChild.remove();
      this.show();
      return "";
    }

    // --- what is saved

    // The picture with its styles beside its elements, as other programs read it.
    svgText() {
      const copy = this.svg.cloneNode(true);
      const styled = ["fill", "fill-opacity", "fill-rule", "stroke", "stroke-width", "stroke-opacity", "stroke-dasharray",
        "stroke-linejoin", "stroke-linecap", "paint-order", "font-family", "font-size", "font-weight", "visibility"];
      const originals = this.svg.querySelectorAll("path, text");
      copy.querySelectorAll("path, text").forEach((element, i) => {
        const style = getComputedStyle(originals[i]);
        for (const name of styled) element.setAttribute(name, style.getPropertyValue(name));
      });
      for (const element of copy.querySelectorAll(".handles, .pad")) element.remove();
      copy.setAttribute("xmlns", "http://www.w3.org/2000/svg");
      copy.setAttribute("width", this.drawing.width);
      copy.setAttribute("height", this.drawing.height);
      copy.style.background = getComputedStyle(this.svg).backgroundColor;
      return new XMLSerializer().serializeToString(copy);
    }

    savePng() {
      const image = new Image();
      image.onload = () => {
        const canvas = document.createElement("canvas");
        canvas.width = 2 * this.drawing.width;
        canvas.height = 2 * this.drawing.height;
        canvas.getContext("2d").drawImage(image, 0, 0, canvas.width, canvas.height);
        canvas.toBlob((blob) => this.save(`${this.scene.name}.png`, blob));
      };
      image.src = `data:image/svg+xml;charset=utf-8,${encodeURIComponent(this.svgText())}`;
    }

    save(name, blob) {
      const link = document.createElement("a");
      link.href = URL.createObjectURL(blob);
      link.download = name;
      link.click();
      setTimeout(() => URL.revokeObjectURL(link.href), 10000);
    }

    // --- bodies that are dragged and turned

    addHandles() {
      this.bodies = this.state.bodies.map((body, number) => {
        if (body.fixed) return null;
        const handle = make("circle", {
          class: "handle", tabindex: 0, role: "button",
          "aria-label": `${body.name}: arrow keys move it, comma and full stop turn it`,
        }, this.handles);
        handle.addEventListener("pointerdown", (event) => this.grip(event, number, "move"));
        // Browsers scroll by a finger on a part of an SVG whatever its touch-action says.
        handle.addEventListener("touchstart", (event) => event.preventDefault(), { passive: false });
        handle.addEventListener("keydown", (event) => this.key(event, number));
        handle.addEventListener("focus", () => { this.selected = number; this.showHandles(); });
        return handle;
      });
      this.turner = make("circle", { class: "turner", r: 9 }, this.handles);
      this.arm = make("path", { class: "arm" }, this.handles);
      this.handles.prepend(this.arm);
      this.turner.addEventListener("touchstart", (event) => event.preventDefault(), { passive: false });
      this.turner.addEventListener("pointerdown", (event) => this.grip(event, this.selected, "turn"));
      this.eye = make("circle", { class: "handle eye", r: 22, tabindex: 0, role: "button", "aria-label": "The point looked at: arrow keys move it" }, this.handles);
      this.eye.addEventListener("pointerdown", (event) => this.grip(event, -1, "look"));
      this.eye.addEventListener("touchstart", (event) => event.preventDefault(), { passive: false });
      this.eye.addEventListener("keydown", (event) => this.key(event, -1));
      this.fixation = this.scene.fixation.slice(0, 2);
    }

    pointer(event) {
      const box = this.svg.getBoundingClientRect();
      return this.drawing.map.from([event.clientX - box.left, event.clientY - box.top]);
    }

    grip(event, number, how) {
      event.preventDefault();
      const target = event.currentTarget;
      target.focus?.();
      target.setPointerCapture(event.pointerId);
      if (number >= 0) this.selected = number;
      const body = this.state.bodies[number] ?? { x: this.fixation[0], y: this.fixation[1], angle: 0 };
      const from = this.pointer(event);
      const begin = { x: body.x, y: body.y, angle: body.angle };
      const first = Math.atan2(from[1] - body.y, from[0] - body.x);
      this.held = true;
      const follow = (later) => {
        const [x, y] = this.pointer(later);
        if (how === "look") this.lookAt([begin.x + x - from[0], begin.y + y - from[1]]);
        else if (how === "move") this.place(number, begin.x + x - from[0], begin.y + y - from[1], begin.angle);
        else this.place(number, begin.x, begin.y, begin.angle + Math.atan2(y - begin.y, x - begin.x) - first);
      };
      const release = () => {
        this.held = false;
        target.removeEventListener("pointermove", follow);
        this.say();
      };
      target.addEventListener("pointermove", follow);
      target.addEventListener("pointerup", release, { once: true });
      target.addEventListener("pointercancel", release, { once: true });
    }

    key(event, number) {
      if (event.ctrlKey || event.altKey || event.metaKey) return;
      const [lowX, , highX] = this.scene.view;
      const stride = (event.shiftKey ? 0.001 : 0.01) * (highX - lowX);
      const ways = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };
      const turns = { ",": 1, ".": -1, "<": 0.1, ">": -0.1 };
      const way = ways[event.key];
      const turn = turns[event.key];
      if (!way && !(turn && number >= 0)) return;
      event.preventDefault();
      const [a, b] = way ?? [0, 0];
      if (number < 0) this.lookAt([this.fixation[0] + stride * a, this.fixation[1] + stride * b]);
      else {
        const body = this.state.bodies[number];
        this.place(number, body.x + stride * a, body.y + stride * b, body.angle + (turn ?? 0) * (Math.PI / 36));
      }
      this.say();
    }

    place(number, x, y, angle) {
      if (this.told(this.calls.place(this.live, number, x, y, angle))) this.show();
    }

    lookAt(point) {
      this.fixation = point;
      if (this.told(this.calls.fixate(this.live, ...point))) this.show();
    }

    // --- what is shown

    show() {
      const figure = this.calls.figure(this.live);
      if (!figure) return void this.told(-1);
      this.figure = JSON.parse(figure);
      this.state = JSON.parse(this.calls.state(this.live));
      this.drawing.draw(this.figure);
      this.showHandles();
      this.showScaleBar();
      this.showNumbers();
    }

    showHandles() {
      const { map } = this.drawing;
      if (!map) return;
      this.state.bodies.forEach((body, number) => {
        if (!this.bodies[number]) return;
        const [cx, cy] = map.at([body.x, body.y]);
        const reach = Math.max(22, 0.75 * body.reach * map.scale);
        set(this.bodies[number], { cx, cy, r: reach, class: number === this.selected ? "handle selected" : "handle" });
      });
      const body = this.state.bodies[this.selected];
      set(this.turner, { visibility: body ? "visible" : "hidden" });
      set(this.arm, { visibility: body ? "visible" : "hidden" });
      if (body) {
        const [x, y] = map.at([body.x, body.y]);
        const reach = Math.max(22, 0.75 * body.reach * map.scale);
        const far = Math.max(reach, body.reach * map.scale) + 18;
        const [a, b] = [Math.cos(body.angle), -Math.sin(body.angle)];
        set(this.turner, { cx: x + far * a, cy: y + far * b });
        set(this.arm, { d: `M${x + reach * a} ${y + reach * b}L${x + (far - 9) * a} ${y + (far - 9) * b}` });
      }
      const looks = this.state.policy === "perceptual";
      set(this.eye, { visibility: looks ? "visible" : "hidden" });
      if (looks) {
        const [cx, cy] = map.at(this.fixation);
        set(this.eye, { cx, cy });
      }
    }

    showScaleBar() {
      const { map, height } = this.drawing;
      if (this.barScale === map.scale && this.barHeight === height) return;
      [this.barScale, this.barHeight] = [map.scale, height];
      const wanted = 90 / map.scale;
      const decade = 10 ** Math.floor(Math.log10(wanted));
      const length = decade * (wanted >= 5 * decade ? 5 : wanted >= 2 * decade ? 2 : 1);
      this.bar ??= make("path", { class: "bar" }, this.svg);
      this.barWords ??= make("text", { class: "bar-words" }, this.svg);
      const [x, y] = [14, height - 14];
      set(this.bar, { d: `M${x} ${y - 5}V${y}H${x + length * map.scale}V${y - 5}` });
      set(this.barWords, { x, y: y - 10 });
      this.barWords.textContent = length >= 1 ? `${length} m` : length >= 0.01 ? `${Math.round(100 * length)} cm` : `${Math.round(1000 * length)} mm`;
    }

    text(selector, words) {
      const element = this.find(selector);
      if (element && element.textContent !== words) element.textContent = words;
    }

    showNumbers() {
      const { state } = this;
      this.text(".finding", this.figure.caption);
      this.text(".time", `${state.time.toFixed(2)} s`);
      this.text(".frames", counted(state.frame, "frame"));
      this.text(".contacts", whole(state.contacts));
      this.text(".energy", `${state.energy.toPrecision(3)} J`);
      this.text(".hash", state.hash);
      this.text(".level-value", state.level >= state.levels - 1 ? "the leaves" : `level ${state.level}`);
      this.text(".budget-value", state.budget === null ? "no limit" : counted(state.budget, "test"));
      this.text(".restitution-value", Number(this.find(".restitution")?.value).toFixed(2));
      this.text(".reserve-value", counted(Number(this.find(".reserve")?.value), "test"));
      this.offer(".reserve-row", { hidden: state.budget === null });
      this.showBudgetBar();
      this.showLevels();
      this.showEquation();
      this.showPairs();
    }

    showBudgetBar() {
      const { state } = this;
      if (!this.find(".quota")) return;
      this.find(".quota").style.visibility = state.budget === null ? "hidden" : "visible";
      const whole_ = Math.max(1, state.budget ?? state.tests, state.tests + state.reserved);
      this.find(".spent").style.width = `${(100 * (state.tests - state.dropped)) / whole_}%`;
      this.find(".dropped").style.width = `${(100 * state.dropped) / whole_}%`;
      this.find(".reserved").style.width = `${(100 * state.reserved) / whole_}%`;
      let words = counted(state.tests, "node test");
      if (state.budget !== null) words += ` of ${whole(state.budget)}`;
      if (state.reserved > 0) words += `, ${whole(state.reserved)} reserved`;
      if (state.dropped > 0) words += `, ${whole(state.dropped)} thrown away with unfinished levels`;
      if (state.interrupted) words += ": the budget ended first";
      this.text(".spending", words);
    }

    showLevels() {
      const list = this.find(".levels");
      if (!list) return;
      const most = Math.max(1, ...this.state.by_level);
      while (list.children.length < this.state.levels) {
        const row = document.createElement("li");
        row.innerHTML = '<span class="which"></span><span class="track"><span></span></span><span class="many"></span>';
        list.append(row);
      }
      [...list.children].forEach((row, level) => {
        const tests = this.state.by_level[level] ?? 0;
        const [which, track, many] = row.children;
        if (!which.textContent) which.textContent = `Level ${level}`;
        track.firstChild.style.width = `${(100 * tests) / most}%`;
        const words = whole(tests);
        if (many.textContent !== words) many.textContent = words;
      });
    }

    // Equation (1) at the deepest contact, term by term.
    showEquation() {
      const list = this.find(".equation");
      if (!list) return;
      const { contact } = this.state;
      const digits = (number) => number.toFixed(3).replace("-", "\u2212");
      const rows = contact === null ? [["No contact", ""]] : [
        ["<var>v</var><sub>c</sub>", `${digits(contact.closing)} m/s`],
        ["<var>K</var>", `${digits(contact.K)} 1/kg`],
        ["<var>e</var>", contact.e.toFixed(2)],
        ["<var>j</var> = \u2212(1 + <var>e</var>) <var>v</var><sub>c</sub> / <var>K</var>",
          contact.closing >= 0 ? "0, they part" : `${digits(contact.j)} N s`],
      ];
      const html = rows.map(([told, value]) => `<div><dt>${told}</dt><dd>${value}</dd></div>`).join("");
      if (this.equation === html) return;
      this.equation = html;
      list.innerHTML = html;
    }

    showPairs() {
      const table = this.find(".pairs");
      if (!table || table.closest("details")?.open === false) return;
      const answers = this.scene.told !== "verdicts";
      for (const head of table.querySelectorAll(".of-answers")) head.hidden = !answers;
      const name = (number) => this.state.bodies[number].name;
      const rows = this.state.pairs.slice(0, 12).map((pair) => [
        `${name(pair.a)}, ${name(pair.b)}`, pair.level, pair.verdict,
        ...(answers ? [
          whole(pair.contacts),
          pair.gap === null ? "" : pair.gap === 0 ? "none" : inMetres(pair.gap),
          pair.verdict === "apart" ? "" : inMetres(pair.stands_out),
        ] : []),
      ]);
      const body = table.tBodies[0];
      while (body.rows.length > rows.length) body.deleteRow(-1);
      rows.forEach((cells, i) => {
        const row = body.rows[i] ?? body.insertRow();
        cells.forEach((cell, k) => {
          const place = row.cells[k] ?? row.insertCell();
          if (place.textContent !== String(cell)) place.textContent = cell;
        });
      });
    }

    // To readers of the screen, once the reader is done changing something.
    say() {
      clearTimeout(this.speech);
      this.speech = setTimeout(() => { this.find(".spoken").textContent = this.figure.caption; }, 400);
    }
  }

  // Takes the place of the still picture in a root element; `controls`: see controls.js. Gives a promise of what plays.
  const mount = async (root, { scene, module, controls = "" }) => {
    try {
      const ready = await module;
      root.classList.add("alive");
      root.live = new Live(root, ready, scene, controls);
      root.dispatchEvent(new CustomEvent("alive", { detail: root.live }));
      return root.live;
    } catch (error) {
      root.classList.remove("alive");
      root.querySelector(".trouble").textContent = `This scene does not run here: ${error.message}`;
      throw error;
    }
  };

  return { Live, mount };
})();
