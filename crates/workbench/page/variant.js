// Two variants side by side: A is a solved problem as it was kept, beside what is now on the sheet, in the same view.
import {get, html, say, short} from './dom.js';
import {WORDS} from './fields.js';
import {Flow} from './flow.js';
import {draw} from './section.js';
import {inUnit, unit as named} from './units.js';

// As many differences are listed.
const MOST = 12;
const NOBODY = {tool: 'select', drawn: [], cursor: null, chosen: null, point: null};

// What two documents differ in: paths with both values.
export function differences(a, b, path = '') {
  if (JSON.stringify(a) === JSON.stringify(b)) return [];
  const isPlain = of => of === null || typeof of !== 'object';
  if (isPlain(a) || isPlain(b) || Array.isArray(a) !== Array.isArray(b)) return [{path, a, b}];
  return [...new Set([...Object.keys(a), ...Object.keys(b)])].flatMap(key => differences(a[key], b[key], path ? `${path}.${key}` : key));
}

const told = value => value === undefined ? 'not said' : typeof value === 'number' ? short(value, 6) : JSON.stringify(value);

export class Variant {
  // `state` has what is understood; `later` draws at the next picture.
  constructor({store, view, solver, flow, state, later}) {
    Object.assign(this, {store, view, solver, main: flow, state, later, kept: null, flow: new Flow(get('flow-a'), view)});
    get('keep-a').addEventListener('click', () => this.keep());
    get('back-to-a').addEventListener('click', () => { if (this.kept) store.replace(this.kept.problem); });
    get('forget-a').addEventListener('click', () => this.forget());
  }

  keep() {
    const {solver, main, state} = this;
    if (solver.state !== 'solved' || solver.isStale) return;
    this.kept = {problem: solver.problem, answer: solver.answer, understood: state.understood, field: main.field};
    get('view-a').hidden = get('variant').hidden = false;
    this.flow.show(this.kept.field, this.kept.problem);
    say(`kept as variant A: ${solver.words()}`);
    this.later();
  }

  forget() {
    this.kept = null;
    get('view-a').hidden = get('variant').hidden = true;
    this.flow.show(null);
    this.later();
  }

  // At each picture; tables only where something has changed.
  draw() {
    const {kept, solver, store, view} = this, canKeep = solver.state === 'solved' && !solver.isStale;
    get('keep-a').disabled = !canKeep;
    if (!kept) return;
    draw(get('section-a'), {problem: kept.problem, view, editor: NOBODY, understood: kept.understood, isStale: false, errors: [], notes: [], hasFlow: Boolean(kept.field)});
    this.flow.amount = this.main.amount;
    this.flow.draw(Number(get('flow').dataset.amount) || this.main.amount);
    const now = canKeep ? solver.answer : null, key = `${JSON.stringify(store.problem)} ${now?.lower} ${now?.upper} ${now?.quantity}`;
    if (this.drawn === key) return;
    this.drawn = key;
    get('bounds-a').replaceChildren(...this.words(now));
  }

  words(now) {
    const {answer, problem} = this.kept, {name, unit} = WORDS[answer.quantity], all = differences(problem, this.store.problem);
    const row = (words, of) => html('tr', {'data-variant': words}, html('th', {scope: 'row'}, words), ...['lower', 'upper'].map(side => html('td', {'data-value': of?.[side] ?? ''}, of ? short(inUnit(of[side], unit), 5) : '–')));
    const isSame = now && now.quantity === answer.quantity, isAbove = isSame && [answer, now].every(of => of.lower > 0 && of.upper > 0);
    const ratio = isAbove ? [now.lower / answer.upper, now.upper / answer.lower] : null;
    const changes = all.slice(0, MOST).map(({path, a, b}) => html('li', null, `${path}: ${told(a)} → ${told(b)}`));
    return [
      html('table', null, html('caption', null, `${name}${unit ? ` in ${named(unit)}` : ''}`), html('thead', null, html('tr', null, ...['', 'at least', 'at most'].map(words => html('th', {scope: 'col'}, words)))), html('tbody', null, row('A', answer), row('now', isSame ? now : null))),
      html('p', {id: 'ratio-a'}, ratio ? `Now is ${short(ratio[0], 4)} to ${short(ratio[1], 4)} times A; the bounds of both prove that.` : now && !isSame ? 'Now something else is bounded than for A.' : now ? '' : 'What is on the sheet now is not solved.'),
      all.length ? html('ul', {class: 'plain'}, ...changes, all.length > MOST ? html('li', null, `and ${all.length - MOST} more`) : null) : html('p', {class: 'faint'}, 'The sheet is as A was.'),
    ];
  }
}
