// What can be done to a document. Its keys are those of the problem file; functions that end a document's draft change it in place.
import {box, distance, same} from './geometry.js';
import {toField, unit} from './units.js';

export const SECTIONS = ['region', 'boundary', 'structure', 'plate', 'member', 'head', 'water'];

export const empty = () => ({
  title: 'new problem', default_boundary: 'free', objective: {kind: 'load'},
  soil: [{name: 'soil', phi_deg: 30, cohesion_kpa: 5, unit_weight_kn_m3: 18}], region: [],
});

export const list = (problem, section) => problem[section] ?? [];
export const entry = (problem, {section, index}) => index === null || index === undefined ? problem[section] : list(problem, section)[index];

// Which key holds the points of an entry; none if it has none, like a boundary on whole sides.
function pointsKey(section, of) {
  if (section === 'region') return 'polygon';
  if (section === 'structure') return of.polygon?.length ? 'polygon' : 'edge';
  if (section === 'water') return 'table';
  return of.line ? 'line' : null;
}

// All that has points: {section, index, key, points, closed}. The water table has no index.
export function shapes(problem) {
  const all = [];
  for (const section of SECTIONS.filter(section => section !== 'water')) {
    list(problem, section).forEach((of, index) => {
      const key = pointsKey(section, of), points = key && of[key];
      if (points?.length) all.push({section, index, key, points, closed: key === 'polygon'});
    });
  }
  if (problem.water?.table?.length) all.push({section: 'water', index: null, key: 'table', points: problem.water.table, closed: false});
  return all;
}

export const isSame = (a, b) => Boolean(a && b && a.section === b.section && (a.index ?? null) === (b.index ?? null));
export const shapeOf = (problem, chosen) => chosen && shapes(problem).find(shape => isSame(shape, chosen));
export const allPoints = problem => shapes(problem).flatMap(shape => shape.points);

const KINDS = {region: 'Region', boundary: 'Boundary', structure: 'Structure', plate: 'Plate', member: 'Bar or sheet', head: 'Head', water: 'Water table', soil: 'Soil'};
const HOLDS = {free: 'free', load: 'load', fixed: 'fixed', smooth: 'smooth', symmetric: 'symmetric', far: 'far'};

// An entry in a few words.
export function label(problem, {section, index}) {
  const of = entry(problem, {section, index});
  if (!of) return KINDS[section] ?? section;
  if (section === 'water') return 'Water table';
  if (section === 'boundary') {
    const where = of.sides?.length ? of.sides.join(', ') : `${of.line?.length ?? 0} points`;
    return `${of.name ? `${of.name}: ` : ''}${HOLDS[of.kind] ?? of.kind}, ${where}`;
  }
  if (section === 'head') return `${of.name ? `${of.name}: ` : ''}head ${toField(of.head_m, 'm')} ${unit('m')}`;
  if (section === 'region') return of.name ? `${of.name} (${of.soil})` : of.soil;
  return of.name || `${KINDS[section]} ${index + 1}`;
}

function freshName(names, wanted) {
  if (!names.includes(wanted)) return wanted;
  for (let k = 2; ; k++) if (!names.includes(`${wanted} ${k}`)) return `${wanted} ${k}`;
}

// Adds what was drawn with a tool; returns where it is.
export function add(draft, tool, points, {soil = 0, kind = 'fixed'} = {}) {
  const push = (section, of) => { (draft[section] ??= []).push(of); return {section, index: draft[section].length - 1}; };
  switch (tool) {
    case 'region': {
      if (!list(draft, 'soil').length) draft.soil = empty().soil;
      return push('region', {soil: draft.soil[Math.min(soil, draft.soil.length - 1)].name, polygon: points});
    }
    case 'load': return push('boundary', {kind: 'load', line: points, pressure_kpa: 10, ...(draft.objective.kind === 'load' ? {live: true} : {})});
    case 'line': return push('boundary', {kind, line: points});
    case 'member': return push('member', {name: freshName(list(draft, 'member').map(of => of.name), 'sheet'), line: points, tensile_kn_per_m: 50});
    // Water at the highest of its points, until somebody says otherwise.
    case 'head': return push('head', {line: points, head_m: tidy(Math.max(...points.map(p => p[1])))});
    case 'water': {
      const table = [...points].sort((a, b) => a[0] - b[0]);
      draft.water = {unit_weight_kn_m3: 9.81, ...draft.water, table};
      return {section: 'water', index: null};
    }
    case 'structure': case 'edge': case 'plate': {
      const section = tool === 'plate' ? 'plate' : 'structure';
      const key = {structure: 'polygon', edge: 'edge', plate: 'line'}[tool];
      const names = [...list(draft, 'plate'), ...list(draft, 'structure')].map(of => of.name);
      const wants = draft.objective.kind === 'structure' && !names.includes(draft.objective.name);
      const name = wants ? draft.objective.name : freshName(names, {structure: 'block', edge: 'footing', plate: 'plate'}[tool]);
      const others = draft.objective.kind === 'structure' && !wants;
      const live = list(draft, 'boundary').some(of => of.live);
      // Whoever draws the first structure where nothing is loaded asks for its force.
      if (draft.objective.kind === 'load' && !live) draft.objective = {kind: 'structure', name, direction: tool === 'edge' ? [0, -1] : [1, 0]};
      return push(section, {name, [key]: points, ...(others ? {held: 'fixed'} : {})});
    }
  }
  throw new Error(`no tool ${tool}`);
}

