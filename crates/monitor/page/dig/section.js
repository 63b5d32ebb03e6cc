// The section along the arm: radius to the right, height upwards; soil, plate, arm, hand and force.
import {arrow, colours, fill, hand, line, penOf, words} from './draw.js';

export const FORCE_M_PER_N = .005;
const STEP_M = .004;

export class Section {
  constructor(canvas) { this.canvas = canvas; }
  // What is seen, in m: the box along the arm, and some air.
  // It does not move below a pointer that drags.
  fit(pen, box, plate, dragged) {
    if (!dragged || !this.high) this.high = Math.max(box.surface_z_m + .22, plate ? plate.z_m + .14 : 0);
    const left = Math.max(.05, box.x_m[0] - .05), right = box.x_m[1] + .03, low = box.surface_z_m - .16, high = this.high;
    const scale = Math.min(pen.width / (right - left), pen.height / (high - low));
    const [u, v] = [(pen.width - scale * (left + right)) / 2, (pen.height + scale * (low + high)) / 2];
    this.to = (r, z) => [u + scale * r, v - scale * z];
    this.from = (x, y) => [(x - u) / scale, (v - y) / scale];
    this.scale = scale;
  }
  draw({scene, soil, state, target, grips, dragged, skeleton}) {
    const pen = penOf(this.canvas);
    if (!pen || !scene) return;
    const colour = colours(), box = scene.sandbox, plate = state?.plate;
    this.fit(pen, box, plate, dragged);
    const base = plate ? Math.atan2(plate.y_m, plate.x_m) : 0;
    this.ground(pen, colour, box, soil, base);
    this.scaleBar(pen, colour);
    if (!plate) return;
    const radius = Math.hypot(plate.x_m, plate.y_m), tip = [radius, plate.z_m];
    if (skeleton) line(pen, skeleton.map(([x, y, z]) => this.to(x * Math.cos(base) + y * Math.sin(base), z)), colour('faint'), 5);
    this.plate(pen, colour, tip, plate.tool_angle_deg, scene.plate);
    if (target && target.base !== undefined) {
      const at = this.to(target.radius, target.z);
      line(pen, [this.to(...tip), at], colour('second'), 1.2, [4, 4]);
      hand(pen, at, colour('second'), grips);
    }
    const [r, , z] = state.force_rtz_n, from = this.middle(tip, plate.tool_angle_deg, scene.plate.height_m / 3);
    arrow(pen, this.to(...from), this.to(from[0] + r * FORCE_M_PER_N, from[1] + z * FORCE_M_PER_N), colour('accent'), 5);
  }
  // A point of the plate above its edge.
  middle([r, z], tool_deg, up_m) {
    const angle = tool_deg * Math.PI / 180;
    return [r + up_m * Math.cos(angle), z + up_m * Math.sin(angle)];
  }
  plate(pen, colour, tip, tool_deg, {height_m, thickness_m}) {
    const thick = Math.max(3, thickness_m * this.scale), top = this.middle(tip, tool_deg, height_m);
    line(pen, [this.to(...this.middle(tip, tool_deg, height_m)), this.to(...this.middle(top, tool_deg, .06))], colour('steel'), 3);
    line(pen, [this.to(...tip), this.to(...top)], colour('ink'), thick + 2);
    line(pen, [this.to(...tip), this.to(...top)], colour('steel'), thick);
  }
  ground(pen, colour, box, soil, base) {
    const points = [], level = box.surface_z_m;
    for (let r = this.from(0, 0)[0]; r <= this.from(pen.width, 0)[0] + STEP_M; r += STEP_M) {
      const z = soil?.at(r * Math.cos(base), r * Math.sin(base));
      if (z !== null && z !== undefined) points.push([r, z]);
    }
    if (points.length > 1) {
      const edge = points.map(([r, z]) => this.to(r, z)), floor = z => [this.to(points.at(-1)[0], z), this.to(points[0][0], z)];
      fill(pen, [...edge, ...floor(box.floor_z_m)], colour('sand'));
      line(pen, edge, colour('low'), 1.5);
      line(pen, [this.to(points[0][0], level), this.to(points.at(-1)[0], level)], colour('faint'), 1, [3, 5]);
      for (const [r] of [points[0], points.at(-1)]) line(pen, [this.to(r, box.top_z_m), this.to(r, box.floor_z_m)], colour('steel'), 2);
    }
  }
  scaleBar(pen, colour) {
    const wide = .1 * this.scale, [x, y] = [pen.width - wide - 12, pen.height - 12];
    line(pen, [[x, y], [x + wide, y]], colour('ink'), 2);
    words(pen, '100 mm', x + wide / 2 - 20, y - 5, colour('ink'), colour('panel'));
  }
  // Where a pointer is: radius and height, at the base angle of the plate.
  place(x, y) {
    const [radius, z] = this.from(x, y);
    return {radius, z};
  }
  // The plate's edge in px.
  tip(plate) { return this.to?.(Math.hypot(plate.x_m, plate.y_m), plate.z_m); }
}
