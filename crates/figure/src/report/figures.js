// Makes plots interactive. Where this fails, the static figures stay.
(() => {
  if (typeof Plotly === "undefined") return;
  const recolor = (key, value) => soilctlPage.color(value);
  const below = { orientation: "h", x: 0.5, xanchor: "center", y: 0, yref: "container", yanchor: "bottom" };
  // Pictures are saved by the links below; selecting points does nothing here.
  const needless = ["toImage", "lasso2d", "select2d"];
  const config = { responsive: true, displaylogo: false, displayModeBar: true, modeBarButtonsToRemove: needless };
  const figures = [...document.querySelectorAll("figure.plotted")].map((figure) => ({
    frame: figure,
    plot: figure.querySelector(".plot"),
    source: figure.querySelector(".figure-data").textContent,
  }));
  const read = (figure) => {
    const { data, layout } = JSON.parse(figure.source, recolor);
    layout.uirevision = "keep"; // a change of colours keeps the zoom
    // Beside the plot there is no room for a legend on narrow screens.
    if (figure.frame.clientWidth < 600) layout.legend = below;
    // A finger must be able to scroll the page; the buttons still zoom.
    if (matchMedia("(pointer: coarse)").matches) layout.dragmode = false;
    return [data, layout, config];
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
  soilctlPage.onColors(() => {
    for (const figure of figures) Plotly.react(figure.plot, ...read(figure));
  });
})();
