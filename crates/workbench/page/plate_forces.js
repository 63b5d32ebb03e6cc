// The force by each model: a table with a bar or a mark in each row, and the words of those that do not cover the case.
import {get, html, short, svg} from './dom.js';

export const NAMES = {
  coulomb: 'Coulomb', 'log-spiral': 'Log-spiral', 'log-spiral-thesis': 'Log-spiral, as once printed', caquot: 'Caquot & Kerisel', chen: 'Chen & Liu', 'thesis-ub': 'Hong, upper bound', 'thesis-lb': 'Hong, lower bound',
  mckyes: 'McKyes & Ali', perumpral: 'Perumpral', 'godwin-spoor': 'Godwin & Spoor', ovesen: 'Ovesen', 'blocks-3d': 'Blocks in space', table: 'Proven bounds',
};
const GROUPS = [['none', 'Part of an endless plate'], ['finite', 'Plate with ends']];

// The end of the scale: all of the bracket, and of the others what is not far beyond what most say.
function most(models) {
  const ends = models.flatMap(one => one.force_n ? [one.force_n[1]] : []).sort((a, b) => a - b);
  if (!ends.length) return 1;
  const middle = ends[Math.floor(ends.length / 2)], bracket = models.filter(one => one.id === 'table' && one.force_n).map(one => one.force_n[1]);
  return 1.08 * Math.max(...bracket, ...ends.filter(force => force <= 2.5 * middle));
}

function bar([low, high], top, kind) {
  const x = force => 100 * Math.min(1, Math.max(0, force / top)), isBeyond = low > top;
  const box = svg('svg', {class: 'bar', viewBox: '0 0 100 10', preserveAspectRatio: 'none', 'aria-hidden': 'true'}, svg('path', {d: 'M0 5H100', class: 'rule'}));
  if (isBeyond) box.append(svg('path', {d: 'M96 1L100 5L96 9', class: 'beyond'}));
  else if (high - low > 1e-9 * high) box.append(svg('rect', {x: x(low), y: 1.5, width: Math.max(1.6, x(high) - x(low)), height: 7, class: kind}));
  else box.append(svg('path', {d: `M${x(low)} 0V10`, class: kind}));
  return box;
}

// `swatch` gives the sign of a model's line in the section, if it has one.
export function forces(models, swatch) {
  const top = most(models), groups = GROUPS.map(([ends, words]) => {
    const rows = models.filter(one => one.ends === ends).map(one => {
      const name = html('th', {scope: 'row', title: one.reference}, swatch(one) ?? '', NAMES[one.id] ?? one.id);
      const data = {'data-model': `${one.id} ${ends}`};
      if (one.force_n) {
        const [low, high] = one.force_n, isPair = high - low > 1e-9 * high;
        const note = one.interpolation_margin > 0 ? `interpolated, ${short(100 * one.interpolation_margin, 2)} % either way within` : one.id === 'table' ? 'a proven node' : null;
        return html('tr', {...data, 'data-low': low, 'data-high': high, class: one.id === 'table' ? 'proven' : null}, name, html('td', null, bar(one.force_n, top, one.id === 'table' ? 'bracket' : 'mark'), note ? html('small', null, note) : null), html('td', {class: 'value'}, isPair ? `${short(low, 3)} – ${short(high, 3)}` : short(low, 3), ' N'));
      }
      return html('tr', {...data, class: 'refused'}, name, html('td', {colspan: 2}, one.is_left_out ? 'when the sliders rest' : one.error));
    });
    return html('tbody', null, html('tr', {class: 'head'}, html('th', {scope: 'rowgroup', colspan: 2}, words), html('td', {class: 'value'}, 'N')), ...rows);
  });
  get('forces').replaceChildren(html('table', null, html('caption', {class: 'hear'}, 'Failure force by model; names tell their source when pointed at'), ...groups));
}

// The narrowest statement that is proven, in words.
export function bracketWords(models) {
  const of = ends => models.find(one => one.id === 'table' && one.ends === ends), plane = of('none'), ended = of('finite');
  const say = (one, words) => one?.force_n ? `${words} between ${short(one.force_n[0])} and ${short(one.force_n[1])} N` : null;
  const told = [say(ended, 'With its ends the plate fails the soil'), say(plane, 'as a part of an endless plate')].filter(Boolean);
  if (!told.length) return `No proven bracket here: ${ended?.error ?? plane?.error ?? 'the table is missing'}`;
  const margin = Math.max(...[plane, ended].map(one => one?.interpolation_margin ?? 0));
  return `${told.join(', ')}. ${margin > 0 ? `Between proven nodes of the table: both ends are moved outwards by what interpolation may be wrong by, at most ${short(100 * margin, 2)} %.` : 'A node of the table, proven with interval arithmetic.'}`;
}
