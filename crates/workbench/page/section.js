// The drawing: grid, soils, structures, what was understood, what is wrong, and what is being drawn.
import {short, svg} from './dom.js';
import {area, middle} from './geometry.js';
import {label, list, shapeOf, shapes} from './model.js';
import {patternId, patterns} from './palette.js';
import {symbols} from './symbols.js';
import {inUnit, unit} from './units.js';

const path = (view, points, closed) => `M${points.map(p => view.px(p).map(x => x.toFixed(2))).join('L')}${closed ? 'Z' : ''}`;

function grid(view) {
  const step = view.step(56), low = view.m([0, view.height]), high = view.m([view.width, 0]), parts = [], words = [];
  const first = axis => Math.ceil(low[axis] / step);
  const shown = inUnit(step, 'm'), digits = Math.max(0, -Math.floor(Math.log10(shown) + 1e-9)), at = k => (k * shown).toFixed(digits).replace('-', '−');
  for (let k = first(0); k * step <= high[0]; k++) {
    const [x] = view.px([k * step, 0]);
    parts.push(`M${x.toFixed(1)} 0V${view.height}`);
    words.push(svg('text', {x: x + 3, y: view.height - 5}, at(k)));
  }
  for (let k = first(1); k * step <= high[1]; k++) {
    const [, y] = view.px([0, k * step]);
    parts.push(`M0 ${y.toFixed(1)}H${view.width}`);
    if (y < view.height - 22) words.push(svg('text', {x: 4, y: y - 3}, `${at(k)}${k === Math.floor(high[1] / step) ? ` ${unit('m')}` : ''}`));
  }
  return svg('g', {class: 'grid', 'aria-hidden': 'true'}, svg('path', {d: parts.join('')}), ...words);
}

function regions(view, problem, isPlain) {
  const soils = list(problem, 'soil').map(soil => soil.name);
  return list(problem, 'region').map(({soil, polygon}) => {
    const index = soils.indexOf(soil);
    return svg('path', {d: path(view, polygon ?? [], true), class: `region${index < 0 ? ' unknown' : ''}`, fill: isPlain || index < 0 ? 'none' : `url(#${patternId(index)})`});
  });
}

// A region's soil in words, where there is room for them.
function names(view, problem) {
  return list(problem, 'region').filter(({polygon}) => polygon?.length > 2).map(({soil, polygon}) => {
    if (Math.abs(area(polygon)) * view.scale ** 2 < 9000) return null;
    const its = list(problem, 'soil').find(one => one.name === soil);
    const [x, y] = view.px(middle(polygon));
    const words = its ? `${its.strength ? `${its.strength.kind} strength` : `${its.anisotropy ? 'by direction' : `φ ${short(its.phi_deg ?? 0)}°`}  c ${short(inUnit(its.cohesion_kpa ?? 0, 'kPa'))} ${unit('kPa')}`}  γ ${short(inUnit(its.unit_weight_kn_m3, 'kN/m³'))} ${unit('kN/m³')}` : 'no such soil';
    return svg('g', {class: 'name'}, svg('text', {x, y, 'text-anchor': 'middle'}, soil), svg('text', {x, y: y + 16, 'text-anchor': 'middle', class: 'small'}, words));
  });
}

function bodies(view, problem) {
  return shapes(problem).filter(({section}) => ['structure', 'plate', 'member'].includes(section)).flatMap(shape => {
    const {points, closed} = shape, line = svg('path', {d: path(view, points, closed), class: closed ? 'body' : shape.section === 'member' ? 'member' : 'plate'});
    const top = points.reduce((best, p) => p[1] > best[1] ? p : best, points[0]), [, y] = view.px(top), [x] = view.px(closed ? middle(points) : top);
    return [line, svg('text', {x: closed ? x : x + 8, y: y - 8, 'text-anchor': closed ? 'middle' : 'start', class: 'value'}, label(problem, shape))];
  });
}

// The lines of boundaries and the water table as they are in the document; what they mean is drawn by symbols.
function lines(view, problem) {
  return shapes(problem).filter(({section}) => ['boundary', 'head', 'water'].includes(section))
    .map(({section, points}) => svg('path', {d: path(view, points, false), class: `entry ${section}`}));
}

