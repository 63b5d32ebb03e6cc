// Solving: levels as they come, the bracket, the proof, and what the solution shows, in words and tables.
import {get, html, say, short} from './dom.js';
import {WORDS} from './fields.js';
import {scale} from './scale.js';
import {inUnit, unit as named} from './units.js';

// Why the solver ended, as it is told.
const ENDED = {gap: 'the gap was reached', elements: 'the mesh is as fine as is allowed', work: 'the work allowed is spent', time: 'the time allowed is spent', memory: 'the memory allowed is used', stopped: 'it was stopped'};

export class Solver {
  // `shown` is told the flow of a solution and its document.
  constructor(store, link, shown) {
    Object.assign(this, {store, link, shown, state: 'idle', steps: [], id: 0});
    get('solve').addEventListener('click', () => this.start());
    get('stop').addEventListener('click', () => this.stop());
  }

  // With a gap of its own a run is a trial, after which the next one goes on with what the document is then; what was shown stays until
  // there is something else.
  start(gap = null) {
    if (this.state === 'running' && this.isTrying) { this.next = {gap}; return; }
    // A trial ends the run before it.
    if (this.state === 'running' && gap === null) return;
    const problem = this.store.problem, seconds = Number(get('seconds').value) || null, wasTrying = this.isTrying;
    this.id = this.link.number();
    Object.assign(this, {problem, steps: [], answer: null, failure: null, cases: null, quantity: null, begun: performance.now(), state: 'running', isTrying: gap !== null, next: null});
    if (!this.isTrying && !wasTrying) this.shown(null, null);
    if (!this.link.send({type: 'solve', id: this.id, problem, budget: {max_gap: gap ?? Number(get('gap').value), max_seconds: seconds}})) {
      this.fail({words: 'there is no connection to the workbench; nothing is lost, try again when it is back'});
      return;
    }
    if (!this.isTrying) say('solving');
    this.draw();
  }

  stop() { this.next = null; this.link.send({type: 'stop'}); get('progress').textContent = 'stopping with the best bounds so far'; }

  hear(message) {
    if (message.id !== this.id || this.state !== 'running') return;
    switch (message.type) {
      case 'proven': this.steps.push(message); break;
      case 'cases': this.cases = message; break;
      case 'solved':
        Object.assign(this, {state: 'solved', answer: message.answer});
        this.shown(message.field, this.problem);
        if (this.next) { this.draw(); this.start(this.next.gap); return; }
        say(`solved: ${this.words()}`);
        break;
      case 'stopped': this.state = 'stopped'; say('stopped'); break;
      case 'failed': this.fail(message.error); return;
      default: return;
    }
    this.draw();
  }

  fail(error) {
    const {next} = this;
    this.next = null;
    Object.assign(this, {state: 'failed', failure: error});
    say(error.words);
    this.draw();
    if (next && this.link.connected) this.start(next.gap);
  }

  lost() { if (this.state === 'running') this.fail({words: 'the connection was lost while it was solved; the problem is still here, solve it again'}); }

  // Whether the document has changed since.
  get isStale() { return this.state === 'solved' && JSON.stringify(this.problem) !== JSON.stringify(this.store.problem); }

  words() {
    const {answer} = this, {name, unit} = WORDS[answer.quantity];
    return `${name}: between ${[answer.lower, answer.upper].map(value => short(inUnit(value, unit), 5)).join(' and ')} ${named(unit)}`.trim();
  }

  draw() {
    const isRunning = this.state === 'running';
    get('solve').disabled = isRunning;
    get('stop').hidden = !isRunning;
    const last = this.steps.at(-1), {answer} = this;
    const unit = answer ? WORDS[answer.quantity].unit : '';
    get('scale').replaceChildren(...(this.steps.length ? [scale(this.steps.map(step => answer && step === last && !answer.cases.length ? {...step, lower: answer.lower, upper: answer.upper} : step).map(step => ({...step, lower: inUnit(step.lower, unit), upper: inUnit(step.upper, unit)})), named(unit))] : []));
    get('progress').textContent = isRunning ? this.progress() : '';
    get('bounds').replaceChildren(...this.summary(last));
    get('findings').replaceChildren(...(answer ? this.findings() : []));
    get('stale').hidden = !this.isStale;
    get('kept').hidden = this.state !== 'solved';
    document.body.dataset.solver = this.state;
  }

  progress() {
    const last = this.steps.at(-1);
    if (this.cases) return `${this.cases.done} of ${this.cases.of} cases are done`;
    if (!last) return 'first mesh';
    const trial = last.trial === null ? '' : `, strength over ${short(last.trial)}`;
    return `level ${this.steps.length}: ${short(last.elements)} elements${trial}, ${last.seconds.toFixed(1)} s`;
  }

