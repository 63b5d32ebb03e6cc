// What if: sliders for the values of one thing. While one is dragged the problem is solved coarsely, again and again; when it rests, as fine
// as is asked for.
import {get, html, short} from './dom.js';
import {list, shapes} from './model.js';
import {inUnit, unit as named} from './units.js';

const REST_MS = 450;
// The gap of a coarse run: that of the first meshes.
const COARSE = .3;

// What is not said is `absent`.
const slider = (key, name, unit, low, high, step, absent = 0) => ({key, name, unit, low, high, step, absent});
// From twice what it is up to the next round number.
const upTo = (value, least) => {
  const most = Math.max(2 * Math.abs(value ?? 0), least), size = 10 ** Math.floor(Math.log10(most));
  return size * [1, 2, 5, 10].find(digit => digit * size >= most);
};

// The things that have sliders: what they are called, where they are in a document, and their sliders.
function things(problem) {
  const all = list(problem, 'soil').map((soil, k) => ({id: `soil.${k}`, name: `soil ${soil.name}`, find: draft => draft.soil[k], sliders: [
    ...soil.strength ? [slider('strength_factor', 'strength times', '', .2, 3, .05, 1)] : [slider('phi_deg', 'friction angle', '°', 0, 50, .5), slider('cohesion_kpa', 'cohesion', 'kPa', 0, upTo(soil.cohesion_kpa, 20), .5)], slider('unit_weight_kn_m3', 'unit weight', 'kN/m³', 8, 26, .1)]}));
  list(problem, 'boundary').forEach((of, k) => {
    // The factor on a live load is what is bounded.
    if (of.kind !== 'load' || Array.isArray(of.pressure_kpa) || of.live && problem.objective.kind === 'load') return;
    all.push({id: `boundary.${k}`, name: `load ${of.name ?? k + 1}`, find: draft => draft.boundary[k], sliders: [slider('pressure_kpa', 'pressure', 'kPa', 0, upTo(of.pressure_kpa, 20), .5)]});
  });
  const ys = shapes(problem).flatMap(shape => shape.points.map(p => p[1])), tall = Math.max(.5, Math.ceil(Math.max(...ys) - Math.min(...ys)));
  list(problem, 'member').forEach((of, k) => {
    const held = typeof of.pullout_kn_per_m2 === 'number' ? [slider('pullout_kn_per_m2', 'pullout resistance', 'kPa', 0, upTo(of.pullout_kn_per_m2, 20), .5)] : [];
    all.push({id: `member.${k}`, name: `${of.pullout_kn_per_m2 === undefined ? 'sheet' : 'bars'} ${of.name}`, find: draft => draft.member[k], sliders: [slider('tensile_kn_per_m', 'tension at most', 'kN/m', 0, upTo(of.tensile_kn_per_m, 20), 1), ...held]});
  });
  list(problem, 'head').forEach((of, k) => {
    all.push({id: `head.${k}`, name: `head ${of.name ?? k + 1}`, find: draft => draft.head[k], sliders: [slider('head_m', 'total head', 'm', Math.min(...ys), Math.max(...ys) + tall, .05)]});
  });
  if (problem.water) {
    all.push({id: 'water', name: 'water table', find: draft => draft.water, sliders: [slider('rise_m', 'higher by', 'm', -tall, tall, .05)]});
  }
  all.push({id: 'surcharge', name: 'surcharge', find: draft => draft, sliders: [slider('surcharge_kpa', 'on free ground', 'kPa', 0, upTo(problem.surcharge_kpa, 20), .5)]});
  return all;
}

export class WhatIf {
  constructor(store, editor, solver) {
    Object.assign(this, {store, editor, solver, id: null, outline: '', timer: 0, isDragged: false});
    get('whatif-of').addEventListener('change', () => { this.id = get('whatif-of').value; this.made = ''; this.update(); });
  }

  // What is chosen in the drawing is what is asked about.
  choose() {
    const {editor, store} = this, chosen = editor.chosen;
    if (!chosen) return;
    const soil = chosen.section === 'region' ? list(store.problem, 'soil').findIndex(one => one.name === store.problem.region[chosen.index]?.soil) : -1;
    const id = chosen.section === 'region' ? `soil.${soil}` : chosen.section === 'water' ? 'water' : `${chosen.section}.${chosen.index}`;
    if (things(store.problem).some(one => one.id === id)) this.id = id;
    this.update();
  }

  update() {
    const all = things(this.store.problem), now = all.find(one => one.id === this.id) ?? all[0];
    this.id = now.id;
    const outline = all.map(one => `${one.id} ${one.name}`).join('|');
    if (outline !== this.outline) {
      this.outline = outline;
      get('whatif-of').replaceChildren(...all.map(one => html('option', {value: one.id}, one.name)));
    }
    get('whatif-of').value = now.id;
    const of = now.find(this.store.problem);
    // Ranges stay what they are while a slider is dragged.
    const made = JSON.stringify([now.id, now.sliders]);
    if (this.made !== made && !this.isDragged) {
      this.made = made;
      get('whatif-sliders').replaceChildren(...now.sliders.map(one => this.row(now, one, of[one.key] ?? one.absent)));
    }
    for (const {key, unit, absent} of now.sliders) {
      const input = document.getElementById(`whatif.${key}`), value = of[key] ?? absent;
      if (document.activeElement !== input) Object.assign(input, {min: Math.min(input.min, value), max: Math.max(input.max, value)}).value = value;
      document.getElementById(`whatif.${key}.value`).textContent = `${short(inUnit(value, unit))} ${named(unit)}`;
    }
  }

  row({id, find}, {key, name, unit, low, high, step}, value) {
    const input = html('input', {id: `whatif.${key}`, type: 'range', min: Math.min(low, value), max: Math.max(high, value), step, 'aria-describedby': `whatif.${key}.value`,
      input: () => {
        // One drag is one step back. What fails stays in the picture until there is something else.
        this.isDragged = true;
        this.store.change(draft => { const of = find(draft), now = Number(input.value); if (now === 0 && key !== 'phi_deg') delete of[key]; else of[key] = now; }, `whatif.${id}.${key}`);
        this.isDragged = false;
        this.solver.start(COARSE);
        clearTimeout(this.timer);
        this.timer = setTimeout(() => this.solver.start(), REST_MS);
      }});
    input.value = value;
    return html('label', {class: 'slide'}, html('span', null, name), input, html('output', {id: `whatif.${key}.value`}, `${short(inUnit(value, unit))} ${named(unit)}`));
  }
}
