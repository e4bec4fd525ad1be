// The live part of a lesson: hidden without scripts, begun when the reader comes to it. Its files are script elements,
// which a page may have from a disk, too.
"use strict";

{
  const root = document.querySelector("section.live");
  const told = root.querySelector(".finding");

  const script = (address) => new Promise((done, failed) => {
    const element = document.createElement("script");
    element.addEventListener("load", done);
    element.addEventListener("error", () => failed(new Error(`${address} cannot be read`)));
    element.src = address;
    document.head.append(element);
  });

  const begin = async () => {
    told.textContent = "The scene is being loaded …";
    try {
      await Promise.all(["../lodlab.js", "../live.js", root.dataset.scene].map(script));
      await lodlabLive.mount(root, { scene: lodlabScene, module: lodlabModule(), controls: root.dataset.controls });
    } catch (error) {
      told.textContent = "";
      root.querySelector(".trouble").textContent = `This scene does not run here: ${error.message}.`;
    }
    root.classList.remove("waiting");
  };

  // Who counts bytes is asked first.
  const ask = () => {
    const button = document.createElement("button");
    button.type = "button";
    button.textContent = "Load the scene (1 MB)";
    button.addEventListener("click", () => { begin(); button.remove(); }, { once: true });
    root.querySelector(".controls").append(button);
  };

  root.hidden = false;
  root.classList.add("waiting");
  if (navigator.connection?.saveData) ask();
  else
    new IntersectionObserver((entries, observer) => {
      if (!entries.some((entry) => entry.isIntersecting)) return;
      observer.disconnect();
      begin();
    }).observe(root.querySelector(".stage"));
}
