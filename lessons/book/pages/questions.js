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

// Makes a form answer; `replied` is called after every word to the reader, `settled` whenever a question is answered
// rightly or passed.
const openQuestion = (form, lesson, { replied, settled }) => {
  const key = JSON.parse(form.querySelector(".key").textContent);
  const reply = form.querySelector(".reply");
  const fields = [...form.querySelectorAll("input")];
  const acts = form.querySelector(".acts");
  let state = Answers.of(lesson, form.dataset.name);

  const answer = () => (key.choices ? fields.find((field) => field.checked)?.value ?? "" : fields[0].value);
  const say = (kind, words, html = "") => {
    form.dataset.state = kind;
    reply.textContent = words + (words && html ? " " : "");
    if (html) reply.insertAdjacentHTML("beforeend", html);
  };
  const close = (quiet) => {
    fields.forEach((field) => { field.disabled = true; });
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
  acts.hidden = false;
  if (state.right || state.passed) {
    if (key.choices) fields.forEach((field) => { field.checked = field.value === state.answer; });
    else fields[0].value = state.answer;
    close(true);
  }
  return {
    form,
    isOpen: () => !state.right && !state.passed,
    ask: () => {
      if (!form.dataset.state) say("unclear", "Answer, or pass, to go on.");
      replied();
      fields[0].focus({ preventScroll: true });
    },
    again: () => {
      state = Answers.of(lesson, form.dataset.name);
      fields.forEach((field) => { field.disabled = field.checked = false; if (!key.choices) field.value = ""; });
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
