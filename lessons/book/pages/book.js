// The scrubber over the steps of a lesson. Without this file every step is shown, one after another.
"use strict";

for (const section of document.querySelectorAll("section.steps")) {
  const steps = [...section.querySelectorAll("article.step")];
  const scrubber = section.querySelector(".scrubber");
  const slider = scrubber.querySelector("input");
  const back = scrubber.querySelector(".back");
  const next = scrubber.querySelector(".next");
  const count = scrubber.querySelector("output");
  const spoken = section.querySelector(".spoken");
  let shown = 0;

  const show = (number, speak = true) => {
    const wanted = Math.min(Math.max(number, 1), steps.length);
    if (wanted === shown) return;
    shown = wanted;
    steps.forEach((step, i) => step.classList.toggle("away", i + 1 !== shown));
    const title = steps[shown - 1].querySelector("h3").lastChild.textContent.trim();
    slider.value = String(shown);
    slider.setAttribute("aria-valuetext", `Step ${shown} of ${steps.length}: ${title}`);
    count.textContent = `${shown} / ${steps.length}`;
    back.disabled = shown === 1;
    next.disabled = shown === steps.length;
    if (speak) spoken.textContent = `Step ${shown} of ${steps.length}: ${title}`;
    if (speak) history.replaceState(null, "", `#step-${shown}`);
    // The neighbours' pictures are fetched now, so that stepping does not flicker.
    for (const near of [steps[shown - 2], steps[shown]])
      near?.querySelector("img")?.setAttribute("loading", "eager");
  };

  const fromHash = () => {
    const named = /^#step-(\d+)$/.exec(location.hash);
    if (named) show(Number(named[1]), false);
    return named !== null;
  };

  back.addEventListener("click", () => show(shown - 1));
  next.addEventListener("click", () => show(shown + 1));
  slider.addEventListener("input", () => show(Number(slider.value)));
  addEventListener("hashchange", fromHash);
  addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.altKey || event.metaKey || event.shiftKey) return;
    const target = event.target;
    if (target.closest("video, pre, textarea, input:not([type=range])")) return;
    const inSteps = section.contains(target);
    if (event.key === "ArrowRight") show(shown + 1);
    else if (event.key === "ArrowLeft") show(shown - 1);
    else if (event.key === "Home" && inSteps) show(1);
    else if (event.key === "End" && inSteps) show(steps.length);
    else return;
    event.preventDefault();
  });

  section.classList.add("scrubbed");
  scrubber.hidden = false;
  section.querySelector(".hint").hidden = false;
  if (fromHash()) section.scrollIntoView();
  else show(1, false);
}
