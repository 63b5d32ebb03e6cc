// The bracket as it narrows: lower and upper bound, level by level.
import {short, svg} from './dom.js';

const WIDE = 320, TALL = 170, LEFT = 54, RIGHT = 12, TOP = 10, BOTTOM = 24;

// `steps` are {lower, upper, elements}; the last is the best so far.
export function scale(steps, unit) {
  const known = steps.flatMap(({lower, upper}) => [lower, upper]).filter(Number.isFinite);
  const chart = svg('svg', {viewBox: `0 0 ${WIDE} ${TALL}`, class: 'scale', role: 'img'});
  if (!known.length) {
    chart.setAttribute('aria-label', 'no bounds yet');
    chart.append(svg('text', {x: WIDE / 2, y: TALL / 2, 'text-anchor': 'middle', class: 'faint'}, 'no bounds yet'));
    return chart;
  }
  const last = steps.at(-1), ends = [last.lower, last.upper].filter(Number.isFinite);
  const centre = ends.reduce((a, b) => a + b, 0) / ends.length;
  // First bounds may be far off; the scale is that of what they came to.
  const reach = Math.max(1e-12, 1e-3 * Math.abs(centre), Math.min(.6 * Math.abs(centre) || Infinity, Math.max(...known.map(value => Math.abs(value - centre)))));
  const low = centre - 1.15 * reach, high = centre + 1.15 * reach;
  const x = k => LEFT + (steps.length > 1 ? k / (steps.length - 1) : .5) * (WIDE - LEFT - RIGHT);
  const y = value => TOP + (1 - (Math.min(high, Math.max(low, value)) - low) / (high - low)) * (TALL - TOP - BOTTOM);
  for (let k = 0; k <= 4; k++) {
    const value = low + k / 4 * (high - low);
    chart.append(svg('path', {d: `M${LEFT} ${y(value)}H${WIDE - RIGHT}`, class: 'rule'}), svg('text', {x: LEFT - 6, y: y(value) + 4, 'text-anchor': 'end', class: 'faint'}, short(value, 3)));
  }
  const line = key => steps.map((step, k) => [k, step[key]]).filter(([, value]) => Number.isFinite(value)).map(([k, value]) => [x(k), y(value)]);
  const lower = line('lower'), upper = line('upper');
  const both = steps.map((step, k) => [k, step]).filter(([, step]) => Number.isFinite(step.lower) && Number.isFinite(step.upper));
  if (both.length) chart.append(svg('path', {d: `M${[...both.map(([k, step]) => [x(k), y(step.upper)]), ...both.reverse().map(([k, step]) => [x(k), y(step.lower)])].join('L')}Z`, class: 'bracket'}));
  if (both.length === 1) chart.append(svg('path', {d: `M${x(both[0][0])} ${y(both[0][1].upper)}V${y(both[0][1].lower)}`, class: 'bracket one'}));
  for (const [points, name] of [[lower, 'lower'], [upper, 'upper']]) {
    if (!points.length) continue;
    chart.append(svg('path', {d: `M${points.join('L')}`, class: name}));
    for (const [cx, cy] of points) chart.append(name === 'lower' ? svg('circle', {cx, cy, r: 3, class: 'lower'}) : svg('rect', {x: cx - 3, y: cy - 3, width: 6, height: 6, class: 'upper'}));
  }
  chart.append(svg('text', {x: WIDE - RIGHT, y: TALL - 6, 'text-anchor': 'end', class: 'faint'}, `level ${steps.length}: ${short(last.elements)} elements`));
  const words = [Number.isFinite(last.lower) && `at least ${short(last.lower)}`, Number.isFinite(last.upper) && `at most ${short(last.upper)}`].filter(Boolean).join(', ');
  chart.setAttribute('aria-label', `bounds after ${steps.length} levels: ${words} ${unit}`);
  return chart;
}
