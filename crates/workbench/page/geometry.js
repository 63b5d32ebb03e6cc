// Points are [x, y].

export const distance = ([ax, ay], [bx, by]) => Math.hypot(bx - ax, by - ay);
export const same = (a, b) => a[0] === b[0] && a[1] === b[1];
export const between = ([a, b], part) => [a[0] + part * (b[0] - a[0]), a[1] + part * (b[1] - a[1])];
export const plus = (a, s, b) => [a[0] + s * b[0], a[1] + s * b[1]];

// Length, direction, and the direction to the right of a side: out of the soil, which is on its left.
export function along([a, b]) {
  const x = b[0] - a[0], y = b[1] - a[1], length = Math.hypot(x, y);
  const t = length > 0 ? [x / length, y / length] : [1, 0];
  return {length, t, out: [t[1], -t[0]]};
}

// The point of a segment that is nearest to `p`.
export function nearest([a, b], p) {
  const x = b[0] - a[0], y = b[1] - a[1], square = x * x + y * y;
  const part = square > 0 ? ((p[0] - a[0]) * x + (p[1] - a[1]) * y) / square : 0;
  return between([a, b], Math.min(1, Math.max(0, part)));
}

// The segments of a line, or of a closed polygon.
export function segments(points, closed) {
  const all = [];
  for (let k = 0; k + 1 < points.length; k++) all.push([points[k], points[k + 1]]);
  if (closed && points.length > 2) all.push([points[points.length - 1], points[0]]);
  return all;
}

export function inside(corners, [x, y]) {
  let is = false;
  for (const [[ax, ay], [bx, by]] of segments(corners, true)) {
    if ((ay > y) !== (by > y) && x < ax + (y - ay) / (by - ay) * (bx - ax)) is = !is;
  }
  return is;
}

// Corners of the box around points; none of no points.
export function box(points) {
  if (!points.length) return null;
  const low = [Infinity, Infinity], high = [-Infinity, -Infinity];
  for (const p of points) for (const i of [0, 1]) {
    low[i] = Math.min(low[i], p[i]);
    high[i] = Math.max(high[i], p[i]);
  }
  return {low, high};
}

export function middle(points) {
  const sum = points.reduce((sum, p) => plus(sum, 1, p), [0, 0]);
  return [sum[0] / points.length, sum[1] / points.length];
}

export function area(corners) {
  return segments(corners, true).reduce((sum, [a, b]) => sum + a[0] * b[1] - b[0] * a[1], 0) / 2;
}
