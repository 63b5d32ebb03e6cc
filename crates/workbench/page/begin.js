// Where to begin: templates, an empty sheet, or a file.
import {get, html} from './dom.js';
import {empty, allPoints, list, shapes} from './model.js';
import {box} from './geometry.js';
import {svg} from './dom.js';

// A small picture of a problem.
function miniature(problem) {
  const {low, high} = box(allPoints(problem)), [wide, tall] = [high[0] - low[0], high[1] - low[1]], size = Math.max(wide, tall * 1.8);
  const at = ([x, y]) => [60 + (x - (low[0] + high[0]) / 2) / size * 108, 34 - (y - (low[1] + high[1]) / 2) / size * 108].map(value => value.toFixed(1));
  const soils = list(problem, 'soil').map(soil => soil.name);
  return svg('svg', {viewBox: '0 0 120 68', class: 'miniature', 'aria-hidden': 'true'}, ...shapes(problem).map(({section, index, points, closed}) => {
    const tint = section === 'region' ? `tint-${soils.indexOf(problem.region[index].soil)}` : '';
    return svg('path', {d: `M${points.map(at).join('L')}${closed ? 'Z' : ''}`, class: `${section} ${tint} ${closed ? 'closed' : 'open'}`});
  }));
}

// `take` takes the document that is chosen.
export function begin(templates, take) {
  const card = (name, what, problem, id) => html('button', {type: 'button', 'data-template': id, click: () => { get('begin').close(); take(structuredClone(problem)); }},
    allPoints(problem).length ? miniature(problem) : html('span', {class: 'miniature', 'aria-hidden': 'true'}), html('b', null, name), html('span', null, what));
  get('templates').replaceChildren(...templates.map(({id, name, what, problem}) => card(name, what, problem, id)), card('Empty sheet', 'draw everything yourself', empty(), 'empty'));
}
