// The questions of a lesson: answered or passed on this page, and kept in this browser alone.
"use strict";

const Answers = (() => {
  const storageKey = "lodlab-book";
  let kept = {};  // lesson -> question -> { mistakes, right, passed, answer }
  try {
    const read = JSON.parse(localStorage.getItem(storageKey));
    if (read && typeof read === "object") kept = read;
  } catch { /* no storage, or not ours: answers last as long as the page */ }
  const keep = () => {
    try { localStorage.setItem(storageKey, JSON.stringify(kept)); } catch { /* as above */ }
  };

  const of = (lesson, question) => {
    const found = kept[lesson]?.[question];
    return { mistakes: 0, right: false, passed: false, answer: "", ...(typeof found === "object" ? found : {}) };
  };
  const put = (lesson, question, state) => {
    if (typeof kept[lesson] !== "object") kept[lesson] = {};
    kept[lesson][question] = state;
    keep();
  };
  const forget = (lesson) => { delete kept[lesson]; keep(); };

  // "Of 6 questions: 3 right at the first try, 1 after a mistake, 2 passed." Empty before the first answer.
  const summary = (lesson, questions) => {
    const states = Object.values(kept[lesson] ?? {}).filter((s) => s && (s.right || s.passed));
    if (states.length === 0 || questions === 0) return "";
    const right = states.filter((s) => s.right);
    const parts = [
      [right.filter((s) => !s.mistakes).length, "right at the first try"],
      [right.filter((s) => s.mistakes > 0).length, "after a mistake"],
      [states.filter((s) => !s.right).length, "passed"],
      [Math.max(0, questions - states.length), "open"],
    ];
    return `Of ${questions} questions: ` +
      parts.filter(([count]) => count > 0).map(([count, what]) => `${count} ${what}`).join(", ") + ".";
  };
  return { of, put, forget, summary };
})();

// What a question's reader picks in the picture of its step: round marks that are there or not.
const Picks = (form) => {
  const sheet = document.querySelector(`svg.picks[data-question=${form.id}]`);
  const marks = [...sheet.querySelectorAll(".pick")];
  const told = form.querySelector(".picked output");
  const inOrder = () => marks.filter((mark) => mark.getAttribute("aria-checked") === "true")
    .map((mark) => mark.dataset.name).sort((a, b) => a.localeCompare(b, "en", { numeric: true }));
  const tell = () => { told.textContent = inOrder().join(", ") || "none"; };
  const toggle = (mark) => {
    if (mark.getAttribute("aria-disabled") === "true") return;
    mark.setAttribute("aria-checked", String(mark.getAttribute("aria-checked") !== "true"));
    tell();
  };
  for (const mark of marks) {
    mark.addEventListener("click", () => toggle(mark));
    mark.addEventListener("keydown", (event) => {
      if (event.key !== "Enter" && event.key !== " ") return;
      event.preventDefault();
      toggle(mark);
    });
  }
  const setAll = (name, value) => { for (const mark of marks) mark.setAttribute(name, value); };
  return {
    names: () => inOrder().join(" "),
    first: () => marks[0],
    pick: (names) => { for (const mark of marks) mark.setAttribute("aria-checked", String(names.split(" ").includes(mark.dataset.name))); tell(); },
    open: () => { sheet.removeAttribute("hidden"); form.querySelector(".picked").hidden = false; setAll("aria-disabled", "false"); setAll("aria-checked", "false"); tell(); },
    close: () => setAll("aria-disabled", "true"),
  };
};

// Makes a form answer; `replied` is called after every word to the reader, `settled` whenever a question is answered
// rightly or passed.
const openQuestion = (form, lesson, { replied, settled }) => {
  const key = JSON.parse(form.querySelector(".key").textContent);
  const reply = form.querySelector(".reply");
  const fields = [...form.querySelectorAll("input")];
  const acts = form.querySelector(".acts");
  const pickable = key.picks && Picks(form);
  let state = Answers.of(lesson, form.dataset.name);

  const answer = () => pickable?.names() ?? (key.choices ? fields.find((field) => field.checked)?.value ?? "" : fields[0].value);
  const say = (kind, words, html = "") => {
    form.dataset.state = kind;
    reply.textContent = words + (words && html ? " " : "");
    if (html) reply.insertAdjacentHTML("beforeend", html);
  };
  const close = (quiet) => {
    fields.forEach((field) => { field.disabled = true; });
    pickable?.close();
    acts.hidden = true;
    if (state.right) say("right", "Right.", Grade.grade(key, state.answer).reply);
    else say("passed", "Passed: a later step tells the answer.");
    if (quiet) return;
    replied();
    settled();
  };
  const put = () => Answers.put(lesson, form.dataset.name, state);

  form.addEventListener("submit", (event) => {
    event.preventDefault();
    const graded = Grade.grade(key, answer());
    if (graded.grade === "unclear") {
      say("unclear", graded.reply);
      return replied();
    }
    state.answer = answer();
    if (graded.grade === "right") {
      state.right = true;
      put();
      return close(false);
    }
    ++state.mistakes;
    put();
    if (graded.reply) say("wrong", "", `${graded.reply} <em>Try again, or pass.</em>`);
    else say("wrong", "Not that. Try again, or pass.");
    replied();
  });
  form.querySelector(".pass").addEventListener("click", () => {
    state.passed = true;
    put();
    close(false);
  });

  fields.forEach((field) => { field.hidden = false; });
  form.querySelector(".typed")?.removeAttribute("hidden");
  pickable?.open();
  acts.hidden = false;
  if (state.right || state.passed) {
    if (pickable) pickable.pick(state.answer);
    else if (key.choices) fields.forEach((field) => { field.checked = field.value === state.answer; });
    else fields[0].value = state.answer;
    close(true);
  }
  return {
    form,
    isOpen: () => !state.right && !state.passed,
    ask: () => {
      if (!form.dataset.state) say("unclear", "Answer, or pass, to go on.");
      replied();
      (pickable ? pickable.first() : fields[0]).focus({ preventScroll: true });
    },
    again: () => {
      state = Answers.of(lesson, form.dataset.name);
      fields.forEach((field) => { field.disabled = field.checked = false; if (!key.choices) field.value = ""; });
      pickable?.open();
      acts.hidden = false;
      delete form.dataset.state;
      reply.textContent = "";
    },
  };
};

// The line below a lesson, or beside it on the index.
const showTally = (line, again) => {
  const { lesson, questions } = line.dataset;
  line.textContent = Answers.summary(lesson, Number(questions));
  line.hidden = line.textContent === "";
  if (line.hidden || !again) return;
  const button = document.createElement("button");
  button.type = "button";
  button.textContent = "Begin again";
  button.addEventListener("click", again);
  line.append(" ", button);
};
