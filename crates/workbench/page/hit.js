// What is under a pointer: points before lines, lines before areas, small ones before large ones.
import {area, distance, inside, nearest, segments} from './geometry.js';
import {isSame, shapes} from './model.js';

// {section, index, point, segment}, or null. `reach` is in pixels; the chosen shape goes before the others.
export function hit(at, problem, view, chosen, reach = 9) {
  const near = p => distance(p, at) * view.scale;
  const all = [...shapes(problem)].reverse().sort((a, b) => isSame(b, chosen) - isSame(a, chosen));
  const found = (shape, more) => ({section: shape.section, index: shape.index, point: null, segment: null, ...more});
  for (const shape of all) {
    const k = shape.points.findIndex(p => near(p) <= reach);
    if (k >= 0 && (isSame(shape, chosen) || shape.section !== 'region')) return found(shape, {point: k});
  }
  // The line that is nearest; where several are, one that is no region, since regions can be had by their area.
  let best = null;
  for (const shape of all) segments(shape.points, shape.closed).forEach((ends, k) => {
    const off = near(nearest(ends, at)) + (shape.section === 'region' && !isSame(shape, chosen) ? 4 : 0);
    if (off <= reach && (!best || off < best.off)) best = {off, shape, segment: k};
  });
  if (best) return found(best.shape, {segment: best.segment});
  const areas = all.filter(shape => shape.closed && inside(shape.points, at)).sort((a, b) => Math.abs(area(a.points)) - Math.abs(area(b.points)));
  return areas.length ? found(areas[0], {}) : null;
}
