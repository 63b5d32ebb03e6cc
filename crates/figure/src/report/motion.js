// Figures that move. Where this fails, or scripts are off, the figure shows their end.
(() => {
  const MOVE_S = 2.5;
  const REST_S = 1;
  const calm = matchMedia("(prefers-reduced-motion: reduce)");

  const start = (figure) => {
    const data = JSON.parse(figure.querySelector(".figure-data").textContent);
    const [canvas, stage, button, slider, output] = ["canvas", ".stage", ".play", "input", "output"].map((part) =>
      figure.querySelector(`.motion ${part}`),
    );
    const pen = canvas.getContext("2d");
    if (!pen) return;
    for (const side of ["left", "top", "width", "height"]) canvas.style[side] = `${100 * data[side]}%`;
    figure.classList.add("live");
    stage.querySelector("svg").setAttribute("aria-hidden", "true");

    const painted = [...stage.querySelectorAll("svg [fill], svg [stroke]")].flatMap((element) =>
      ["fill", "stroke"].map((name) => [element, name, element.getAttribute(name)?.toLowerCase()]),
    );
    let part = 1;
    let playing = false;
    let seen = false;
    let asked = false; // once the reader has used the controls, nothing starts by itself
    let clock = 0;
    let last = null;

    const trace = (points) => {
      for (let i = 0; i < points.length; i += 4) {
        const x = points[i] + part * points[i + 2];
        const y = points[i + 1] + part * points[i + 3];
        if (i) pen.lineTo(x, y);
        else pen.moveTo(x, y);
      }
    };
    const draw = () => {
      const box = canvas.getBoundingClientRect();
      const dense = window.devicePixelRatio || 1;
      const [width, height] = [box.width, box.height].map((length) => Math.max(1, Math.round(length * dense)));
      if (canvas.width !== width || canvas.height !== height) Object.assign(canvas, { width, height });
      pen.setTransform(1, 0, 0, 1, 0, 0);
      pen.clearRect(0, 0, width, height);
      const scale = width / data.steps[0];
      pen.setTransform(scale, 0, 0, height / data.steps[1], 0, 0);
      pen.fillStyle = data.tones[soilctlPage.isDark() ? 1 : 0];
      pen.beginPath();
      data.areas.forEach(trace);
      pen.fill();
      pen.lineJoin = "round";
      for (const lines of data.lines) {
        pen.strokeStyle = soilctlPage.color(lines.color);
        pen.lineWidth = (lines.width * dense) / scale;
        pen.beginPath();
        lines.parts.forEach(trace);
        pen.stroke();
      }
      canvas.dataset.moved = part.toFixed(3);
    };
    const show = (value) => {
      part = value;
      const percent = `${Math.round(100 * part)} %`;
      slider.value = 100 * part;
      slider.setAttribute("aria-valuetext", percent);
      output.textContent = percent;
      draw();
    };
    const step = (now) => {
      if (!playing || !seen) {
        last = null;
        return;
      }
      clock += last === null ? 0 : Math.min(now - last, 100) / 1000;
      last = now;
      show(Math.min(1, (clock % (MOVE_S + REST_S)) / MOVE_S));
      requestAnimationFrame(step);
    };
    const play = (on) => {
      if (on && !playing) clock = part < 1 ? part * MOVE_S : 0;
      playing = on;
      button.textContent = on ? "Pause" : "Play";
      if (on && last === null) requestAnimationFrame(step);
    };

    button.addEventListener("click", () => {
      asked = true;
      play(!playing);
    });
    slider.addEventListener("input", () => {
      asked = true;
      play(false);
      show(slider.valueAsNumber / 100);
    });
    calm.addEventListener("change", () => calm.matches && play(false));
    new ResizeObserver(draw).observe(canvas);
    const paint = () => {
      for (const [element, name, color] of painted) if (color) element.setAttribute(name, soilctlPage.color(color));
      draw();
    };
    soilctlPage.onColors(paint);
    new IntersectionObserver(
      ([entry]) => {
        seen = entry.isIntersecting;
        if (!seen) return;
        if (!asked && !calm.matches) play(true);
        if (playing && last === null) requestAnimationFrame(step);
      },
      { threshold: 0.3 },
    ).observe(canvas);
    show(1);
    paint();
  };

  for (const figure of document.querySelectorAll("figure.moving")) start(figure);
})();
