// Which forces the soil bears, by their direction: a fan in front of the plate, which stands as in the section.
import {get, short, svg} from './dom.js';
import {size} from './plate_section.js';

const RAD = Math.PI / 180;

// A length of 1, 2 or 5 times a power of ten, at most a third of the reach.
const step = reach => { const size = 10 ** Math.floor(Math.log10(reach / 3)); return size * [5, 2, 1].find(digit => digit * size <= reach / 3); };

// A value of a curve between its points.
function along(points, angle, k) {
  const next = points.findIndex(one => one[0] >= angle);
  if (next < 0 || angle < points[0][0]) return null;
  if (next === 0) return points[0][k];
  const [a, b] = [points[next - 1], points[next]];
  return a[k] + (angle - a[0]) / (b[0] - a[0]) * (b[k] - a[k]);
}

export function borne(values, {borne: [bracket, mechanism]}) {
  const place = get('borne'), {width, height} = size(place);
  const {alpha_deg: alpha, delta_deg: delta, phi_deg: phi} = values;
  const forces = [...bracket.points.map(one => one[2]), ...mechanism.points.map(one => one[2])];
  const words = get('borne-words');
  if (!forces.length) {
    place.replaceChildren();
    words.textContent = `Nothing is known of them: ${bracket.error ?? mechanism.error}`;
    return;
  }
  const reach = Math.max(...forces), out = .24 * reach;
  const way = angle => (90 - alpha - angle) * RAD, place_of = (angle, force) => [force * Math.cos(way(angle)), force * Math.sin(way(angle))];
  // All that is drawn fits.
  const corners = [...[0, phi / 2, phi].map(angle => place_of(angle, 1.06 * reach)), ...[1, -1].map(side => [-side * out * Math.cos(alpha * RAD), side * out * Math.sin(alpha * RAD)]), [0, 0]];
  const [xs, ys] = [0, 1].map(axis => corners.map(corner => corner[axis])), low = [Math.min(...xs), Math.min(...ys)], high = [Math.max(...xs), Math.max(...ys)];
  const scale = Math.min((width - 70) / (high[0] - low[0]), (height - 30) / (high[1] - low[1]));
  const shift = [(width - 30 - (high[0] - low[0]) * scale) / 2, (height - (high[1] - low[1]) * scale) / 2];
  const at = ([x, y]) => [shift[0] + (x - low[0]) * scale, height - shift[1] - (y - low[1]) * scale].map(value => Number(value.toFixed(2)));
  const path = points => `M${points.map(at).join('L')}`, of = (points, k) => points.map(one => place_of(one[0], one[k]));
  const arc = force => path(Array.from({length: 25}, (_, k) => place_of(phi * k / 24, force)));
  const parts = [], unit = step(reach);
  for (let force = unit; force <= 1.001 * reach; force += unit) {
    const [x, y] = at(place_of(0, force));
    parts.push(svg('path', {d: arc(force), class: 'rule'}), svg('text', {x, y: y - 5, 'text-anchor': 'middle'}, short(force, 2)));
  }
  for (const angle of [0, phi]) parts.push(svg('path', {d: path([[0, 0], place_of(angle, 1.04 * reach)]), class: angle ? 'rule' : 'rule normal'}));
  if (bracket.points.length > 1) parts.push(
    svg('path', {d: `${path([[0, 0], ...of(bracket.points, 1)])}Z`, class: 'safe'}),
    svg('path', {d: `${path([...of(bracket.points, 1), ...of(bracket.points, 2).reverse()])}Z`, class: 'between'}),
    svg('path', {d: path(of(bracket.points, 1)), class: 'lower'}), svg('path', {d: path(of(bracket.points, 2)), class: 'upper'}));
  if (mechanism.points.length > 1) parts.push(svg('path', {d: path(of(mechanism.points, 2)), class: 'surface of-chen'}));
  const blade = [1, -1].map(side => [-side * out * Math.cos(alpha * RAD), side * out * Math.sin(alpha * RAD)]);
  parts.push(svg('path', {d: path(blade), class: 'blade'}));
  const here = along(bracket.points, delta, 2) ?? along(mechanism.points, delta, 2);
  if (here !== null) {
    const [x, y] = at(place_of(delta, 1.02 * Math.max(here, along(mechanism.points, delta, 2) ?? 0)));
    parts.push(svg('path', {d: path([[0, 0], place_of(delta, here)]), class: 'ray'}), svg('text', {x: x + 5, y: y + 10, class: 'strong'}, `δ ${short(delta, 3)}°`));
  }
  const [nx, ny] = at(place_of(phi, 1.02 * reach));
  parts.push(svg('text', {x: nx + 4, y: ny + 10}, `φ ${short(phi, 3)}°`));
  place.replaceChildren(...parts);
  const lower = along(bracket.points, delta, 1), upper = along(bracket.points, delta, 2), end = bracket.points.at(-1)?.[0];
  const told = lower === null ? `No bracket at δ ${short(delta, 3)}°: ${bracket.error ?? 'the table does not cover it'}` :
    `At ${short(delta, 3)}° to the normal the soil bears ${short(lower, 3)} N, and fails at ${short(upper, 3)} N at the latest`;
  const range = bracket.points.length && end < phi - 1e-9 ? ` The bracket is known up to ${short(end, 3)}° to the normal.` : '';
  words.textContent = `${told}. Angles are downwards from the plate's normal, forces in N. Filled: below both bounds. Dashed: Chen & Liu's upper bound, as part of an endless plate.${range}`;
}
