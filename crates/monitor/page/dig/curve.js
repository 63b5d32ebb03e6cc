// The force over the last seconds, with the limit.
import {colours, line, penOf, words} from './draw.js';

const WINDOW_S = 15;

export class Curve {
  constructor(canvas) { Object.assign(this, {canvas, points: []}); }
  clear() { this.points = []; }
  add(time_s, force_n) {
    if (this.points.length && time_s <= this.points.at(-1)[0]) this.clear();
    this.points.push([time_s, force_n]);
    while (this.points[0][0] < time_s - WINDOW_S - 1) this.points.shift();
  }
  draw(limit_n) {
    const pen = penOf(this.canvas);
    if (!pen) return;
    const colour = colours(), most = Math.max(1.15 * limit_n, ...this.points.map(([, force]) => force)), to = this.points.at(-1)?.[0] ?? 0;
    const x = time => (time - to + WINDOW_S) / WINDOW_S * pen.width, y = force => pen.height - 2 - force / most * (pen.height - 4);
    line(pen, [[0, y(0)], [pen.width, y(0)]], colour('grid'), 1);
    line(pen, [[0, y(limit_n)], [pen.width, y(limit_n)]], colour('bad'), 1, [5, 3]);
    if (this.points.length > 1) line(pen, this.points.map(([time, force]) => [x(time), y(force)]), colour('accent'), 1.6);
    words(pen, `${limit_n} N`, 2, y(limit_n) + 11, colour('faint'), colour('panel'));
    words(pen, `${WINDOW_S} s`, pen.width - 22, pen.height - 4, colour('faint'), colour('panel'));
  }
}
