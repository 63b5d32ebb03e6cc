// Sliders, each with a field for the exact number. What is typed may lie beyond the slider's ends.
import {html, short} from './dom.js';
import {parse} from './form.js';

export class Sliders {
  // `all` are {key, name, unit, scale, low, high, step}; a value times `scale` is what is shown. `changed` is told the key.
  constructor(values, all, changed) {
    Object.assign(this, {values, all, changed, parts: new Map()});
    this.rows = all.map(one => this.row(one));
  }

  row(one) {
    const {key, name, unit, low, high, step} = one;
    const range = html('input', {type: 'range', id: `slide.${key}`, min: low, max: high, step, 'aria-label': `${name} in ${unit}`, input: () => this.set(one, Number(range.value), range)});
    const field = html('input', {id: `field.${key}`, inputmode: 'decimal', autocomplete: 'off', 'aria-label': `${name} in ${unit}, exactly`, input: () => {
      const value = parse(field.value);
      field.setAttribute('aria-invalid', String(value === null));
      if (value !== null) this.set(one, value, field);
    }, change: () => this.show()});
    this.parts.set(key, {range, field});
    return html('div', {class: 'slide'}, html('span', null, name), range, html('span', {class: 'control'}, field, html('span', {class: 'unit'}, unit)));
  }

  set({key, scale}, shown, by) {
    this.values[key] = shown / scale;
    this.show(by);
    this.changed(key);
  }

  // Writes values into all fields but the one that they come from.
  show(by = null) {
    for (const {key, scale} of this.all) {
      const {range, field} = this.parts.get(key), shown = this.values[key] * scale;
      if (range !== by) range.value = shown;
      if (field !== by) { field.value = short(shown, 5).replace('−', '-'); field.setAttribute('aria-invalid', 'false'); }
    }
  }
}
