// The panel of the problem: what is asked for, soils, entries, and the fields of the one that is chosen.
import {get, html} from './dom.js';
import * as fields from './fields.js';
import {Form, pointTable} from './form.js';
import * as model from './model.js';
import {swatch} from './palette.js';
import {lawOf, strength} from './strength.js';

export class Panel {
  constructor(store, editor) { Object.assign(this, {store, editor, open: new Set()}); }

  get problem() { return this.store.problem; }

  // Makes the fields anew, unless somebody types in one: then only when what there is to fill in has changed.
  update(force = false) {
    this.part('general', this.general(), force);
    this.part('soils', this.soils(), force);
    this.part('entries', this.entries(), force);
    this.part('chosen', this.chosen(), force);
    this.part('more', this.more(), force);
  }

  part(id, made, force) {
    const place = get(id), focus = place.contains(document.activeElement) ? document.activeElement : null;
    const isTyping = focus?.matches('input:not([type=checkbox])');
    const outline = made.map(one => one.dataset?.key ?? '').join('|');
    if (isTyping && !force && place.dataset.outline === outline) return this.refresh(place, made, focus);
    place.dataset.outline = outline;
    place.replaceChildren(...made);
    if (focus?.id) document.getElementById(focus.id)?.focus({preventScroll: true});
  }

  // Values of all fields but the one that is typed in, which keeps its caret.
  refresh(place, made, focus) {
    const box = html('div', null, ...made);
    for (const input of place.querySelectorAll('input, select')) {
      const now = input.id && box.querySelector(`[id="${input.id}"]`);
      if (!now || input === focus) continue;
      if (input.type === 'checkbox') input.checked = now.checked; else input.value = now.value;
    }
  }

  form(of, path, find) {
    return new Form(this.problem, of, path, (edit, join) => this.store.change(draft => edit(find(draft)), join));
  }

  general() {
    const {problem} = this, aim = problem.objective ?? {};
    const kind = html('select', {id: 'objective.kind', change: () => this.store.change(draft => { draft.objective = this.aim(draft, kind.value); })}, ...fields.OBJECTIVES.map(([value, words]) => html('option', {value}, words)));
    kind.value = aim.kind;
    const rows = [html('div', {class: 'field', 'data-path': 'objective.kind'}, html('label', {for: 'objective.kind'}, 'Bound the'), html('span', {class: 'control'}, kind), html('p', {class: 'wrong', hidden: true}))];
    const form = this.form(aim, 'objective', draft => draft.objective);
    if (aim.kind === 'structure') {
      const names = [...new Set([...model.list(problem, 'structure'), ...model.list(problem, 'plate')].map(of => of.name))];
      if (!names.includes(aim.name)) names.push(aim.name ?? '');
      rows.push(form.row({key: 'name', label: 'of', kind: 'choice', options: names.map(name => [name, name])}));
      rows.push(html('div', {class: 'two'}, ...[0, 1].map(axis => {
        const part = new Form(problem, aim.direction ?? [0, 0], 'objective.direction', (edit, join) => this.store.change(draft => edit(draft.objective.direction), join));
        return part.row({key: axis, label: axis ? 'motion upwards' : 'motion to the right', kind: 'number'});
      })));
    }
    if (aim.kind === 'seismic') rows.push(form.row({key: 'leftwards', label: 'pushes to the left', kind: 'flag'}));
    const whole = this.form(problem, 'problem', draft => draft);
    return [html('div', {'data-key': `general ${aim.kind} ${rows.length}`}, ...whole.rows(fields.PROBLEM.slice(0, 1)), ...rows, ...whole.rows(fields.PROBLEM.slice(1)))];
  }

  aim(draft, kind) {
    if (kind !== 'structure') return {kind};
    const first = model.list(draft, 'structure')[0] ?? model.list(draft, 'plate')[0];
    return {kind, name: first?.name ?? 'structure', direction: [1, 0]};
  }

  soils() {
    const soils = model.list(this.problem, 'soil');
    const cards = soils.map((soil, index) => {
      const form = this.form(soil, `soil.${index}`, draft => draft.soil[index]);
      form.text = ({key}, id) => {
        const input = html('input', {id, autocomplete: 'off', value: soil[key] ?? '', input: () => this.store.change(draft => model.renameSoil(draft, index, input.value), id)});
        return input;
      };
      const pick = html('input', {type: 'radio', name: 'soil', id: `pick.${index}`, checked: this.editor.soil === index, change: () => { this.editor.soil = index; }});
      const [name, ...values] = form.rows(fields.SOIL);
      const inUse = model.list(this.problem, 'region').some(region => region.soil === soil.name);
      const law = strength(this.problem, soil, index, (edit, join) => this.store.change(draft => edit(draft.soil[index]), join));
      const more = html('details', {open: this.open.has(index), toggle: event => { if (event.target.open) this.open.add(index); else this.open.delete(index); }}, html('summary', null, 'More'),
        lawOf(soil) ? null : law,
        html('div', {class: 'two'}, ...form.rows(fields.SOIL_MORE)),
        html('button', {type: 'button', disabled: inUse, title: inUse ? 'regions are of this soil' : null, click: () => this.store.change(draft => { draft.soil.splice(index, 1); })}, 'Remove this soil'));
      return html('div', {class: 'soil', 'data-key': `soil ${index} ${lawOf(soil)} ${soil.strength?.points_kpa?.length}`}, html('div', {class: 'head'}, html('label', {for: `pick.${index}`, title: 'new regions are of this soil'}, pick, swatch(index), html('span', {class: 'hear'}, `draw with soil ${index + 1}`)), name), html('div', {class: 'three'}, ...values), lawOf(soil) ? law : null, more);
    });
    return [...cards, html('button', {type: 'button', id: 'add-soil', 'data-key': 'add', click: () => { this.editor.soil = this.store.change(model.addSoil); this.update(); }}, 'Add a soil')];
  }

