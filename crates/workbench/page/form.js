// Fields of an entry: each writes what is typed into the document, and shows what is wrong with it.
import {html} from './dom.js';
import {list} from './model.js';
import {fromField, toField, unit as named} from './units.js';

// A number as people type it; null if it is none.
export function parse(words) {
  const plain = words.trim().replace('−', '-').replace(',', '.');
  return /^[+-]?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?$/i.test(plain) && Number.isFinite(Number(plain)) ? Number(plain) : null;
}

// What a field of numbers says while it is no number.
export function complain(input, words) {
  input.setCustomValidity(words);
  input.toggleAttribute('aria-invalid', Boolean(words));
  if (words) input.setAttribute('aria-invalid', 'true');
  input.title = words;
}

export class Form {
  // `write(edit, join)` changes the document; `path` is where the entry is, such as `soil.0`.
  constructor(problem, of, path, write) { Object.assign(this, {problem, of, path, write}); }

  rows(fields) { return fields.filter(field => !field.only || field.only(this.of)).map(field => this.row(field)); }

  row(field) {
    const id = `${this.path}.${field.key}`, control = this[field.kind](field, id);
    if (field.kind === 'words') return control;
    const label = html('label', {for: id, title: field.title}, field.label);
    const unit = field.unit ? html('span', {class: 'unit'}, named(field.unit)) : null;
    return html('div', {class: `field ${field.kind}`, 'data-path': id, title: field.help}, label, html('span', {class: 'control'}, control, unit), html('p', {class: 'wrong', id: `${id}.wrong`, hidden: true}));
  }

  set(key, value, join = true) { this.write(of => { if (value === undefined) delete of[key]; else of[key] = value; }, join ? `${this.path}.${key}` : null); }

  number({key, optional, zero, unit, label}, id) {
    const value = toField(this.of[key], unit);
    const input = html('input', {id, inputmode: 'decimal', autocomplete: 'off', value: value ?? (zero ? 0 : ''), placeholder: optional ? 'not said' : null,
      'aria-label': unit ? `${label} in ${named(unit)}` : null, 'aria-describedby': `${id}.wrong`,
      input: () => {
        const found = parse(input.value);
        if (found !== null) { complain(input, ''); this.set(key, zero && found === 0 ? undefined : fromField(found, unit)); }
        else if (optional && !input.value.trim()) { complain(input, ''); this.set(key, undefined); }
        else complain(input, 'this is no number');
      }});
    return input;
  }

  text({key, optional}, id) {
    const input = html('input', {id, autocomplete: 'off', value: this.of[key] ?? '', 'aria-describedby': `${id}.wrong`,
      input: () => this.set(key, optional && !input.value ? undefined : input.value)});
    return input;
  }

  choice({key, options, optional}, id) {
    const select = html('select', {id, 'aria-describedby': `${id}.wrong`, change: () => this.set(key, optional && !select.value ? undefined : select.value, false)},
      ...options.map(([value, words]) => html('option', {value}, words)));
    select.value = this.of[key] ?? '';
    return select;
  }

  soil({key}, id) {
    const names = list(this.problem, 'soil').map(soil => soil.name);
    if (!names.includes(this.of[key])) names.push(this.of[key] ?? '');
    return this.choice({key, options: names.map(name => [name, name])}, id);
  }

  flag({key}, id) {
    const input = html('input', {id, type: 'checkbox', checked: Boolean(this.of[key]), change: () => this.set(key, input.checked || undefined, false)});
    return input;
  }

  // Any of some words.
  words({key, label, options}, id) {
    const boxes = options.map(side => {
      const input = html('input', {type: 'checkbox', id: `${id}.${side}`, checked: (this.of[key] ?? []).includes(side), change: () => {
        const now = options.filter(one => document.getElementById(`${id}.${one}`).checked);
        this.set(key, now.length ? now : undefined, false);
      }});
      return html('label', {for: `${id}.${side}`}, input, ` ${side}`);
    });
    return html('fieldset', {class: 'field words', 'data-path': id}, html('legend', null, label), ...boxes, html('p', {class: 'wrong', id: `${id}.wrong`, hidden: true}));
  }

  // One value, or one at each end of the line.
  profile({key, label, unit, empty = '0'}, id) {
    const value = this.of[key], ends = (Array.isArray(value) ? value : [value, undefined]).map(end => toField(end, unit));
    const inputs = ['', '.end'].map((part, k) => html('input', {id: id + part, inputmode: 'decimal', autocomplete: 'off', value: ends[k] ?? '', placeholder: k ? 'the same' : empty,
      'aria-label': `${label} in ${named(unit)}${k ? ', at the end of the line if it differs' : ''}`, 'aria-describedby': `${id}.wrong`,
      input: () => {
        const found = inputs.map(input => input.value.trim() ? parse(input.value) : undefined);
        inputs.forEach((input, i) => complain(input, found[i] === null ? 'this is no number' : ''));
        if (found.includes(null)) return;
        const [from, to] = found.map(end => fromField(end, unit));
        this.set(key, to === undefined ? from : [from ?? 0, to]);
      }}));
    return html('span', {class: 'pair'}, inputs[0], html('span', {'aria-hidden': 'true'}, 'to'), inputs[1]);
  }
}

// The points of a shape as a table: exact coordinates, points added and removed.
export function pointTable(shape, editor, write) {
  const path = `${shape.section}${shape.index === null ? '' : `.${shape.index}`}.${shape.key}`;
  const cell = (k, axis) => {
    const input = html('input', {inputmode: 'decimal', autocomplete: 'off', value: toField(shape.points[k][axis], 'm'), id: `${path}.${k}.${'xy'[axis]}`, 'aria-label': `${'xy'[axis]} of point ${k + 1} in ${named('m')}`,
      focus: () => { if (editor.point !== k) editor.choose(shape, k); },
      input: () => {
        const found = parse(input.value);
        complain(input, found === null ? 'this is no number' : '');
        if (found !== null) write(points => { points[k][axis] = fromField(found, 'm'); }, `${path}.${k}.${axis}`);
      }});
    return html('td', null, input);
  };
  const act = (words, title, run) => html('button', {type: 'button', class: 'small', title, 'aria-label': title, click: run}, words);
  const rows = shape.points.map((_, k) => html('tr', {'data-point': k, class: editor.point === k ? 'chosen' : null}, html('th', {scope: 'row'}, k + 1), cell(k, 0), cell(k, 1), html('td', null,
    act('+', `Insert a point after point ${k + 1}`, () => {
      const after = shape.points[(k + 1) % shape.points.length], here = shape.points[k];
      const isLast = k === shape.points.length - 1 && !shape.closed;
      editor.insert(shape, k, isLast ? [here[0] + 1, here[1]] : [(here[0] + after[0]) / 2, (here[1] + after[1]) / 2]);
    }),
    act('×', `Remove point ${k + 1}`, () => { editor.choose(shape, k); editor.remove(); }))));
  return html('div', {class: 'field', 'data-path': path},
    html('table', {class: 'points'}, html('caption', null, `Points in ${named('m')}`), html('thead', null, html('tr', null, html('th', {scope: 'col'}, ''), html('th', {scope: 'col'}, 'x'), html('th', {scope: 'col'}, 'y'), html('th', {scope: 'col'}, html('span', {class: 'hear'}, 'change')))), html('tbody', null, ...rows)),
    html('p', {class: 'wrong', id: `${path}.wrong`, hidden: true}));
}
