// What was understood, in the symbols of structural drawings: hatching where the ground is fixed, rollers where it slides, dashes where it
// goes on, arrows for what acts. Sides are walked with the soil on the left, so symbols stand on their right.
import {short, svg} from './dom.js';
import {along, between, middle, plus} from './geometry.js';
import {inUnit, unit} from './units.js';

const pressed = value => short(inUnit(value, 'kPa'));

const PRESSURE_PX = 40, SURCHARGE_PX = 14, MOTION_PX = 58;

const path = (points, attributes) => svg('path', {d: points.map(line => `M${line.map(([x, y]) => `${x.toFixed(1)} ${y.toFixed(1)}`).join('L')}`).join(''), ...attributes});

// Parts of the way along a side at which symbols stand.
function stations(length, apart, least = 1) {
  const count = Math.max(least, Math.min(300, Math.round(length / apart)));
  return Array.from({length: count}, (_, k) => (k + .5) / count);
}

// An arrow as a line with a head, in pixels.
export function arrow(from, to, attributes = {}) {
  const {length, t, out} = along([from, to]), head = Math.min(8, length * .6);
  const back = plus(to, -head, t);
  return svg('g', attributes, path([[from, plus(to, -.6 * head, t)]], {class: 'shaft'}),
    svg('path', {d: `M${to}L${plus(back, .45 * head, out)}L${plus(back, -.45 * head, out)}Z`, class: 'head'}));
}

// The side in pixels. The y of the screen points down, so the outside is on the other side.
function onScreen(view, ends) {
  const px = ends.map(p => view.px(p)), {length, t, out} = along(px);
  return {px, length, t, out: [-out[0], -out[1]]};
}

function support(view, {ends, kind}) {
  const {px, length, t, out} = onScreen(view, ends);
  const base = kind => path([px], {class: `side ${kind}`});
  switch (kind) {
    case 'fixed': {
      const strokes = stations(length, 10).map(part => { const at = between(px, part); return [at, plus(plus(at, 9, out), -9, t)]; });
      return [base('fixed'), path(strokes, {class: 'thin'})];
    }
    case 'smooth': {
      const rollers = stations(length, 26).map(part => { const [cx, cy] = plus(between(px, part), 4.5, out); return svg('circle', {cx, cy, r: 3.5, class: 'roller'}); });
      return [base('smooth'), ...rollers, path([px.map(p => plus(p, 9, out))], {class: 'thin'})];
    }
    case 'far': return [base('far')];
    case 'face': return [base('face')];
    default: return [base('free')];
  }
}

function load(view, {ends, pressure, shear, live}, most) {
  const {px, length, t, out} = onScreen(view, ends), parts = [];
  const at = part => pressure[0] + part * (pressure[1] - pressure[0]);
  const reach = part => most > 0 ? PRESSURE_PX * Math.abs(at(part)) / most : 0;
  for (const part of stations(length, 18, 3)) {
    const foot = between(px, part), tail = plus(foot, reach(part), out);
    if (reach(part) > 3) parts.push(at(part) > 0 ? arrow(tail, foot) : arrow(foot, tail));
  }
  for (const part of stations(length, 34, 2)) {
    const value = shear[0] + part * (shear[1] - shear[0]);
    if (!value) continue;
    const mid = plus(between(px, part), 5, out), half = value > 0 ? 11 : -11;
    parts.push(arrow(plus(mid, -half, t), plus(mid, half, t)));
  }
  const tails = [0, 1].map(part => plus(between(px, part), reach(part), out));
  if (pressure.some(Boolean)) parts.push(path([tails], {class: 'shaft'}));
  const span = ([a, b]) => Math.abs(a - b) <= 1e-9 * Math.abs(a) ? pressed(a) : `${pressed(a)} to ${pressed(b)}`;
  const words = [pressure.some(Boolean) && `${span(pressure)} ${unit('kPa')}`, shear.some(Boolean) && `shear ${span(shear.map(Math.abs))} ${unit('kPa')}`].filter(Boolean).join(', ');
  const [x, y] = plus(middle(tails), 8, out);
  const anchor = out[0] > .5 ? 'start' : out[0] < -.5 ? 'end' : 'middle';
  if (words) parts.push(svg('text', {x, y: out[1] > .5 ? y + 10 : y, 'text-anchor': anchor, class: 'value'}, words));
  return svg('g', {class: live ? 'acting live' : 'acting'}, ...parts);
}

function surcharge(view, sides, value) {
  const free = sides.filter(side => side.kind === 'free');
  const arrows = free.flatMap(side => {
    const {px, length, out} = onScreen(view, side.ends);
    return stations(length, 28).map(part => { const foot = between(px, part); return arrow(plus(foot, SURCHARGE_PX, out), foot); });
  });
  const longest = free.map(side => onScreen(view, side.ends)).sort((a, b) => b.length - a.length)[0];
  const at = longest && plus(between(longest.px, .5), SURCHARGE_PX + 6, longest.out);
  return svg('g', {class: 'acting small'}, ...arrows, longest ? svg('text', {x: at[0], y: at[1], 'text-anchor': 'middle', class: 'value'}, `${pressed(value)} ${unit('kPa')}`) : null);
}

// The water table with its triangle, and open water.
function water(view, {table, ponds, surface}) {
  const parts = ponds.map(corners => svg('path', {d: `M${corners.map(p => view.px(p)).join('L')}Z`, class: 'pond'}));
  parts.push(path(surface.map(line => line.map(p => view.px(p))), {class: 'table'}));
  for (const line of table) {
    const px = line.map(p => view.px(p));
    parts.push(path([px], {class: 'table'}));
    const [x, y] = between([px[0], px[1] ?? px[0]], .12);
    parts.push(svg('path', {d: `M${x} ${y - 1}l-6 -10h12Z`, class: 'mark'}), svg('path', {d: `M${x - 5} ${y + 4}h10M${x - 2.5} ${y + 7}h5`, class: 'table'}));
  }
  return svg('g', {class: 'water'}, ...parts);
}

// All symbols of what was understood.
export function symbols(view, {sides, loads, surcharge: pressure, table, ponds, free_surface: surface, motion, shaking}) {
  const most = Math.max(0, ...loads.flatMap(one => one.pressure).map(Math.abs));
  const parts = [water(view, {table, ponds, surface}), ...sides.filter(side => side.kind !== 'load').flatMap(side => support(view, side))];
  if (pressure) parts.push(surcharge(view, sides, pressure));
  parts.push(...loads.map(one => load(view, one, most)));
  if (motion) {
    const [from, [x, y]] = motion, start = view.px(from);
    parts.push(arrow(start, plus(start, MOTION_PX, [x, -y]), {class: 'motion'}));
  }
  shaking.forEach(([words, [x, y]], k) => {
    const at = [90 + 170 * k, 40];
    parts.push(arrow(plus(at, -24, [x, -y]), plus(at, 24, [x, -y]), {class: 'acting live'}), svg('text', {x: at[0], y: at[1] - 12, 'text-anchor': 'middle', class: 'value'}, words));
  });
  return parts;
}