// What is wrong, at its place: entries in red, and a mark at points.
function faults(view, problem, wrong, kind) {
  return wrong.flatMap(({entries, points, words}) => {
    const at = entries.map(entry => shapeOf(problem, entry)).filter(Boolean);
    const marks = points.map(p => view.px(p)), outlines = at.map(shape => svg('path', {d: path(view, shape.points, shape.closed), class: `fault ${kind}`}));
    const place = marks[0] ?? (at.length ? view.px(at[0].points[0]) : null);
    if (points.length > 1) outlines.push(svg('path', {d: path(view, points, false), class: `fault ${kind}`}));
    if (!place) return outlines;
    const [x, y] = place;
    return [...outlines, svg('g', {class: `flag ${kind}`, 'data-words': words}, svg('circle', {cx: x, cy: y, r: 9}), svg('text', {x, y: y + 4.5, 'text-anchor': 'middle'}, '!'), svg('title', null, words))];
  });
}

function selection(view, problem, {chosen, point}) {
  const shape = shapeOf(problem, chosen);
  if (!shape) return [];
  const handles = shape.points.map((p, k) => { const [x, y] = view.px(p); return svg('rect', {x: x - 5, y: y - 5, width: 10, height: 10, rx: 2, class: k === point ? 'handle chosen' : 'handle'}); });
  const named = shape.points[point] ? (() => { const [x, y] = view.px(shape.points[point]); return svg('text', {x: x + 9, y: y + 18, class: 'value coordinate'}, `${short(shape.points[point][0], 6)}, ${short(shape.points[point][1], 6)}`); })() : null;
  return [svg('path', {d: path(view, shape.points, shape.closed), class: 'selected'}), ...handles, named];
}

function drawing(view, {tool, drawn, cursor, snapped}) {
  const parts = [];
  if (drawn.length) {
    const closed = tool === 'region' || tool === 'structure';
    parts.push(svg('path', {d: path(view, cursor ? [...drawn, cursor] : drawn, closed && drawn.length > 1), class: closed ? 'drawn closed' : 'drawn'}));
    parts.push(...drawn.map(p => { const [cx, cy] = view.px(p); return svg('circle', {cx, cy, r: 4, class: 'handle'}); }));
  }
  if (cursor && tool !== 'select') {
    const [x, y] = view.px(cursor);
    parts.push(svg('path', {d: `M${x - 12} ${y}h24M${x} ${y - 12}v24`, class: 'cross'}));
    if (snapped && snapped !== 'grid' && snapped !== 'free') parts.push(svg('circle', {cx: x, cy: y, r: 8, class: 'snapped'}));
    parts.push(svg('text', {x: x + 12, y: y - 8, class: 'value coordinate'}, `${short(cursor[0], 6)}, ${short(cursor[1], 6)}`));
  }
  return parts;
}

// A section line, and the place on it that is read.
function probes(view, probe) {
  if (!probe) return [];
  const parts = [svg('path', {d: path(view, [probe.from, probe.to], false), class: 'probe'})];
  if (probe.at) { const [cx, cy] = view.px(probe.at); parts.push(svg('circle', {cx, cy, r: 5, class: 'probe-at'})); }
  return parts;
}

// Draws all into an element. `isStale`: what was understood is not of this document.
export function draw(into, {problem, view, editor, understood, isStale, errors, notes, hasFlow, probe = null}) {
  into.replaceChildren(
    svg('defs', null, ...patterns()),
    grid(view),
    svg('g', {class: hasFlow ? 'regions bare' : 'regions'}, ...regions(view, problem, hasFlow)),
    ...lines(view, problem),
    understood ? svg('g', {class: isStale ? 'understood stale' : 'understood'}, ...symbols(view, understood)) : svg('g'),
    svg('g', {class: 'bodies'}, ...bodies(view, problem)),
    svg('g', {class: 'names'}, ...(hasFlow ? [] : names(view, problem)).filter(Boolean)),
    svg('g', {class: 'probes'}, ...probes(view, probe)),
    svg('g', {class: 'faults'}, ...faults(view, problem, notes, 'note'), ...faults(view, problem, errors, 'bad')),
    svg('g', {class: 'editing'}, ...selection(view, problem, editor).filter(Boolean), ...drawing(view, editor)),
  );
}

