// A section line through a solution: stresses across and along it, their sums, and all that is known at one place of it.
import {get, html, say, short, svg} from './dom.js';
import {inUnit, unit} from './units.js';

const in_ = (name, value, digits = 4) => `${short(inUnit(value, name), digits)} ${unit(name)}`, pressed = value => short(inUnit(value, 'kPa'));
const WIDE = 320, TALL = 170, LEFT = 54, RIGHT = 12, TOP = 10, BOTTOM = 24;

export class Probe {
  // `later` draws the sheet at the next picture.
  constructor(link, solver, {tell, tab, later}) {
    Object.assign(this, {link, solver, tell, tab, later, line: null});
    get('probe-at').addEventListener('input', () => this.read());
    get('probe-off').addEventListener('click', () => this.close());
  }

  // Along the line between two points in m.
  async along([from, to], isAgain = false) {
    const {solver} = this;
    if (solver.state !== 'solved') { this.tell('a section line shows the stresses of a solution; solve the problem first', 'bad'); return; }
    const answer = await this.link.ask({type: 'probe', from, to}, 'probed');
    if (!answer || answer.error) { this.tell(answer?.error.words ?? 'there is no connection to the workbench', 'bad'); return; }
    Object.assign(this, {shown: answer.shown, line: {from, to, at: null}, of: solver.id});
    get('probe').hidden = false;
    this.read();
    if (isAgain) return;
    this.tab('result');
    say(get('probe-words').textContent);
  }

  // There is another solution.
  again() { if (this.line && this.of !== this.solver.id) this.along([this.line.from, this.line.to], true); }

  close() { this.line = null; get('probe').hidden = true; this.later(); }

  read() {
    const {shown} = this, place = shown.places[Number(get('probe-at').value)], {stress, velocity} = place;
    this.line.at = place.point_m;
    get('probe-place').textContent = in_('m', place.at_m, 3);
    get('probe-chart').replaceChildren(this.chart(place));
    const sums = shown.normal_kn_per_m === null ? 'No stresses are known: there is no lower bound.' : `All along ${in_('m', shown.length_m, 3)}: ${in_('kN/m', shown.normal_kn_per_m)} across it, ${in_('kN/m', shown.shear_kn_per_m)} along it.`;
    const outside = shown.outside_m > 0 ? ` ${in_('m', shown.outside_m, 2)} of it are in no soil.` : '';
    const here = stress ? `Here σ ${pressed(stress.normal_kpa)} and τ ${in_('kPa', stress.shear_kpa)}; principal ${pressed(stress.major_kpa)} (at ${short(stress.major_deg, 3)}°) and ${in_('kPa', stress.minor_kpa)}` : 'Here is no stress';
    const moves = velocity ? `; moves ${short(velocity[0], 2)}, ${short(velocity[1], 2)} of the fastest.` : '.';
    get('probe-words').replaceChildren(html('span', {'data-normal': shown.normal_kn_per_m, 'data-shear': shown.shear_kn_per_m}, `${sums}${outside}`), html('br'), `${here}${moves} Total stresses of the lower bound's field, compression positive; τ is positive where the soil on the left of the line pushes that on the right forwards.`);
    this.later();
  }

  chart(place) {
    const known = this.shown.places.filter(one => one.stress), chart = svg('svg', {viewBox: `0 0 ${WIDE} ${TALL}`, class: 'scale', role: 'img', 'aria-label': 'normal and shear stress along the section line'});
    if (!known.length) return chart;
    const values = known.flatMap(({stress}) => [stress.normal_kpa, stress.shear_kpa]).map(value => inUnit(value, 'kPa')), low = Math.min(0, ...values), high = Math.max(0, ...values, low + 1e-9);
    const x = at => LEFT + at / this.shown.length_m * (WIDE - LEFT - RIGHT), y = value => TOP + (high - value) / (high - low) * (TALL - TOP - BOTTOM);
    for (let k = 0; k <= 4; k++) { const value = low + k / 4 * (high - low); chart.append(svg('path', {d: `M${LEFT} ${y(value)}H${WIDE - RIGHT}`, class: 'rule'}), svg('text', {x: LEFT - 6, y: y(value) + 4, 'text-anchor': 'end'}, short(value, 3))); }
    chart.append(svg('path', {d: `M${LEFT} ${y(0)}H${WIDE - RIGHT}`, class: 'zero'}), svg('path', {d: `M${x(place.at_m)} ${TOP}V${TALL - BOTTOM}`, class: 'here'}));
    for (const [key, kind] of [['normal_kpa', 'lower'], ['shear_kpa', 'upper']]) {
      // A gap in the soil is a gap in the curve.
      const parts = this.shown.places.map((one, k, all) => one.stress ? `${all[k - 1]?.stress ? 'L' : 'M'}${x(one.at_m).toFixed(1)} ${y(inUnit(one.stress[key], 'kPa')).toFixed(1)}` : '');
      chart.append(svg('path', {d: parts.join(''), class: kind}));
    }
    chart.append(svg('text', {x: LEFT, y: TALL - 6}, `σ in ${unit('kPa')}: solid; τ: dashed`), svg('text', {x: WIDE - RIGHT, y: TALL - 6, 'text-anchor': 'end'}, in_('m', this.shown.length_m, 3)));
    return chart;
  }
}
