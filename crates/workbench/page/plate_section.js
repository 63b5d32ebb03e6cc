// The plate in the ground, and the surfaces along which the soil fails.
import {get, short, svg} from './dom.js';
import {NAMES} from './plate_forces.js';

// As much of the plate is drawn, in wetted lengths.
const OUT = 1.35;

export function size(place) {
  const {width, height} = place.getBoundingClientRect();
  place.setAttribute('viewBox', `0 0 ${width} ${height}`);
  return {width: Math.max(60, width), height: Math.max(60, height)};
}

// Models with a surface, those with the same one together; each has a line of its own kind.
export function lines(models) {
  const found = new Map();
  for (const {id, ends, surface_m} of models) {
    if (!surface_m) continue;
    const key = JSON.stringify(surface_m), known = found.get(key);
    if (known) known.ids.push(`${id} ${ends}`); else found.set(key, {points: surface_m, ids: [`${id} ${ends}`], kind: id});
  }
  return [...found.values()];
}

// The sign of a model's line, for the table of forces.
export function swatch(all, {id, ends}) {
  const line = all.find(one => one.ids.includes(`${id} ${ends}`));
  return line && svg('svg', {class: 'key', viewBox: '0 0 22 8', 'aria-hidden': 'true'}, svg('path', {d: 'M0 4H22', class: `surface of-${line.kind}`}));
}

export function section(values, {top_m: top, models}, all) {
  const place = get('ground'), {width, height} = size(place);
  const slope = Math.tan(values.beta_deg * Math.PI / 180), long = Math.hypot(...top);
  const reach = Math.max(1.2 * long, ...all.map(({points}) => points.at(-1)[0] - top[0])) * 1.12;
  const behind = top[0] - Math.max(.6 * long, .14 * reach), ahead = top[0] + reach;
  const surface = x => top[1] + (x - top[0]) * slope;
  const ys = [surface(behind), surface(ahead), OUT * top[1], 0, ...all.flatMap(({points}) => points.map(p => p[1]))];
  const low = Math.min(...ys) - .25 * long, high = Math.max(...ys) + .12 * long;
  const scale = Math.min((width - 8) / (ahead - behind), (height - 22) / (high - low));
  const at = ([x, y]) => [4 + (x - behind) * scale, height - 18 - (y - low) * scale].map(value => Number(value.toFixed(2)));
  const path = points => `M${points.map(at).join('L')}`;
  // The ground fills the picture, however wide that is.
  const [left, right] = [behind - 4 / scale, behind + (width + 4) / scale];
  const parts = [
    svg('path', {d: `${path([[left, surface(left)], [right, surface(right)]])}L${width} ${height}L0 ${height}Z`, class: 'soil tint-0'}),
    svg('path', {d: path([[left, surface(left)], [right, surface(right)]]), class: 'ground'}),
    ...all.map(({points, kind, ids}) => svg('path', {d: path(points), class: `surface of-${kind}`, 'data-models': ids.join(', ')})),
    svg('path', {d: path([[0, 0], [OUT * top[0], OUT * top[1]]]), class: 'blade'}),
    arrow(at([top[0] / 3, top[1] / 3]), values, Math.min(.34 * width, 70)),
    ruler(scale, width, height),
  ];
  place.replaceChildren(...parts);
  const names = all.map(({ids}) => ids.map(id => NAMES[id.split(' ')[0]]).join(', '));
  const far = all.map(({points}) => points.at(-1)[0] - top[0]);
  get('ground-words').textContent = all.length ? `Slip lines come up ${short(Math.min(...far), 2)} to ${short(Math.max(...far), 2)} m ahead of the plate: ${names.join('; ')}.` : 'No model has a slip line here.';
}

// The force of the plate on the soil, inclined downwards from the plate's normal by the friction between them.
function arrow([x, y], {alpha_deg, delta_deg}, long) {
  const turn = (90 - alpha_deg - delta_deg) * Math.PI / 180, [dx, dy] = [Math.cos(turn), -Math.sin(turn)];
  const end = [x, y], from = [x - long * dx, y - long * dy], head = [-1, 1].map(side => [x - 9 * dx + 4 * side * dy, y - 9 * dy - 4 * side * dx]);
  return svg('g', {class: 'acting'}, svg('path', {d: `M${from}L${end}`, class: 'shaft'}), svg('path', {d: `M${end}L${head[0]}L${head[1]}Z`, class: 'head'}));
}

function ruler(scale, width, height) {
  const size = 10 ** Math.floor(Math.log10(width / 4 / scale)), length = size * [5, 2, 1].find(digit => digit * size * scale <= width / 3.2);
  const x = width - 10 - length * scale, y = height - 8;
  return svg('g', {class: 'ruler'}, svg('path', {d: `M${x} ${y - 4}v4h${length * scale}v-4`}), svg('text', {x: x - 6, y: y + 1, 'text-anchor': 'end'}, `${short(1000 * length)} mm`));
}
