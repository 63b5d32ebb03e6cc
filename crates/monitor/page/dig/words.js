// What is told in words: readings, limits, and what is said to those who hear the page.
const HELD = {none: '', reach: 'At the end of the arm’s reach', force: 'The soil pushes back as hard as the arm may push', torque: 'The arm pushes as hard as it can'};
const SAY_MS = 2500;

export const number = (value, digits, unit) => value === null || value === undefined || !Number.isFinite(value) ? '–' : `${value.toFixed(digits).replace(/^-(0(\.0*)?)$/, '$1').replace('-', '−')} ${unit}`;
export const heldWords = limit => HELD[limit] ?? '';

export function faultWords(fault) {
  return `${fault.kind.replaceAll('_', ' ')}: ${Number(fault.value.toPrecision(3))}, limit ${Number(fault.limit.toPrecision(3))}`;
}

// Where the force points, for people: of the larger of its parts.
function direction([r, t, z]) {
  const parts = [[Math.abs(r), r > 0 ? 'outwards' : 'inwards'], [Math.abs(t), t > 0 ? 'to the left' : 'to the right'], [Math.abs(z), z > 0 ? 'up' : 'down']];
  const most = Math.max(...parts.map(([size]) => size));
  return parts.filter(([size]) => size > .4 * most).sort((a, b) => b[0] - a[0]).map(([, name]) => name).join(' and ');
}

// What the force is, in a sentence.
export function forceWords(state, depth_m, limit) {
  const size = Math.hypot(...state.force_rtz_n);
  const force = size < .5 ? 'no force' : `${size.toFixed(0)} newtons, ${direction(state.force_rtz_n)}`;
  const depth = depth_m > .001 ? `${Math.round(1000 * depth_m)} millimetres deep` : 'above the soil';
  return [force, depth, heldWords(limit)].filter(Boolean).join('; ');
}

// Says a sentence now and then, if it has changed; a new limit at once.
export class Speaker {
  constructor(place) { Object.assign(this, {place, last: 0, text: '', limit: 'none'}); }
  say(text, limit) {
    const now = performance.now();
    if (text === this.text || (limit === this.limit && now - this.last < SAY_MS)) return;
    Object.assign(this, {text, limit, last: now});
    this.place.textContent = text;
  }
}
