// What all pages have: light and dark, and files of figures. Without scripts the system decides the colours.
"use strict";
const soilctlPage = (() => {
  const root = document.documentElement;
  const system = matchMedia("(prefers-color-scheme: dark)");
  const isDark = () => (root.dataset.theme ? root.dataset.theme === "dark" : system.matches);
  // Colours of the light scheme and what replaces them in the dark one.
  const dark = new Map([
    ["#ffffff", "#171b20"], // paper
    ["#1f2328", "#e6e9ed"], // ink
    ["#dfe3e8", "#39414b"], // grid
    ["#5a626b", "#a3adb8"], // neutral
    ["rgba(90,98,107,0.22)", "rgba(163,173,184,0.25)"],
    ["#000000", "#f2f2f2"], // black of the palette
    ["rgba(0,0,0,0.22)", "rgba(242,242,242,0.25)"],
    ["rgba(0,0,0,0.16)", "rgba(242,242,242,0.18)"],
    ["#0072b2", "#3a9ad9"], // blue of the palette
    ["rgba(0,114,178,0.22)", "rgba(58,154,217,0.28)"],
    ["rgba(0,114,178,0.16)", "rgba(58,154,217,0.2)"],
  ]);
  // Steps of shades, from little to much: on dark paper much is light.
  const shades = [SHADES];
  shades.forEach((value, step) => dark.set(value, shades[shades.length - 1 - step]));
  const color = (value) => (isDark() && dark.has(value) ? dark.get(value) : value);
  const listeners = [];
  const button = document.createElement("button");
  button.type = "button";
  button.className = "theme";
  const tell = () => {
    button.textContent = isDark() ? "Light colours" : "Dark colours";
    for (const listener of listeners) listener();
  };
  button.addEventListener("click", () => {
    root.dataset.theme = isDark() ? "light" : "dark";
    tell();
  });
  system.addEventListener("change", tell);
  document.querySelector("header").prepend(button);
  tell();

  const link = (figure, form, make) => {
    const number = figure.id.replace("figure-", "");
    const anchor = document.createElement("a");
    anchor.href = `#${figure.id}`;
    anchor.textContent = form;
    anchor.setAttribute("aria-label", `Figure ${number} (${form})`);
    anchor.addEventListener("click", async (event) => {
      event.preventDefault();
      const file = document.createElement("a");
      file.href = URL.createObjectURL(await make());
      file.download = `${figure.id}.${form.toLowerCase()}`;
      file.click();
      setTimeout(() => URL.revokeObjectURL(file.href), 10_000);
    });
    figure.querySelector(".save").append(" ", anchor);
  };
  for (const figure of document.querySelectorAll("figure")) {
    const still = figure.querySelector(".static svg");
    const svg = () => new Blob([new XMLSerializer().serializeToString(still)], { type: "image/svg+xml" });
    const png = async () => {
      const image = new Image();
      image.src = URL.createObjectURL(svg());
      await image.decode();
      const [width, height] = ["width", "height"].map((side) => 2 * Number(still.getAttribute(side)));
      const canvas = Object.assign(document.createElement("canvas"), { width, height });
      canvas.getContext("2d").drawImage(image, 0, 0, width, height);
      URL.revokeObjectURL(image.src);
      return new Promise((done) => canvas.toBlob(done, "image/png"));
    };
    link(figure, "SVG", svg);
    link(figure, "PNG", png);
  }
  return { isDark, color, onColors: (listener) => listeners.push(listener) };
})();
