// A scene that the reader plays with: the module (live/module.hpp) computes, figure.js draws, the controls of controls.js
// say what happens. A root element holds .picture with the stage, .controls, .finding, .spoken and .trouble.
"use strict";

const lodlabLive = (() => {
  const { Drawing, make } = lodlabFigure;
  const mostSteps = 24; // frames of the scene between two of the screen

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
      events: wrap("events", "string", ["number"]),
      sources: () => (module._lodlab_live_sources ? module.cwrap("lodlab_live_sources", "string", [])() : ""),
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
      this.addInside();
      this.checkSources();
      new ResizeObserver(() => { this.drawing.resize(); this.show(); }).observe(this.svg);
      this.show();
    }

    // The module comes from another build, and may be older.
    checkSources() {
      if (this.calls.sources() === lodlabSources) return;
      const words = document.createElement("p");
      words.className = "quiet stale";
      words.textContent = "What runs here was made of other sources than this page: scripts/wasm makes it anew; then build lodlab again.";
      this.find(".controls").append(words);
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
      this.showInside();
    }

    text(selector, words) {
      const element = this.find(selector);
      if (element && element.textContent !== words) element.textContent = words;
    }

    // To readers of the screen, once the reader is done changing something.
    say() {
      clearTimeout(this.speech);
      this.speech = setTimeout(() => { this.find(".spoken").textContent = this.figure.caption; }, 400);
    }
  }

  Object.assign(Live.prototype, lodlabNumbers, lodlabHandles, lodlabInside);

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