export function remove(draft, {section, index}) {
  if (section === 'water') delete draft.water;
  else {
    draft[section].splice(index, 1);
    if (!draft[section].length && section !== 'soil' && section !== 'region') delete draft[section];
  }
}

const change = (draft, of) => shapes(draft).find(shape => isSame(shape, of)).points;

// Moves a point, and all others at the same place with it unless `alone`.
export function movePoint(draft, of, k, to, alone = false) {
  const from = [...change(draft, of)[k]];
  for (const shape of shapes(draft)) {
    if (shape.section === 'water' && !isSame(shape, of)) continue;
    shape.points.forEach((p, i) => {
      if ((isSame(shape, of) && i === k) || (!alone && of.section !== 'water' && same(p, from))) shape.points[i] = [...to];
    });
  }
}

export function moveShape(draft, of, [dx, dy]) {
  change(draft, of).forEach(p => { p[0] = tidy(p[0] + dx); p[1] = tidy(p[1] + dy); });
}

// After point `k`; returns the number of the new one.
export function insertPoint(draft, of, k, at) {
  change(draft, of).splice(k + 1, 0, [...at]);
  return k + 1;
}

// The least number of points of a shape.
export const least = shape => shape.closed ? 3 : shape.section === 'water' ? 1 : 2;

export function removePoint(draft, of, k) {
  const shape = shapeOf(draft, of);
  if (shape.points.length > least(shape)) shape.points.splice(k, 1);
  else remove(draft, of);
}

// A copy beside the shape; returns where it is.
export function duplicate(draft, of) {
  const shape = shapeOf(draft, of);
  if (!shape || of.section === 'water') return of;
  const {low, high} = box(shape.points);
  const copy = structuredClone(draft[of.section][of.index]);
  copy[shape.key] = shape.points.map(([x, y]) => [tidy(x + (high[0] - low[0] || high[1] - low[1])), y]);
  if (of.section === 'member') copy.name = freshName(list(draft, 'member').map(its => its.name), copy.name);
  draft[of.section].push(copy);
  return {section: of.section, index: draft[of.section].length - 1};
}

// Turns everything, or one shape, over about the upright line in its middle.
export function mirror(draft, of = null) {
  const all = of ? [shapeOf(draft, of)] : shapes(draft);
  const around = box(all.flatMap(shape => shape.points));
  if (!around) return;
  const sum = around.low[0] + around.high[0];
  for (const shape of all) {
    shape.points.forEach(p => { p[0] = tidy(sum - p[0]); });
    // From left to right, as before; of loads the values stay with their ends, and faces with their sides.
    if (shape.section === 'water') shape.points.reverse();
    const its = entry(draft, shape);
    if (shape.section === 'plate' && (its.left || its.right)) [its.left, its.right] = [its.right, its.left];
    for (const key of ['left', 'right']) if (its[key] === undefined) delete its[key];
  }
  if (of) return;
  const turn = side => ({left: 'right', right: 'left'})[side] ?? side;
  list(draft, 'boundary').forEach(its => { if (its.sides) its.sides = its.sides.map(turn); });
  if (draft.objective.direction) draft.objective.direction[0] = -draft.objective.direction[0] + 0;
  if (draft.objective.kind === 'seismic') draft.objective.leftwards = !draft.objective.leftwards;
  if (draft.seismic?.kh) draft.seismic.kh = -draft.seismic.kh;
}

// Renames a soil where it is used, so that regions stay what they are.
export function renameSoil(draft, index, name) {
  const before = draft.soil[index].name;
  draft.soil[index].name = name;
  if (list(draft, 'soil').some((soil, k) => k !== index && soil.name === before)) return;
  for (const region of list(draft, 'region')) if (region.soil === before) region.soil = name;
  for (const of of [...list(draft, 'plate'), ...list(draft, 'structure')]) {
    for (const face of of.in_soil ?? []) if (face.soil === before) face.soil = name;
  }
}

export function addSoil(draft) {
  const name = freshName(list(draft, 'soil').map(soil => soil.name), 'soil');
  (draft.soil ??= []).push({name, phi_deg: 30, cohesion_kpa: 5, unit_weight_kn_m3: 18});
  return draft.soil.length - 1;
}

// Sums of decimal numbers have digits that nobody wrote.
export const tidy = value => Number(value.toPrecision(12)) + 0;

// What is drawn may be closed where it began, and has no point twice.
export function cleaned(points, closed) {
  const kept = points.filter((p, k) => k === 0 || !same(p, points[k - 1]));
  if (closed && kept.length > 1 && distance(kept[0], kept.at(-1)) === 0) kept.pop();
  return kept;
}
