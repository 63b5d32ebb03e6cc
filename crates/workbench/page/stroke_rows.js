// One row a measurement: its number and line in the picture, and a slider for its force.
import {get, html, short, svg} from './dom.js';

export const swatch = k => svg('svg', {class: 'key', viewBox: '0 0 22 12', 'aria-hidden': 'true'}, svg('rect', {x: 1, y: 1, width: 20, height: 10, class: `band band-${k % 8}`}));

export class StrokeRows {
  constructor(table) { Object.assign(this, {table, outline: '', base: [], rows: []}); }

  // What was found of the table as it is now; `isSettled` says that nothing is dragged beyond that.
  show({answer, bands}, isSettled) {
    const {measurements, disagreement} = answer;
    if (isSettled) this.base = measurements.map((one, k) => ({force: one.force_n, lines: bands[k].lines, forces: this.table.forces(bands[k].lines)}));
    const outline = measurements.map((one, k) => `${one.label} ${bands[k].lines}`).join('|');
    if (outline !== this.outline) {
      this.outline = outline;
      this.rows = measurements.map((one, k) => this.row(one, k));
      get('rows').replaceChildren(html('table', null, html('caption', null, 'Drag a force here, or a band in the picture'), html('tbody', null, ...this.rows.map(row => row.element))));
    }
    measurements.forEach((one, k) => {
      const {range, words, element} = this.rows[k];
      if (document.activeElement !== range) Object.assign(range, {min: Math.min(range.min, one.force_n), max: Math.max(range.max, one.force_n)}).value = one.force_n;
      words.textContent = `${short(one.force_n, 3)} N (${short(one.force_low_n, 3)} to ${short(one.force_high_n, 3)})`;
      element.classList.toggle('bad', Boolean(disagreement && (disagreement.culprits.includes(one.label) || disagreement.alone.includes(one.label))));
    });
  }

  row(one, k) {
    const range = html('input', {type: 'range', min: .25 * one.force_n, max: 2.5 * one.force_n, step: .002 * one.force_n, 'aria-label': `force of stroke ${k + 1}, ${one.label}, in N`, input: () => this.pull(k, Number(range.value) / this.base[k].force)});
    const words = html('output');
    const count = one.strokes > 1 ? ` × ${one.strokes}` : '';
    const element = html('tr', {'data-row': k}, html('th', {scope: 'row'}, swatch(k), html('b', null, k + 1), ` · ${one.label}${count}`), html('td', null, range, words));
    return {range, words, element};
  }

  // Multiplies the forces that a measurement had by a factor.
  pull(k, factor) {
    const {lines, forces} = this.base[k] ?? {lines: [], forces: []};
    if (factor > 0 && Number.isFinite(factor)) this.table.write(lines, forces.map(force => force === null ? null : force * factor), `pull ${k}`);
  }
}
