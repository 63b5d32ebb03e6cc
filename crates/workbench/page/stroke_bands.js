// Friction angle and density: the band of each measurement, and the soils that explain all of them. A band that is dragged upwards is of a
// greater force, since density is in proportion to it.
import {get, short, svg} from './dom.js';
import {size} from './plate_section.js';

const LEFT = 46, BOTTOM = 34, TOP = 8, RIGHT = 10;

const ticks = (low, high, count) => {
  const size = 10 ** Math.floor(Math.log10((high - low) / count)), unit = size * [1, 2, 5, 10].find(digit => digit * size >= (high - low) / count), found = [];
  for (let value = Math.ceil(low / unit) * unit; value <= high + 1e-9 * unit; value += unit) found.push(Number(value.toPrecision(8)));
  return found;
};

export class Bands {
  // `rows` pulls the force of a measurement.
  constructor(rows) {
    Object.assign(this, {rows, place: get('bands'), held: null, extent: null});
    this.place.addEventListener('pointerdown', event => this.take(event));
    this.place.addEventListener('pointermove', event => this.drag(event));
    for (const end of ['pointerup', 'pointercancel']) this.place.addEventListener(end, () => { if (this.held) { this.held = null; this.draw(); } });
  }

  // `soil` is that of the sliders.
  show(shown, soil) { Object.assign(this, {shown, soil}); this.draw(); }

  draw() {
    const {place, shown, soil} = this;
    if (!shown) { place.replaceChildren(); return; }
    const {width, height} = size(place), {answer, bands, delta_deg: delta} = shown;
    // The picture stays where it is while a band is dragged.
    if (!this.held || !this.extent) this.extent = shown.extent;
    const [[left, right], [low, high]] = this.extent;
    Object.assign(this, {x: phi => LEFT + (phi - left) / (right - left) * (width - LEFT - RIGHT), y: rho => height - BOTTOM - (rho - low) / (high - low) * (height - BOTTOM - TOP), rho: y => low + (height - BOTTOM - y) / (height - BOTTOM - TOP) * (high - low)});
    const {x, y} = this, outline = polygons => polygons.flat().map(ring => `M${ring.map(([phi, rho]) => `${x(phi).toFixed(1)} ${y(rho).toFixed(1)}`).join('L')}Z`).join('');
    const net = svg('g', {class: 'net'});
    for (const phi of ticks(left, right, width / 70)) net.append(svg('path', {d: `M${x(phi)} ${TOP}V${height - BOTTOM}`, class: 'rule'}), svg('text', {x: x(phi), y: height - BOTTOM + 14, 'text-anchor': 'middle'}, short(phi)));
    for (const rho of ticks(low, high, height / 50)) net.append(svg('path', {d: `M${LEFT} ${y(rho)}H${width - RIGHT}`, class: 'rule'}), svg('text', {x: LEFT - 5, y: y(rho) + 4, 'text-anchor': 'end'}, short(rho)));
    net.append(svg('text', {x: (LEFT + width - RIGHT) / 2, y: height - 4, 'text-anchor': 'middle'}, 'friction angle φ in °'), svg('text', {transform: `translate(10 ${(TOP + height - BOTTOM) / 2}) rotate(-90)`, 'text-anchor': 'middle'}, 'density ρ in kg/m³'));
    const inside = svg('g', {'clip-path': 'url(#bands-frame)'}, ...bands.map(({polygons}, k) => svg('path', {d: outline(polygons), 'fill-rule': 'evenodd', class: `band band-${k % 8}`, 'data-band': k})));
    inside.append(svg('path', {d: outline(answer.region), 'fill-rule': 'evenodd', class: 'region-all'}), svg('path', {d: outline(shown.shared), 'fill-rule': 'evenodd', class: 'region-here'}));
    bands.forEach(({polygons}, k) => {
      const phi = left + (k + 1) / (bands.length + 1) * (right - left), middle = across(polygons, phi);
      if (middle !== null && middle > low && middle < high) inside.append(svg('circle', {cx: x(phi), cy: y(middle), r: 9, class: 'number'}), svg('text', {x: x(phi), y: y(middle) + 4, 'text-anchor': 'middle', class: 'strong'}, k + 1));
    });
    if (answer.best_estimate) inside.append(mark(x(answer.best_estimate.phi_deg), y(answer.best_estimate.density_kg_m3), 'best'));
    inside.append(mark(x(soil.phi_deg), y(soil.density_kg_m3), 'mine'));
    const clip = svg('clipPath', {id: 'bands-frame'}, svg('rect', {x: LEFT, y: TOP, width: Math.max(1, width - LEFT - RIGHT), height: Math.max(1, height - TOP - BOTTOM)}));
    place.replaceChildren(clip, net, inside);
    get('bands-words').textContent = `Bands at δ ${short(delta, 3)}°; outlined: what they share there; filled: all soils for δ ${short(answer.delta_deg[0], 3)}° to ${short(answer.delta_deg[1], 3)}°. Diamond: least misfit. Cross: the soil of the sliders.`;
  }

  take(event) {
    const k = event.target.dataset?.band, box = this.place.getBoundingClientRect();
    if (k === undefined || event.button) return;
    event.preventDefault();
    const rho = this.rho(event.clientY - box.top);
    if (!(rho > 0)) return;
    this.place.setPointerCapture(event.pointerId);
    // What it had when it was taken. `top` stays: only the pointer pulls, not an answer that makes the page above longer meanwhile.
    this.held = {k: Number(k), top: box.top, rho, base: structuredClone(this.rows.base[k])};
    this.rows.table.rest();
  }

  drag(event) {
    const {held} = this;
    if (!held) return;
    this.rows.base[held.k] = held.base;
    this.rows.pull(held.k, Math.max(1, this.rho(event.clientY - held.top)) / held.rho);
  }
}

// The middle of polygons at a friction angle.
function across(polygons, phi) {
  const found = [];
  for (const ring of polygons.flat()) ring.forEach((a, k) => {
    const b = ring[(k + 1) % ring.length];
    if (a[0] > phi !== b[0] > phi) found.push(a[1] + (phi - a[0]) / (b[0] - a[0]) * (b[1] - a[1]));
  });
  return found.length ? (Math.min(...found) + Math.max(...found)) / 2 : null;
}

const mark = (x, y, kind) => svg('path', {class: `mark-${kind}`, d: kind === 'best' ? `M${x} ${y - 6}L${x + 6} ${y}L${x} ${y + 6}L${x - 6} ${y}Z` : `M${x - 6} ${y}H${x + 6}M${x} ${y - 6}V${y + 6}`});
