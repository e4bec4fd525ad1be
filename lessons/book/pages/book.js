// The stage of a lesson: one step at a time, its questions before the next one. Without this file every step is
// shown, one after another.
"use strict";

for (const section of document.querySelectorAll("section.steps")) {
  const steps = [...section.querySelectorAll("article.step")];
  const scrubber = section.querySelector(".scrubber");
  const slider = scrubber.querySelector("input");
  const back = scrubber.querySelector(".back");
  const next = scrubber.querySelector(".next");
  const count = scrubber.querySelector("output");
  const spoken = section.querySelector(".spoken");
  const tally = document.querySelector(".tally");
  const lesson = tally.dataset.lesson;
  let shown = 0;

  // A reply may take the room that the words had.
  const replied = () => {
    if (!step().classList.contains("split")) split(true);
  };
  const settled = () => {
    refresh();
    const left = firstOpen(shown);
    if (left && !isAsking()) left.ask();
    else next.focus({ preventScroll: true });
  };
  const questions = steps.map((step) =>
    [...step.querySelectorAll("form.question")].map((form) => openQuestion(form, lesson, { replied, settled })));
  const firstOpen = (number) => questions[number - 1].find((question) => question.isOpen());
  const isBlocked = (number) => firstOpen(number) !== undefined;
  const step = () => steps[shown - 1];
  const hasQuestions = () => questions[shown - 1].length > 0;
  const isAsking = () => step().classList.contains("asking");

  const refresh = () => {
    showTally(tally, beginAgain);
    // A button that ends is not disabled: the focus would be lost with it.
    back.setAttribute("aria-disabled", String(shown === 1 && !isAsking()));
    next.setAttribute("aria-disabled", String(shown === steps.length && !isBlocked(shown)));
    next.classList.toggle("blocked", isBlocked(shown));
  };
  const beginAgain = () => {
    Answers.forget(lesson);
    questions.flat().forEach((question) => question.again());
    show(1);
    section.scrollIntoView();
    next.focus({ preventScroll: true });
  };

  // A step that does not fit the window with its questions shows first the one, then the others, one by one.
  const split = (asking) => {
    step().classList.remove("split", "asking");
    for (const { form } of questions[shown - 1]) form.classList.remove("later");
    if (!hasQuestions()) return;
    const room = innerHeight - scrubber.offsetHeight;
    if (step().offsetHeight <= room) return;
    step().classList.add("split");
    step().classList.toggle("asking", asking);
    const now = firstOpen(shown) ?? questions[shown - 1].at(-1);
    for (const { form } of questions[shown - 1]) form.classList.toggle("later", form !== now.form);
  };

  const keepInView = () => {
    const { top, bottom } = section.getBoundingClientRect();
    if (top < 0 || bottom > innerHeight) section.scrollIntoView();
  };

  const show = (number, { speak = true, asking = false } = {}) => {
    const wanted = Math.min(Math.max(number, 1), steps.length);
    if (wanted !== shown) {
      shown = wanted;
      steps.forEach((one, i) => one.classList.toggle("away", i + 1 !== shown));
      const title = step().querySelector("h3").lastChild.textContent.trim();
      slider.value = String(shown);
      slider.setAttribute("aria-valuetext", `Step ${shown} of ${steps.length}: ${title}`);
      count.textContent = `${shown} / ${steps.length}`;
      if (speak) spoken.textContent = `Step ${shown} of ${steps.length}: ${title}`;
      if (speak) history.replaceState(null, "", `#step-${shown}`);
      // The neighbours' pictures are fetched now, so that stepping does not flicker.
      for (const near of [steps[shown - 2], steps[shown]])
        near?.querySelector("img")?.setAttribute("loading", "eager");
    }
    split(asking);
    refresh();
    if (speak) keepInView();
  };

  // Forwards as far as the questions let, and to the question that does not.
  const advance = (number) => {
    const wanted = Math.min(number, steps.length);
    for (let on = shown; on < wanted; ++on) {
      if (!isBlocked(on)) continue;
      show(on, { asking: true });
      return firstOpen(on).ask();
    }
    show(wanted);
  };
  const retreat = () => {
    if (isAsking()) return show(shown, { asking: false });
    show(shown - 1);
  };

  const fromHash = () => {
    const named = /^#step-(\d+)$/.exec(location.hash);
    if (named) show(Number(named[1]), { speak: false });
    return named !== null;
  };

  back.addEventListener("click", retreat);
  next.addEventListener("click", () => advance(shown + 1));
  slider.addEventListener("input", () => {
    const wanted = Number(slider.value);
    if (wanted > shown) advance(wanted);
    else show(wanted);
    slider.value = String(shown);
  });
  addEventListener("hashchange", fromHash);
  addEventListener("resize", () => split(isAsking()));

  const isOnScreen = () => {
    const { top, bottom } = section.getBoundingClientRect();
    return top < innerHeight / 2 && bottom > innerHeight / 2;
  };
  addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.altKey || event.metaKey || event.shiftKey) return;
    const target = event.target;
    if (target.closest("video, pre, textarea, input:not([type=range])")) return;
    const inSteps = section.contains(target);
    if (!inSteps && (target !== document.body || !isOnScreen())) return;
    if (event.key === "ArrowRight") advance(shown + 1);
    else if (event.key === "ArrowLeft") retreat();
    else if (event.key === "Home" && inSteps) show(1);
    else if (event.key === "End" && inSteps) advance(steps.length);
    else return;
    event.preventDefault();
  });

  // A swipe over the picture turns the page.
  let start = null;
  section.addEventListener("touchstart", (event) => {
    const figure = event.target.closest("figure");
    const strip = figure?.querySelector(".strip");
    const scrolls = strip && strip.scrollWidth > strip.clientWidth;
    start = event.touches.length === 1 && figure && !scrolls ? event.touches[0] : null;
  }, { passive: true });
  section.addEventListener("touchend", (event) => {
    if (!start) return;
    const dx = event.changedTouches[0].clientX - start.clientX;
    const dy = event.changedTouches[0].clientY - start.clientY;
    start = null;
    if (Math.abs(dx) < 50 || Math.abs(dx) < 2 * Math.abs(dy)) return;
    if (dx < 0) advance(shown + 1);
    else retreat();
  }, { passive: true });

  section.classList.add("scrubbed");
  scrubber.hidden = false;
  const hint = section.querySelector(".hint");
  hint.hidden = !matchMedia("(hover: hover)").matches;
  if (fromHash()) section.scrollIntoView();
  else show(1, { speak: false });
}

// What is wider than the window shows that it scrolls, and takes the keyboard there.
const markWide = () => {
  for (const block of document.querySelectorAll("pre, table, math[display=block]")) {
    const box = block.tagName === "math" ? block.parentElement : block;
    const isWide = box.scrollWidth > box.clientWidth + 1;
    box.classList.toggle("wide", isWide);
    if (isWide) box.tabIndex = 0;
  }
};
addEventListener("resize", markWide);
markWide();
