// The soil from above: x upwards, y to the left, as one looks along the arm. Light comes from the upper left.
import {arrow, colours, hand, line, penOf, words} from './draw.js';
import {FORCE_M_PER_N} from './section.js';

const MOST_M = .05;

export class Map {
  constructor(canvas) { Object.assign(this, {canvas, image: document.createElement('canvas'), seen: ''}); }
  fit(pen, box) {
    const [x0, x1] = [Math.min(0, box.x_m[0]) - .02, box.x_m[1] + .02], [y0, y1] = [box.y_m[0] - .02, box.y_m[1] + .02];
    const scale = Math.min(pen.width / (y1 - y0), pen.height / (x1 - x0));
    const [u, v] = [pen.width / 2 + scale * (y0 + y1) / 2, (pen.height + scale * (x0 + x1)) / 2];
    this.to = (x, y) => [u - scale * y, v - scale * x];
    this.from = (px, py) => [(v - py) / scale, (u - px) / scale];
    this.scale = scale;
  }
  draw({scene, soil, state, target, grips, skeleton}) {
    const pen = penOf(this.canvas);
    if (!pen || !scene) return;
    const colour = colours(), box = scene.sandbox, plate = state?.plate;
    this.fit(pen, box);
    if (soil?.columns) {
      this.shade(soil, colour);
      const [left, top] = this.to(box.x_m[1], box.y_m[1]), [right, bottom] = this.to(box.x_m[0], box.y_m[0]);
      pen.imageSmoothingEnabled = true;
      pen.drawImage(this.image, left, top, right - left, bottom - top);
      line(pen, [[left, top], [right, top], [right, bottom], [left, bottom], [left, top]], colour('steel'), 2);
    }
    if (skeleton) line(pen, skeleton.map(([x, y]) => this.to(x, y)), colour('faint'), 4);
    const axis = this.to(0, 0);
    pen.fillStyle = colour('steel');
    pen.beginPath();
    pen.arc(...axis, 5, 0, 2 * Math.PI);
    pen.fill();
    if (!plate) return;
    const base = Math.atan2(plate.y_m, plate.x_m), half = scene.plate.width_m / 2, across = [-Math.sin(base) * half, Math.cos(base) * half];
    const ends = [this.to(plate.x_m - across[0], plate.y_m - across[1]), this.to(plate.x_m + across[0], plate.y_m + across[1])];
    line(pen, ends, colour('ink'), 6);
    line(pen, ends, colour('steel'), 4);
    const tip = this.to(plate.x_m, plate.y_m);
    if (target && target.base !== undefined) {
      const at = this.to(target.radius * Math.cos(target.base), target.radius * Math.sin(target.base));
      line(pen, [tip, at], colour('second'), 1.2, [4, 4]);
      hand(pen, at, colour('second'), grips);
    }
    const [r, t] = state.force_rtz_n, x = r * Math.cos(base) - t * Math.sin(base), y = r * Math.sin(base) + t * Math.cos(base);
    arrow(pen, tip, this.to(plate.x_m + x * FORCE_M_PER_N, plate.y_m + y * FORCE_M_PER_N), colour('accent'), 4);
    words(pen, 'base', axis[0] + 8, axis[1] + 4, colour('faint'), colour('panel'));
  }
  // Heights as colours from deep to high, and slopes as light and shade.
  shade(soil, colour) {
    const key = `${soil.version} ${colour('low')}`;
    if (this.seen === key) return;
    this.seen = key;
    const {columns: n, rows: m, heights: h} = soil, cell = soil.box.cell_m;
    [this.image.width, this.image.height] = [m, n];
    const pen = this.image.getContext('2d'), picture = pen.createImageData(m, n), [low, level, high] = ['low', 'sand', 'high'].map(name => rgb(colour(name)));
    for (let i = 0; i < n; i++) for (let j = 0; j < m; j++) {
      const k = j * n + i, at = ((n - 1 - i) * m + (m - 1 - j)) * 4, share = Math.max(-1, Math.min(1, h[k] / MOST_M));
      const dx = (h[j * n + Math.min(n - 1, i + 1)] - h[j * n + Math.max(0, i - 1)]) / (2 * cell), dy = (h[Math.min(m - 1, j + 1) * n + i] - h[Math.max(0, j - 1) * n + i]) / (2 * cell);
      const light = Math.max(.55, Math.min(1.3, 1 + .45 * (-dx - dy)));
      for (let c = 0; c < 3; c++) picture.data[at + c] = light * (level[c] + Math.abs(share) * ((share < 0 ? low : high)[c] - level[c]));
      picture.data[at + 3] = 255;
    }
    pen.putImageData(picture, 0, 0);
  }
  place(px, py) {
    const [x, y] = this.from(px, py);
    return {radius: Math.hypot(x, y), base: Math.atan2(y, x)};
  }
  tip(plate) { return this.to?.(plate.x_m, plate.y_m); }
}

// Of a colour as #rrggbb.
function rgb(text) { return [1, 3, 5].map(at => parseInt(text.slice(at, at + 2), 16)); }