  entries() {
    const {problem} = this, soils = model.list(problem, 'soil').map(soil => soil.name), all = [];
    for (const section of model.SECTIONS) {
      if (section === 'water') { if (problem.water) all.push({section, index: null}); continue; }
      model.list(problem, section).forEach((_, index) => all.push({section, index}));
    }
    const item = at => {
      const isChosen = model.isSame(at, this.editor.chosen), of = model.entry(problem, at);
      const sign = at.section === 'region' ? swatch(Math.max(0, soils.indexOf(of.soil))) : html('i', {class: `sign ${at.section}`, 'aria-hidden': 'true'});
      return html('li', {'data-entry': `${at.section}.${at.index ?? ''}`}, html('button', {type: 'button', 'aria-pressed': String(isChosen), click: () => this.editor.choose(isChosen ? null : at)}, sign, html('span', null, html('b', null, at.section === 'water' ? 'water' : at.section), ` ${model.label(problem, at)}`)));
    };
    const sides = html('button', {type: 'button', id: 'add-sides', click: () => {
      const index = this.store.change(draft => (draft.boundary ??= []).push({kind: 'fixed', sides: ['bottom']}) - 1);
      this.editor.choose({section: 'boundary', index});
    }}, 'Hold a whole side');
    const words = all.length ? null : html('p', {class: 'faint'}, 'Nothing is drawn yet. Take the tool Region and click its corners, or choose a template.');
    return [html('div', {'data-key': `entries ${all.length} ${this.editor.chosen?.section} ${this.editor.chosen?.index}`}, words ?? html('ul', null, ...all.map(item)), sides)];
  }

  chosen() {
    const {editor, problem} = this, at = editor.chosen, of = at && model.entry(problem, at);
    if (!of) return [html('p', {class: 'faint', 'data-key': 'nothing'}, 'Choose something in the drawing or above, to see and change its exact values.')];
    const path = at.index === null ? at.section : `${at.section}.${at.index}`;
    const find = draft => model.entry(draft, at), form = this.form(of, path, find), shape = model.shapeOf(problem, at);
    const table = shape && pointTable(shape, editor, (edit, join) => this.store.change(draft => edit(find(draft)[shape.key]), join));
    const act = (words, run) => html('button', {type: 'button', click: run}, words);
    const further = Object.keys(of).filter(key => ['left', 'right', 'in_soil'].includes(key));
    return [html('div', {'data-key': `chosen ${path} ${of.kind} ${shape?.points.length}`},
      html('h3', null, model.label(problem, at)), ...form.rows(fields.ENTRY[at.section]), table,
      further.length ? html('p', {class: 'faint'}, `It also has ${further.join(', ')}, which can be changed as text.`) : null,
      html('div', {class: 'group'},
        shape && at.section !== 'water' ? act('Duplicate', () => editor.choose(this.store.change(draft => model.duplicate(draft, at)))) : null,
        shape ? act('Mirror', () => this.store.change(draft => model.mirror(draft, at))) : null,
        act('Remove', () => { editor.point = null; editor.remove(); })))];
  }

  more() {
    const {problem} = this, seismic = this.form(problem.seismic ?? {}, 'seismic', draft => (draft.seismic ??= {}));
    const count = [['case', 'load cases'], ['sweep', 'sweeps']].map(([key, words]) => model.list(problem, key).length ? `${model.list(problem, key).length} ${words}` : null).filter(Boolean);
    return [html('div', {'data-key': 'more'}, html('div', {class: 'two'}, ...seismic.rows(fields.SEISMIC)),
      html('p', {class: 'faint'}, count.length ? `${count.join(' and ')}, which can be changed as text.` : 'Load cases and sweeps can be added as text.'))];
  }

  // Marks the fields that messages are about.
  mark(errors, notes) {
    const panel = get('panel-problem');
    for (const field of panel.querySelectorAll('[data-path].bad, [data-path].note')) field.classList.remove('bad', 'note');
    for (const words of panel.querySelectorAll('.wrong')) words.hidden = true;
    for (const item of panel.querySelectorAll('[data-entry]')) item.classList.remove('bad', 'note');
    for (const [list, kind] of [[notes, 'note'], [errors, 'bad']]) for (const {entries, key, words} of list) for (const {section, index} of entries) {
      panel.querySelector(`[data-entry="${section}.${index ?? ''}"]`)?.classList.add(kind);
      const path = [section, index, key].filter(part => part !== null && part !== undefined).join('.');
      const field = panel.querySelector(`[data-path="${path}"]`) ?? panel.querySelector(`[data-path="${path}.0"]`);
      if (!field) continue;
      field.classList.add(kind);
      const place = field.querySelector('.wrong');
      if (place) Object.assign(place, {hidden: false, textContent: words});
    }
  }
}
