// Strip charts over the last seconds, drawn on canvases.
const COLUMNS = ['force_n', 'friction_angle_deg', 'friction_setpoint_deg', 'z_m', 'displacement_m', 'machine', 'positions'];
const MOST_POINTS = 12000;
// Plates slide at less; forces near zero give any angle.
const FRICTION_DEG = [-20, 60];
// Between states that are further apart, and as many times as far as is usual, nothing is known: histories may be thinned.
const GAP_S = .3, GAP_TIMES = 5;
// Labels are not closer, and the first one has its room.
const LABEL_PX = 12, LABEL_TOP_PX = 9;
const MACHINE = {off: 'line', fault: 'bad', idle: 'grid', hold: 'grid', joint_move: 'accent', cartesian_move: 'accent', joint_velocity: 'accent',
  joint_touch: 'third', cartesian_touch: 'third', insert: 'third', stroke: 'second'};

class Charts {
  constructor(root, seek) {
    this.window_s = 30;
    this.level_m = null;
    this.joints = [];
    this.charts = [...root.querySelectorAll('figure')].map(figure => {
      const canvas = figure.querySelector('canvas'), value = figure.querySelector('b');
      const chart = {kind: canvas.dataset.chart, canvas, value, unit: value?.dataset.unit};
      canvas.addEventListener('pointermove', event => { this.cursor = event.offsetX / canvas.clientWidth; this.redraw(); });
      canvas.addEventListener('pointerleave', () => { this.cursor = null; this.redraw(); });
      canvas.addEventListener('click', event => {
        const [from, to] = this.span();
        seek?.(from + (to - from) * event.offsetX / canvas.clientWidth);
      });
      return chart;
    });
    this.clear();
    new ResizeObserver(() => this.redraw()).observe(root);
  }
  // Shows these charts; `joints` of a log of another program: what a position is to be multiplied by.
  choose(kinds, joints) {
    this.joints = joints;
    for (const {kind, canvas} of this.charts) {
      const figure = canvas.parentElement;
      figure.hidden = kind !== 'time' && !kinds.includes(kind);
      if (kind !== 'z') continue;
      figure.querySelector('span').textContent = joints.length ? 'End height' : 'Edge height';
      figure.querySelector('small').hidden = this.level_m === null;
    }
  }
  clear() {
    this.time = [];
    this.data = Object.fromEntries(COLUMNS.map(name => [name, []]));
    this.redraw();
  }
  add(history) {
    if (history.replace) this.clear();
    const last = this.time.at(-1) ?? -1;
    history.time_s.forEach((time, k) => {
      if (time <= last) return;
      this.time.push(time);
      for (const name of COLUMNS) this.data[name].push(history[name]?.[k] ?? null);
    });
    const over = this.time.length - MOST_POINTS;
    if (over > 1000) for (const list of [this.time, ...Object.values(this.data)]) list.splice(0, over);
    this.redraw();
  }
  addState(state) {
    const machine = state.mode === 'ready' ? state.trajectory ?? 'idle' : state.mode;
    this.add({time_s: [state.time_s], force_n: [Math.hypot(...state.force_rtz_n)], friction_angle_deg: [state.friction_angle_deg],
      friction_setpoint_deg: [state.friction_setpoint_deg], z_m: [state.plate?.z_m ?? null], displacement_m: [state.displacement_m], machine: [machine]});
  }
  span() { const to = this.time.at(-1) ?? 0; return [to - this.window_s, to]; }
  redraw() {
    if (this.waiting) return;
    this.waiting = true;
    requestAnimationFrame(() => { this.waiting = false; this.draw(); });
  }
  draw() {
    const style = getComputedStyle(document.documentElement);
    this.colour = name => style.getPropertyValue(`--${name}`).trim();
    const [from, to] = this.span();
    let first = this.time.findIndex(time => time >= from);
    first = first < 0 ? 0 : Math.max(0, first - 1);
    this.gap_s = gapOf(this.time, first);
    let at = this.time.length - 1;
    if (this.cursor != null) {
      const time = from + (to - from) * this.cursor;
      at = Math.max(first, this.time.findLastIndex(known => known <= time));
      if (this.isGap(at) && time - this.time[at] > this.gap_s / GAP_TIMES) at = -1;
    }
    for (const chart of this.charts) {
      const pen = this.pen(chart.canvas);
      if (!pen) continue;
      const times = ticks(from, to, pen.width / 70);
      if (chart.kind === 'time') { this.times(pen, times, from, to); continue; }
      this.uprights(pen, times.filter(time => time >= 0).map(time => (time - from) / (to - from) * pen.width));
      if (chart.kind === 'machine') this.machine(chart, pen, first, from, to, at);
      else this.curves(chart, pen, first, from, to, at);
    }
  }
  // Whether nothing is known between a state and the next.
  isGap(k) { return this.time[k + 1] - this.time[k] > this.gap_s; }
  pen(canvas) {
    const ratio = devicePixelRatio || 1, width = canvas.clientWidth, height = canvas.clientHeight;
    if (!width || !height) return null;
    if (canvas.width !== Math.round(width * ratio) || canvas.height !== Math.round(height * ratio)) [canvas.width, canvas.height] = [Math.round(width * ratio), Math.round(height * ratio)];
    const pen = canvas.getContext('2d');
    pen.setTransform(ratio, 0, 0, ratio, 0, 0);
    pen.clearRect(0, 0, width, height);
    pen.font = '10px system-ui, "DejaVu Sans", sans-serif';
    return Object.assign(pen, {width, height});
  }
  uprights(pen, places) {
    pen.strokeStyle = this.colour('grid');
    pen.lineWidth = 1;
    for (const place of places) { pen.beginPath(); pen.moveTo(Math.round(place) + .5, 0); pen.lineTo(Math.round(place) + .5, pen.height); pen.stroke(); }
  }
  times(pen, times, from, to) {
    pen.fillStyle = this.colour('faint');
    for (const time of times.filter(time => time >= 0)) {
      const words = `${label(time)} s`, wide = pen.measureText(words).width, place = (time - from) / (to - from) * pen.width - wide / 2;
      if (place >= 0 && place + wide <= pen.width) pen.fillText(words, place, 11);
    }
  }
  series(kind) {
    const {data} = this, mm = list => list.map(value => value === null ? null : value * 1000);
    if (kind === 'force') return [[data.force_n, 'accent']];
    if (kind === 'friction') return [[data.friction_angle_deg, 'accent'], [data.friction_setpoint_deg, 'second', [5, 3]]];
    if (kind === 'z') return [[mm(data.z_m), 'accent']];
    if (kind === 'joints') return this.joints.map((factor, j) => [data.positions.map(row => row?.[j] == null ? null : row[j] * factor), ...jointLook(j)]);
    return [[mm(data.displacement_m), 'accent']];
  }
  curves(chart, pen, first, from, to, at) {
    const {width, height} = pen, series = this.series(chart.kind);
    const values = series.flatMap(([list]) => list.slice(first)).filter(value => value !== null);
    let low = Math.min(...values), high = Math.max(...values);
    if (chart.kind === 'friction' && values.length) [low, high] = [Math.max(low, FRICTION_DEG[0]), Math.min(high, FRICTION_DEG[1])];
    if (low > high) [low, high] = FRICTION_DEG;
    if (chart.kind === 'z' && this.level_m !== null && values.length) [low, high] = [Math.min(low, this.level_m * 1000), Math.max(high, this.level_m * 1000)];
    if (chart.kind === 'force') [low, high] = [0, Math.max(high, 1)];
    if (!values.length) [low, high] = chart.kind === 'friction' ? [0, 40] : [0, 10];
    const room = Math.max(high - low, chart.kind === 'friction' ? 4 : chart.kind === 'z' ? 4 : 1) * .12;
    [low, high] = [chart.kind === 'force' ? 0 : low - room, high + room];
    const x = time => (time - from) / (to - from) * width, y = value => height - (value - low) / (high - low) * height;
    const levels = ticks(low, high, height / 26), words = labels(low, high, height);
    pen.strokeStyle = this.colour('grid');
    pen.lineWidth = 1;
    for (const level of levels) { const place = Math.round(y(level)) + .5; pen.beginPath(); pen.moveTo(0, place); pen.lineTo(width, place); pen.stroke(); }
    if (chart.kind === 'z' && this.level_m !== null) this.line(pen, [[0, y(this.level_m * 1000)], [width, y(this.level_m * 1000)]], 'second', [5, 3]);
    for (const [list, colour, dash] of series) {
      let run = [];
      const end = () => { this.line(pen, run, colour, dash); run = []; };
      for (let k = first; k < this.time.length; k++) {
        if (list[k] === null) end(); else run.push([x(this.time[k]), y(list[k])]);
        if (this.isGap(k)) end();
      }
      end();
    }
    this.upright(pen, at < 0 ? this.cursor * width : x(this.time[at]));
    for (const [level, place] of words) this.words(pen, label(level), 2, place);
    if (chart.kind === 'joints') {
      // Which is which, also without colours.
      series.forEach(([list], j) => { if (list[at] != null) this.words(pen, `${j + 1}`, width - 8 - 9 * (j % 3), y(list[at]) - 3); });
      return;
    }
    const shown = series.map(([list]) => list[at]);
    chart.value.textContent = shown[0] == null ? '–' : `${shown[0].toFixed(1)} ${chart.unit}${shown[1] == null ? '' : ` (${shown[1].toFixed(1)})`}`;
  }
  // At the pointer.
  upright(pen, place) { if (this.cursor != null) this.line(pen, [[place, 0], [place, pen.height]], 'faint'); }
  // In front of curves, and to be read there.
  words(pen, words, x, y) {
    pen.strokeStyle = this.colour('panel');
    pen.lineWidth = 3;
    pen.strokeText(words, x, y);
    pen.fillStyle = this.colour('faint');
    pen.fillText(words, x, y);
  }
  line(pen, points, colour, dash = []) {
    if (!points.length) return;
    // A state between two gaps is a dot.
    if (points.length < 2) points = [points[0], [points[0][0] + 1.6, points[0][1]]];
    pen.strokeStyle = this.colour(colour);
    pen.lineWidth = dash.length ? 1.2 : 1.6;
    pen.lineJoin = 'round';
    pen.setLineDash(dash);
    pen.beginPath();
    points.forEach(([x, y], k) => k ? pen.lineTo(x, y) : pen.moveTo(x, y));
    pen.stroke();
    pen.setLineDash([]);
  }
  machine(chart, pen, first, from, to, at) {
    const {width, height} = pen, list = this.data.machine, x = time => (time - from) / (to - from) * width;
    for (let k = first; k < list.length;) {
      let end = k;
      while (end + 1 < list.length && list[end + 1] === list[k] && !this.isGap(end)) end++;
      const left = Math.max(0, x(this.time[k])), words = list[k].replace('_', ' ');
      const right = this.isGap(end) ? Math.max(left + 2, x(this.time[end])) : end + 1 < list.length ? x(this.time[end + 1]) : width;
      pen.globalAlpha = .32;
      pen.fillStyle = this.colour(MACHINE[list[k]] ?? 'grid');
      pen.fillRect(left, 0, right - left, height);
      pen.globalAlpha = 1;
      pen.fillRect(left, height - 3, right - left - 1, 3);
      if (pen.measureText(words).width < right - left - 6) { pen.fillStyle = this.colour('ink'); pen.fillText(words, left + 4, height / 2 + 2); }
      k = end + 1;
    }
    this.upright(pen, at < 0 ? this.cursor * width : x(this.time[at]));
    chart.value.textContent = list[at]?.replace('_', ' ') ?? '–';
  }
}

