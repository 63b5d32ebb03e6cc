// Makes the figures interactive. Where this fails, the static figures stay.
(() => {
  "use strict";
  if (typeof Plotly === "undefined") return;
  const night = matchMedia("(prefers-color-scheme: dark)");
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
  const recolor = (key, value) => (night.matches && dark.has(value) ? dark.get(value) : value);
  const below = { orientation: "h", x: 0.5, xanchor: "center", y: 0, yref: "container", yanchor: "bottom" };
  const config = { responsive: true, displaylogo: false, displayModeBar: true };
  const figures = [...document.querySelectorAll("figure")].map((figure) => ({
    frame: figure,
    plot: figure.querySelector(".plot"),
    source: figure.querySelector(".plot-data").textContent,
  }));
  const read = (figure) => {
    const { data, layout } = JSON.parse(figure.source, recolor);
    layout.uirevision = "keep"; // a change of colours keeps the zoom
    // Beside the plot there is no room for a legend on narrow screens.
    if (figure.frame.clientWidth < 600) layout.legend = below;
    // A finger must be able to scroll the page; the buttons still zoom.
    if (matchMedia("(pointer: coarse)").matches) layout.dragmode = false;
    return [data, layout, { ...config, toImageButtonOptions: { filename: figure.frame.id, scale: 2 } }];
  };
  for (const figure of figures) {
    figure.frame.classList.add("live");
    const revert = () => figure.frame.classList.remove("live");
    // Not only the window changes the width: so do scroll bars and print previews.
    const fit = () => figure.plot.clientWidth > 0 && Plotly.Plots.resize(figure.plot);
    try {
      Plotly.newPlot(figure.plot, ...read(figure)).then(() => new ResizeObserver(fit).observe(figure.plot), revert);
    } catch {
      revert();
    }
  }
  night.addEventListener("change", () => {
    for (const figure of figures) Plotly.react(figure.plot, ...read(figure));
  });
})();
