// What a live scene tells in numbers: the scale bar, the readings, the budget bar, tests of each level, equation (1), pairs.
"use strict";

// Methods of Live (live.js).
const lodlabNumbers = (() => {
  const { make, set } = lodlabFigure;
  const inMetres = (length) =>
    length >= 0.1 ? `${length.toPrecision(2)} m` : length >= 0.001 ? `${(100 * length).toPrecision(2)} cm` : `${(1000 * length).toPrecision(2)} mm`;
  const whole = (number) => Math.round(number).toLocaleString("en").replaceAll(",", "\u2009");
  const counted = (count, noun) => `${whole(count)} ${noun}${count === 1 ? "" : "s"}`;

  return {
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
    },

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
    },

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
    },

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
    },

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
    },

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
    },
  };
})();