// Colour and dashes of a joint's curve.
const JOINT_COLOURS = ['accent', 'second', 'third', 'warn', 'bad', 'faint'];
const JOINT_DASHES = [[], [7, 3], [2, 2], [8, 3, 2, 3], [12, 3], [5, 2, 1, 2, 1, 2], [1, 3]];
function jointLook(number) {
  return [JOINT_COLOURS[number % JOINT_COLOURS.length], JOINT_DASHES[number % JOINT_DASHES.length]];
}

// Round numbers between two others: about as many as wanted, and two at least.
function ticks(low, high, wanted) {
  const rough = (high - low) / Math.max(2, wanted), power = 10 ** Math.floor(Math.log10(rough));
  for (const step of [10, 5, 2, 1, .5, .2].map(factor => factor * power).filter(step => step < 2.5 * rough)) {
    const first = Math.ceil(low / step), count = Math.floor(high / step) - first + 1;
    if (count >= 2) return Array.from({length: Math.min(count, 50)}, (_, k) => (first + k) * step);
  }
  return [];
}

// How much further apart states are where something is missing between them, in s.
function gapOf(times, first) {
  const steps = Float64Array.from(times.slice(first + 1), (time, k) => time - times[first + k]).sort();
  return Math.max(GAP_S, GAP_TIMES * (steps[Math.floor(steps.length / 2)] ?? 0));
}

// Levels of a chart that have a label, with its place in px from above: none over another one, and two if they fit in.
function labels(low, high, height) {
  let found = [];
  for (const wanted of [height / 26, height / 13, height / 6]) {
    found = [];
    for (const level of ticks(low, high, wanted)) {
      const place = Math.max(LABEL_TOP_PX, height - (level - low) / (high - low) * height - 2);
      if (!found.length || found.at(-1)[1] - place >= LABEL_PX) found.push([level, place]);
    }
    if (found.length > 1) break;
  }
  return found;
}

function label(number) { return Number(number.toPrecision(6)).toString().replace('-', '−'); }