  summary(last) {
    if (this.state === 'failed') return [html('p', {class: 'verdict bad', id: 'failure'}, this.failure.words)];
    const {answer} = this;
    if (!answer) {
      if (this.state === 'stopped') {
        const left = last ? [this.pair(last.lower, last.upper, '', 'when it was stopped; each of these is proven')] : [];
        return [html('p', {class: 'verdict note', id: 'stopped'}, last ? 'Stopped with the best bounds so far. The mechanism and the certificate are those of a run that ends by itself.' : 'Stopped before anything was proven.'), ...left];
      }
      if (!last) return this.state === 'idle' ? [html('p', {class: 'faint'}, 'Solve proves a lower and an upper bound: the true value for rigid-plastic soil with associated flow lies between them.')] : [];
      return [this.pair(last.lower, last.upper, '', 'so far; each of these is proven')];
    }
    const {name, unit} = WORDS[answer.quantity];
    const gap = answer.gap === null ? '' : `gap ${short(100 * answer.gap, 3)} %`;
    const proof = html('p', {class: answer.certified ? 'proof good' : 'proof bad', id: 'proof'}, answer.certified ? 'Both bounds are proven with interval arithmetic.' : 'Bounds that are told are proven; some cases have none.');
    const pushed = answer.quantity === 'force_kn_per_m' && answer.upper < 0 ? html('p', null, `The soil pushes the structure on, with ${short(inUnit(-answer.upper, unit))} to ${short(inUnit(-answer.lower, unit))} ${named(unit)}.`) : null;
    const ended = html('p', {class: 'faint'}, [gap, `${short(answer.seconds, 3)} s`, `${short(answer.upper_elements)} elements`, ENDED[answer.ended] ?? ''].filter(Boolean).join(', '));
    return [html('p', {class: 'quantity'}, `${name[0].toUpperCase()}${name.slice(1)}${answer.governing ? `, least of all cases: ${answer.governing}` : ''}`), this.pair(answer.lower, answer.upper, unit, ''), pushed, proof, ended].filter(Boolean);
  }

  pair(lower, upper, unit, words) {
    const one = (name, value) => html('div', {class: name}, html('dt', null, name === 'lower' ? 'at least' : 'at most'), html('dd', {'data-value': value ?? ''}, short(inUnit(value, unit), 5), html('small', null, ` ${named(unit)}`)));
    return html('div', null, html('dl', {class: 'pair'}, one('lower', lower), one('upper', upper)), words ? html('p', {class: 'faint'}, words) : null);
  }

  findings() {
    const {answer} = this, {results} = answer, parts = [];
    const table = (caption, head, rows) => html('div', {class: 'table', tabindex: 0, role: 'group', 'aria-label': caption}, html('table', null, html('caption', null, caption), html('thead', null, html('tr', null, ...head.map(words => html('th', {scope: 'col'}, words)))), html('tbody', null, ...rows.map(row => html('tr', null, ...row.map((cell, k) => k ? html('td', null, cell) : html('th', {scope: 'row'}, cell)))))));
    if (answer.cases.length) parts.push(table('Cases', ['case', 'lower', 'upper', 'one or more'], answer.cases.map(one => [one.name, short(one.lower), short(one.upper), one.problem ?? ({true: 'yes', false: 'no'})[one.enough] ?? '–'])));
    if (results.contacts.length) parts.push(table('Forces on faces (lower bound)', ['face', `normal ${named('kN/m')}`, `shear ${named('kN/m')}`, `most ${named('kPa')}`, `centre ${named('m')}`], results.contacts.map(one => [one.face, short(inUnit(one.normal_force, 'kN/m')), short(inUnit(one.shear_force, 'kN/m')), short(inUnit(one.greatest_pressure, 'kPa')), short(inUnit(one.centre, 'm'), 3)])));
    if (results.moving_ground.length) parts.push(table('Ground that moves (upper bound)', [`from x, y in ${named('m')}`, `to x, y in ${named('m')}`], results.moving_ground.map(one => [one.from, one.to].map(p => p.map(x => short(inUnit(x, 'm'), 3)).join(', ')))));
    if (answer.trials.length) parts.push(table('Factors that were tried', ['strength over', 'bears at least', 'at most'], answer.trials.map(one => [short(one.factor, 5), short(one.borne_lower), short(one.borne_upper)])));
    else if (this.steps.length) parts.push(table('Levels', ['elements', 'lower', 'upper', 's'], this.steps.map(one => [short(one.elements), short(one.lower), short(one.upper), one.seconds.toFixed(1)])));
    return parts;
  }
}
