// The law of strength of a soil: straight, with a friction angle and cohesion, one that grows less and less with pressure, or that of a clay
// by the direction of the stress.
import {html} from './dom.js';
import {complain, Form, parse} from './form.js';
import {fromField, toField, unit} from './units.js';

const number = (key, label, unit, more = {}) => ({key, label, unit, kind: 'number', ...more});
const UP_TO = number('up_to_kpa', 'Followed up to', 'kPa', {optional: true, help: 'a multiple of what weight and loads make, if it is not said'});
const LAWS = [['', 'straight: φ and c'], ['points', 'through points'], ['power', 'a power of stress'], ['friction-law', 'friction that falls with stress'], ['hoek-brown', 'rock, Hoek and Brown'], ['anisotropic', 'clay, by direction']];
const FIELDS = {
  points: [],
  power: [number('factor', 'Strength at 1 kPa', 'kPa'), number('exponent', 'Exponent', ''), number('tension_kpa', 'None left at a tension of', 'kPa', {zero: true}), UP_TO],
  'friction-law': [number('phi_deg', 'φ at the reference', '°'), number('slope_deg_per_decade', 'Less a decade by', '°'), number('reference_kpa', 'Reference', 'kPa'), number('greatest_phi_deg', 'φ at most', '°', {optional: true, help: '55° if it is not said'}), UP_TO],
  'hoek-brown': [number('ucs_mpa', 'Strength of intact rock', 'MPa'), number('gsi', 'Geological strength index', ''), number('mi', 'Constant m_i', ''), number('disturbance', 'Disturbance', '', {zero: true}), UP_TO],
};
const DIRECTIONS = [
  number('passive', 'Passive strength over c', '', {title: 'pressed sideways, over the active strength, which is c'}),
  number('shear', 'Shear strength over c', '', {title: 'on level and upright planes, likewise'}),
];
const three = value => Number(value.toPrecision(3));

// A law to begin with, which is near what the soil has at 50 kPa.
function first(kind, {phi_deg = 30, cohesion_kpa = 5}) {
  // Strength through points must grow.
  const tan = Math.max(.1, Math.tan(phi_deg * Math.PI / 180)), at = cohesion_kpa + 50 * tan;
  if (kind === 'points') return {kind, points_kpa: [[0, cohesion_kpa], [50, three(at)], [200, three(at + 135 * tan)]]};
  if (kind === 'power') return {kind, factor: three(Math.max(.1, at) / 50 ** .8), exponent: .8};
  if (kind === 'friction-law') return {kind, phi_deg: Math.min(50, Math.max(20, phi_deg)), slope_deg_per_decade: 5, reference_kpa: 50};
  return {kind, ucs_mpa: 10, gsi: 40, mi: 10};
}

const STRAIGHT = ['phi_deg', 'cohesion_kpa', 'cohesion_gradient_kpa_per_m', 'cohesion_level_m', 'dilation_deg'], OTHER = ['strength', 'strength_factor', 'anisotropy'];
export const lawOf = soil => soil.strength?.kind ?? (soil.anisotropy ? 'anisotropic' : '');

// Another law in place of the one that a soil has.
function choose(soil, kind) {
  const before = {...soil};
  for (const key of OTHER) delete soil[key];
  if (kind === 'anisotropic') {
    Object.assign(soil, {phi_deg: 0, cohesion_kpa: before.cohesion_kpa || 20, anisotropy: {passive: .6, shear: .8}});
    delete soil.dilation_deg;
  } else if (kind) {
    for (const key of STRAIGHT) delete soil[key];
    soil.strength = first(kind, before);
  } else if (before.strength) Object.assign(soil, {phi_deg: 30, cohesion_kpa: 5});
}

// Points of normal stress and shear strength.
function table(law, path, write) {
  const cell = (k, axis) => {
    const input = html('input', {inputmode: 'decimal', autocomplete: 'off', value: toField(law.points_kpa[k][axis], 'kPa'), id: `${path}.${k}.${axis}`, 'aria-label': `${['normal stress', 'shear strength'][axis]} of point ${k + 1} in ${unit('kPa')}`, input: () => {
      const found = parse(input.value);
      complain(input, found === null ? 'this is no number' : '');
      if (found !== null) write(of => { of.points_kpa[k][axis] = fromField(found, 'kPa'); }, `${path}.${k}.${axis}`);
    }});
    return html('td', null, input);
  };
  const act = (words, title, run) => html('button', {type: 'button', class: 'small', title, 'aria-label': title, click: () => write(run, null)}, words);
  const rows = law.points_kpa.map(([stress, strength], k) => html('tr', null, html('th', {scope: 'row'}, k + 1), cell(k, 0), cell(k, 1), html('td', null,
    act('+', `Insert a point after point ${k + 1}`, of => {
      const after = law.points_kpa[k + 1], before = law.points_kpa[k - 1] ?? [stress - 1, strength];
      of.points_kpa.splice(k + 1, 0, after ? [(stress + after[0]) / 2, (strength + after[1]) / 2] : [2 * stress - before[0], 2 * strength - before[1]]);
    }),
    act('×', `Remove point ${k + 1}`, of => { of.points_kpa.splice(k, 1); }))));
  return html('div', {class: 'field', 'data-path': path}, html('table', {class: 'points'}, html('thead', null, html('tr', null, ...['', `σ in ${unit('kPa')}`, `τ in ${unit('kPa')}`, ''].map(words => html('th', {scope: 'col'}, words)))), html('tbody', null, ...rows)), html('p', {class: 'wrong', id: `${path}.wrong`, hidden: true}));
}

// The fields of a soil's law; `change(edit, join)` changes the soil.
export function strength(problem, soil, index, change) {
  const path = `soil.${index}.strength`, law = soil.strength, write = (edit, join) => change(of => edit(of.strength), join);
  const select = html('select', {id: `${path}.kind`, 'aria-describedby': `${path}.wrong`, change: () => change(of => choose(of, select.value), null)}, ...LAWS.map(([value, words]) => html('option', {value}, words)));
  select.value = lawOf(soil);
  const directions = soil.anisotropy && new Form(problem, soil.anisotropy, `soil.${index}.anisotropy`, (edit, join) => change(of => edit(of.anisotropy), join));
  return [
    html('div', {class: 'field', 'data-path': path}, html('label', {for: select.id}, 'Law of strength'), html('span', {class: 'control'}, select), html('p', {class: 'wrong', id: `${path}.wrong`, hidden: true})),
    law ? html('div', {class: 'two'}, ...new Form(problem, law, path, write).rows(FIELDS[law.kind] ?? [])) : null,
    directions ? html('div', {class: 'two'}, ...directions.rows(DIRECTIONS)) : null,
    law?.kind === 'points' ? table(law, `${path}.points_kpa`, write) : null,
  ].filter(Boolean);
}
