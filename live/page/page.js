// A page of one scene: begins it, and lets the reader choose the theme.
"use strict";

// As the system has it, or as the reader chooses.
const lodlabTheme = () => {
  const button = document.querySelector("button.theme");
  const dark = matchMedia("(prefers-color-scheme: dark)");
  const now = () => document.documentElement.dataset.theme ?? (dark.matches ? "dark" : "light");
  const name = () => { button.textContent = now() === "dark" ? "Light" : "Dark"; };
  button.addEventListener("click", () => {
    document.documentElement.dataset.theme = now() === "dark" ? "light" : "dark";
    name();
  });
  dark.addEventListener("change", name);
  name();
};

lodlabTheme();
{
  const root = document.querySelector(".live");
  lodlabLive.mount(root, { scene: root.querySelector("script.scene").textContent, module: lodlabModule() }).catch(() => {});
}
