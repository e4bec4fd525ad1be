// Stepping inside a frame: its events one by one, forwards, backwards, and by the line that names it; by keys, too, where
// the stepper has the focus. The bodies stand still meanwhile; whatever moves them leaves the frame.
"use strict";

// Methods of Live (live.js).
const lodlabInside = (() => {
  const fewEvents = 12; // all groups of so many are open
  const ways = { ArrowLeft: "back", ArrowRight: "next", Home: "first", End: "last", Escape: "leave" };
  const hint = "What the next frame does, event by event, while the bodies stand still.";
  const nothing = "Nothing happens in the next frame: no two bodies are near.";
  const capital = (text) => text[0].toUpperCase() + text.slice(1);
  const plural = (count, kind) => `${count} ${kind}${count === 1 || !/^(level|contact|impulse|round)$/.test(kind) ? "" : "s"}`;

  return {
    addInside() {
      const root = this.find(".inside");
      if (!root) return;
      for (const way of Object.values(ways))
        root.querySelector(`.go-${way}`).addEventListener("click", () => this.look(way));
      root.addEventListener("keydown", (event) => {
        const way = ways[event.key];
        if (!way || event.ctrlKey || event.altKey || event.metaKey || event.shiftKey) return;
        event.preventDefault();
        event.stopPropagation(); // a lesson's page turns its steps by the same keys
        this.look(way);
      });
    },

    // Goes a way, or to the event of a number.
    look(way) {
      this.pause();
      this.events ??= JSON.parse(this.calls.events(this.live)).events;
      const last = this.events.length - 1;
      if (last < 0) return void this.text(".inside .now", nothing);
      const at = this.state.event;
      const places = { first: 0, back: at === null ? -1 : Math.max(at - 1, 0), next: Math.min((at ?? -1) + 1, last), last, leave: -1 };
      if (this.told(this.calls.set(this.live, "event", places[way] ?? way))) this.show();
      this.say();
    },

    showInside() {
      const root = this.find(".inside");
      if (!root) return;
      const { event } = this.state;
      if (event === null) this.events = null;
      const list = root.querySelector(".events");
      list.hidden = event === null;
      for (const [way, isIdle] of [["back", event === null || event === 0], ["leave", event === null],
        ["next", event !== null && event === this.events?.length - 1]])
        root.querySelector(`.go-${way}`).setAttribute("aria-disabled", isIdle);
      this.text(".inside .count", event === null ? "" : `${event + 1} of ${this.events.length}`);
      this.text(".inside .now", event === null ? hint : `${capital(this.events[event].sentence)}.`);
      if (event === null) return void (this.listed = null);
      if (this.listed !== this.events) this.listEvents(list);
      const group = this.groups.find(({ events }) => events.includes(event));
      group.details.open = true;
      this.fillGroup(group);
      this.markEvent(list, event);
    },

    // A group for the levels of each pair, for its contacts, for its impulses, and one for the rounds of the response, in
    // the order in which they begin.
    groupEvents() {
      const groups = new Map();
      this.events.forEach((event, number) => {
        const what = /^(level|dropped|skipped|exact)$/.test(event.kind) ? "levels" : event.kind;
        const key = what === "round" ? what : `${what} ${event.a} ${event.b}`;
        if (!groups.has(key)) groups.set(key, { who: event.kind === "round" ? "The response" : event.pair, events: [] });
        groups.get(key).events.push(number);
      });
      return [...groups.values()];
    },

    listEvents(list) {
      this.listed = this.events;
      list.textContent = "";
      this.groups = this.groupEvents();
      for (const group of this.groups) {
        const kinds = {};
        for (const number of group.events) kinds[this.events[number].kind] = (kinds[this.events[number].kind] ?? 0) + 1;
        group.details = document.createElement("details");
        const summary = document.createElement("summary");
        summary.textContent = `${group.who}: ${Object.entries(kinds).map(([kind, count]) => plural(count, kind)).join(", ")}`;
        group.details.append(summary);
        group.details.open = this.events.length <= fewEvents;
        group.details.addEventListener("toggle", () => { this.fillGroup(group); this.markEvent(list, this.state.event); });
        this.fillGroup(group);
        list.append(group.details);
      }
    },

    // The lines of a group that is open for the first time.
    fillGroup(group) {
      if (!group.details.open || group.lines) return;
      group.lines = document.createElement("ol");
      for (const number of group.events) {
        const { short, pair } = this.events[number];
        const line = document.createElement("li");
        const button = document.createElement("button");
        button.type = "button";
        button.dataset.event = number;
        button.innerHTML = '<span class="number"></span> <span class="what"></span>';
        button.firstChild.textContent = number + 1;
        button.lastChild.textContent = capital(short.replace(` of ${pair}:`, ":")); // the group says whose
        button.addEventListener("click", () => this.look(number));
        line.append(button);
        group.lines.append(line);
      }
      group.details.append(group.lines);
    },

    // The line of the present event, in view within its list.
    markEvent(list, event) {
      for (const button of list.querySelectorAll("[data-event]")) {
        const isPresent = Number(button.dataset.event) === event;
        if (!isPresent) { button.removeAttribute("aria-current"); continue; }
        button.setAttribute("aria-current", "step");
        const [box, line] = [list.getBoundingClientRect(), button.getBoundingClientRect()];
        if (line.top < box.top) list.scrollTop -= box.top - line.top;
        if (line.bottom > box.bottom) list.scrollTop += line.bottom - box.bottom;
      }
    },
  };
})();
