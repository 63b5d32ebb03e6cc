// How the ground fails: the mesh moved by the flow of the upper bound, coloured by speed, with slip lines.
import {box, plus} from './geometry.js';
import {entry, list, shapes} from './model.js';

const TONES = 12, PERIOD_MS = 3600, FARTHEST = .07, ARROW_PX = 36, CELL_PX = 36;

export class Flow {
  constructor(canvas, view) {
    Object.assign(this, {canvas, view, field: null, amount: .5, playing: false});
    matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => this.draw());
  }

  // The flow of a solution, and the document that it is of.
  show(field, problem) {
    Object.assign(this, {field, problem});
    if (field) {
      const {low, high} = box(field.triangles.flatMap(t => [[t[0], t[1]], [t[2], t[3]], [t[4], t[5]]]));
      this.reach = FARTHEST * Math.max(high[0] - low[0], high[1] - low[1]);
      // Places of what moves.
      this.moving = field.velocities.flatMap((v, k) => speed(v) > .05 ? [[field.triangles[k][0], field.triangles[k][1]]] : []);
      const part = box(this.moving);
      // Where little moves, what moves is what is looked at.
      if (part) this.reach = Math.min(this.reach, .12 * Math.max(part.high[0] - part.low[0], part.high[1] - part.low[1]));
      this.tones = Array.from({length: TONES}, () => []);
      field.velocities.forEach((v, k) => this.tones[Math.min(TONES - 1, Math.floor(speed(v) * TONES))].push(k));
    }
    if (!field) this.playing = false;
    this.draw();
  }

  // The velocity at a place, over the greatest; none beside the mesh.
  at([x, y]) {
    if (!this.field) return null;
    for (let k = 0; k < this.field.triangles.length; k++) {
      const [ax, ay, bx, by, cx, cy] = this.field.triangles[k], whole = (bx - ax) * (cy - ay) - (cx - ax) * (by - ay);
      const b = ((x - ax) * (cy - ay) - (cx - ax) * (y - ay)) / whole, c = ((bx - ax) * (y - ay) - (x - ax) * (by - ay)) / whole;
      if (!(b >= 0 && c >= 0 && b + c <= 1)) continue;
      const v = this.field.velocities[k], a = 1 - b - c;
      return [a * v[0] + b * v[2] + c * v[4], a * v[1] + b * v[3] + c * v[5]];
    }
    return null;
  }

  play(on) {
    this.playing = on && Boolean(this.field);
    if (this.playing) { this.begun = performance.now(); this.frame(); } else this.draw();
  }

  // The picture that is shown, in the colours of paper, as an address.
  onPaper() {
    const amount = Number(this.canvas.dataset.amount);
    this.canvas.classList.add('paper');
    this.draw(amount);
    const address = this.canvas.toDataURL('image/png');
    this.canvas.classList.remove('paper');
    this.draw(amount);
    return address;
  }

  frame() {
    if (!this.playing) return;
    this.draw((1 - Math.cos(2 * Math.PI * (performance.now() - this.begun) / PERIOD_MS)) / 2);
    requestAnimationFrame(() => this.frame());
  }

  draw(amount = this.playing ? null : this.amount) {
    if (amount === null) return;
    const {canvas, view, field} = this, ratio = Math.min(2, devicePixelRatio || 1);
    const wide = Math.round(view.width * ratio), tall = Math.round(view.height * ratio);
    if (canvas.width !== wide || canvas.height !== tall) Object.assign(canvas, {width: wide, height: tall});
    const to = canvas.getContext('2d');
    to.setTransform(ratio, 0, 0, ratio, 0, 0);
    to.clearRect(0, 0, view.width, view.height);
    canvas.dataset.amount = field ? amount.toFixed(3) : '';
    if (!field) return;
    const style = getComputedStyle(canvas), colour = name => style.getPropertyValue(name).trim();
    const cold = rgb(colour('--flow-cold')), hot = rgb(colour('--flow-hot'));
    const far = amount * this.reach, {scale, x, y, width, height} = view;
    this.tones.forEach((members, tone) => {
      const part = (tone + .5) / TONES, css = `rgb(${cold.map((c, i) => Math.round(c + part * (hot[i] - c)))})`;
      to.beginPath();
      for (const k of members) {
        const t = field.triangles[k], v = field.velocities[k];
        for (let i = 0; i < 6; i += 2) {
          const px = (t[i] + far * v[i] - x) * scale + width / 2, py = height / 2 - (t[i + 1] + far * v[i + 1] - y) * scale;
          if (i) to.lineTo(px, py); else to.moveTo(px, py);
        }
        to.closePath();
      }
      Object.assign(to, {fillStyle: css, strokeStyle: css, lineWidth: .7});
      to.fill();
      to.stroke();
    });
    this.slips(to, colour('--ink'), 1 - .75 * amount);
    this.arrows(to, colour('--ink'), far);
    this.moved(to, colour('--body'), far);
  }

  slips(to, ink, alpha) {
    Object.assign(to, {strokeStyle: ink, lineCap: 'round', globalAlpha: alpha});
    for (const width of [1, 2, 3]) {
      to.beginPath();
      for (const [ax, ay, bx, by, much] of this.field.slips) {
        if (much < .02 || Math.ceil(much * 3) !== width) continue;
        to.moveTo(...this.view.px([ax, ay]));
        to.lineTo(...this.view.px([bx, by]));
      }
      to.lineWidth = .6 * width;
      to.stroke();
    }
    to.globalAlpha = 1;
  }

  arrows(to, ink, far) {
    const cells = new Set();
    Object.assign(to, {strokeStyle: ink, fillStyle: ink, lineWidth: 1.1});
    for (let k = 0; k < this.field.triangles.length; k++) {
      const t = this.field.triangles[k], v = this.field.velocities[k];
      const vx = (v[0] + v[2] + v[4]) / 3, vy = (v[1] + v[3] + v[5]) / 3, fast = Math.hypot(vx, vy);
      if (fast < .12) continue;
      const at = this.view.px([(t[0] + t[2] + t[4]) / 3 + far * vx, (t[1] + t[3] + t[5]) / 3 + far * vy]);
      const cell = `${Math.round(at[0] / CELL_PX)} ${Math.round(at[1] / CELL_PX)}`;
      if (cells.has(cell)) continue;
      cells.add(cell);
      const tip = plus(at, ARROW_PX, [vx, -vy]), unit = [vx / fast, -vy / fast], head = Math.min(6, .45 * ARROW_PX * fast), back = plus(tip, -head, unit), side = [-unit[1], unit[0]];
      to.beginPath();
      to.moveTo(...at);
      to.lineTo(...back);
      to.stroke();
      to.beginPath();
      to.moveTo(...tip);
      to.lineTo(...plus(back, .42 * head, side));
      to.lineTo(...plus(back, -.42 * head, side));
      to.fill();
    }
  }

  // Structures where they have gone.
  moved(to, ink, far) {
    const {problem, field} = this, aim = problem.objective;
    for (const shape of shapes(problem)) {
      if (shape.section !== 'structure' && shape.section !== 'plate') continue;
      const moves = aim.kind === 'structure' && entry(problem, shape)?.name === aim.name && list(problem, shape.section).length;
      const by = moves ? field.structure : [0, 0];
      to.beginPath();
      shape.points.forEach((p, k) => { const px = this.view.px([p[0] + far * by[0], p[1] + far * by[1]]); if (k) to.lineTo(...px); else to.moveTo(...px); });
      if (shape.closed) { to.closePath(); to.fillStyle = ink; to.fill(); } else { Object.assign(to, {strokeStyle: ink, lineWidth: 5, lineCap: 'butt'}); to.stroke(); }
    }
  }
}

const speed = v => Math.hypot(v[0] + v[2] + v[4], v[1] + v[3] + v[5]) / 3;
// Of a colour written as #rrggbb.
const rgb = words => [1, 3, 5].map(k => parseInt(words.slice(k, k + 2), 16) || 0);
