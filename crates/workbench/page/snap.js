// Where a pointer means to be: at a point that is there, on a line that is there, or on the grid.
import {distance, nearest, same, segments} from './geometry.js';
import {shapes} from './model.js';

// How near is near, in pixels.
const POINT_PX = 11, LINE_PX = 7;

// Grid points as decimal numbers, without what binary ones add to them.
export function toGrid(value, step) { return Number((Math.round(value / step) * step).toFixed(Math.max(0, 3 - Math.floor(Math.log10(step))))) + 0; }

// `skip` says which points of the document do not count: those that are being moved.
export function snap(at, problem, view, {grid = true, points = true, step = view.step(), skip = () => false, extra = []} = {}) {
  const near = (p, px) => distance(p, at) * view.scale <= px;
  if (points) {
    let best = null;
    const offer = p => { if (near(p, POINT_PX) && (!best || distance(p, at) < distance(best, at))) best = p; };
    for (const shape of shapes(problem)) shape.points.forEach((p, k) => { if (!skip(p, shape, k)) offer(p); });
    extra.forEach(offer);
    if (best) return {at: [...best], kind: 'point'};
  }
  const gridded = grid ? at.map(value => toGrid(value, step)) : [...at];
  if (points) {
    // On a line, at the grid if the line has a point there.
    for (const shape of shapes(problem)) for (const ends of segments(shape.points, shape.closed)) {
      if (ends.some(p => skip(p, shape, -1))) continue;
      if (grid && near(gridded, 2 * POINT_PX) && same(nearest(ends, gridded).map(round), gridded.map(round))) return {at: gridded, kind: 'line'};
      const on = nearest(ends, at);
      if (near(on, LINE_PX) && (ends[0][0] === ends[1][0] || ends[0][1] === ends[1][1])) {
        const axis = ends[0][0] === ends[1][0] ? 0 : 1, found = [...gridded];
        found[axis] = ends[0][axis];
        return {at: found, kind: 'line'};
      }
    }
  }
  return {at: gridded, kind: grid ? 'grid' : 'free'};
}

const round = value => Number(value.toFixed(9)) + 0;
