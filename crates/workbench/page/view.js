// Where a point of the ground is on the screen, and back. Metres to pixels; y upwards to y downwards.
import {box} from './geometry.js';
import {inUnit} from './units.js';

const LEAST_SCALE = 1e-3, MOST_SCALE = 1e6;

export class View {
  constructor() { Object.assign(this, {x: 0, y: 0, scale: 40, width: 100, height: 100, listeners: []}); }

  px([x, y]) { return [(x - this.x) * this.scale + this.width / 2, this.height / 2 - (y - this.y) * this.scale]; }
  m([x, y]) { return [(x - this.width / 2) / this.scale + this.x, (this.height / 2 - y) / this.scale + this.y]; }

  size(width, height) { Object.assign(this, {width: Math.max(1, width), height: Math.max(1, height)}); this.tell(); }

  pan(dx, dy) { this.x -= dx / this.scale; this.y += dy / this.scale; this.tell(); }

  // Keeps the point under a pixel where it is.
  zoom(factor, at = [this.width / 2, this.height / 2]) {
    const held = this.m(at);
    this.scale = Math.min(MOST_SCALE, Math.max(LEAST_SCALE, this.scale * factor));
    const now = this.m(at);
    this.x += held[0] - now[0];
    this.y += held[1] - now[1];
    this.tell();
  }

  // All of the points, with room for symbols around them.
  fit(points) {
    const {low, high} = box(points) ?? {low: [-10, -8], high: [10, 2]};
    const room = this.width < 500 ? [44, 40] : [76, 64];
    const wide = Math.max(1e-3, high[0] - low[0]), tall = Math.max(1e-3, high[1] - low[1]);
    const scale = Math.min((this.width - 2 * room[0]) / wide, (this.height - 2 * room[1]) / tall);
    this.scale = Math.min(MOST_SCALE, Math.max(LEAST_SCALE, scale));
    this.x = (low[0] + high[0]) / 2;
    this.y = (low[1] + high[1]) / 2;
    this.tell();
  }

  // The distance of grid lines in m: 1, 2 or 5 times a power of ten of the unit that is shown, at least so many pixels.
  step(pixels = 22) {
    const one = inUnit(1, 'm'), least = pixels / this.scale * one, power = 10 ** Math.floor(Math.log10(least));
    const times = [1, 2, 5, 10].find(times => times * power >= least * (1 - 1e-9));
    return Number((times * power / one).toPrecision(6));
  }

  listen(hear) { this.listeners.push(hear); }
  tell() { for (const hear of this.listeners) hear(); }
}
