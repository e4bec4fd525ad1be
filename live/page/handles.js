// What a reader drags and turns in a live scene, by hand or by keys: the bodies, and the point looked at.
"use strict";

// Methods of Live (live.js).
const lodlabHandles = (() => {
  const { make, set } = lodlabFigure;
  return {
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
    },

    pointer(event) {
      const box = this.svg.getBoundingClientRect();
      return this.drawing.map.from([event.clientX - box.left, event.clientY - box.top]);
    },

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
    },

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
    },

    place(number, x, y, angle) {
      if (this.told(this.calls.place(this.live, number, x, y, angle))) this.show();
    },

    lookAt(point) {
      this.fixation = point;
      if (this.told(this.calls.fixate(this.live, ...point))) this.show();
    },

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
    },
  };
})();
