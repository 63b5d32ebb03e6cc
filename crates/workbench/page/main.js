// What holds all parts together.
import {begin} from './begin.js';
import {controls} from './controls.js';
import {get, html, say, short} from './dom.js';
import {Editor, TOOLS} from './editor.js';
import {Files} from './files.js';
import {Flow} from './flow.js';
import {forgetWork, keep, keepWork, kept, keptWork} from './keep.js';
import {Inside} from './inside.js';
import {Link} from './link.js';
import * as model from './model.js';
import {Panel} from './panel.js';
import {Probe} from './probe.js';
import {Proof} from './proof.js';
import {draw} from './section.js';
import {Solver} from './solver.js';
import {Store} from './store.js';
import {TextTab} from './text.js';
import {keptTheme} from './theme.js';
import {areCustomary, inUnit, unit} from './units.js';
import {Variant} from './variant.js';
import {View} from './view.js';
import {WhatIf} from './whatif.js';

// So long nobody types before the document is looked at.
const CHECK_MS = 120;

const section = get('section');
const store = new Store(model.empty()), view = new View();
// `of` is the document that was understood, `checked` the one that was looked at last.
const state = {understood: null, of: null, checked: null, errors: [], notes: [], checks: 0, asked: 0, answered: 0, templates: [], greeted: false};
const editor = new Editor(store, view, section, what => { if (what === 'choice') chosen(); if (what) tools(); later(); }, points => probe.along(points));
const panel = new Panel(store, editor);
const flow = new Flow(get('flow'), view);
// A page of a static site has no server.
const isInside = document.documentElement.dataset.solver === 'inside';
const link = new (isInside ? Inside : Link)(hear, lost);
const text = new TextTab(store, link);
const solver = new Solver(store, link, showFlow);
const whatIf = new WhatIf(store, editor, solver);
const files = new Files(store, link, {settle, take, section, view, flow, certify: (name, text) => proof.check(name, text)});
const variant = new Variant({store, view, solver, flow, state, later: () => later()});
const probe = new Probe(link, solver, {tell: (words, tone) => files.tell(words, tone), tab, later: () => later()});
const proof = new Proof(link, solver, {tell: (words, tone) => files.tell(words, tone), tab});

// Shows what is chosen in the panel, where that stands beside the drawing.
function chosen() {
  due = true;
  whatIf.choose();
  later();
  if (editor.chosen && matchMedia('(min-width: 821px)').matches) requestAnimationFrame(() => get('chosen').parentElement.scrollIntoView({block: 'nearest'}));
}

// Fields are filled at the next picture, once, however much was changed until then.
function fill() {
  due = false;
  panel.update();
  panel.mark(state.errors, state.notes);
}

let waiting = false, due = false, timer = 0, resolveSettled = [];

// Draws at the next picture, once.
function later() {
  if (waiting) return;
  waiting = true;
  requestAnimationFrame(() => {
    waiting = false;
    if (due) fill();
    const isStale = state.of !== store.problem, isChecked = state.checked === store.problem;
    draw(section, {problem: store.problem, view, editor, understood: state.understood, isStale, errors: isChecked ? state.errors : [], notes: isChecked ? state.notes : [], hasFlow: Boolean(flow.field), probe: probe.line});
    flow.draw();
    variant.draw();
    status();
  });
}

function status() {
  const at = editor.cursor;
  const moves = at && flow.at(at);
  get('place').textContent = at ? `${at.map(x => short(inUnit(x, 'm'), 5)).join(', ')} ${unit('m')}${moves ? `, moves ${short(moves[0], 2)}, ${short(moves[1], 2)} of the fastest` : ''}` : '';
  get('step').textContent = `grid ${short(inUnit(view.step(), 'm'))} ${unit('m')}`;
}

function changed() {
  if (editor.chosen && !model.entry(store.problem, editor.chosen)) Object.assign(editor, {chosen: null, point: null});
  const shape = editor.shape;
  if (editor.point !== null && !shape?.points[editor.point]) editor.point = null;
  due = true;
  whatIf.update();
  if (flow.field && solver.isStale && !whatIf.isDragged) { flow.show(null); get('motion').hidden = true; }
  solver.draw();
  get('undo').disabled = !store.past.length;
  get('redo').disabled = !store.future.length;
  get('dirty').hidden = !store.dirty;
  document.title = `${store.dirty ? '• ' : ''}${files.name ?? store.problem.title ?? 'problem'} – soilctl workbench`;
  if (state.greeted) { if (store.dirty) keepWork(files.name, store.problem); else forgetWork(files.name); }
  clearTimeout(timer);
  timer = setTimeout(check, CHECK_MS);
  later();
}

// Asks what is understood of the document.
function check() {
  clearTimeout(timer);
  if (!model.list(store.problem, 'region').length && !model.allPoints(store.problem).length) {
    // Nothing is wrong with an empty sheet.
    Object.assign(state, {understood: null, errors: [], notes: [], of: store.problem, checked: store.problem});
    messages();
  }
  state.asked = link.number();
  state.sent = store.problem;
  if (!link.send({type: 'check', id: state.asked, problem: store.problem})) state.asked = 0;
}

function checked(message) {
  if (message.id !== state.asked) return;
  const problem = state.sent, isEmpty = !model.allPoints(problem).length;
  state.answered = message.id;
  // The text of what is no longer there is of no use.
  if (message.toml !== null && problem === store.problem) text.know(message.toml, problem);
  state.errors = message.error && !isEmpty ? [message.error] : [];
  state.notes = message.notes;
  if (message.understood) state.understood = message.understood;
  // What was understood before fades where nothing is understood now.
  state.of = message.error ? null : problem;
  state.checked = problem;
  for (const resolve of resolveSettled.splice(0)) resolve();
  messages();
  later();
}

// What is wrong, below the drawing and at the fields it is about.
function messages() {
  const place = get('messages'), all = [...state.errors.map(error => [error, 'bad']), ...state.notes.map(note => [note, 'note'])];
  const before = place.dataset.words, isEmpty = !model.allPoints(store.problem).length;
  const words = all.length ? all.map(([one]) => one.words).join('\n') : isEmpty ? 'An empty sheet.' : 'The problem is understood.';
  if (!due) panel.mark(state.errors, state.notes);
  if (before === words && place.childElementCount) return;
  place.dataset.words = words;
  const item = ([one, kind]) => {
    const at = one.entries.find(entry => model.shapeOf(store.problem, entry) ?? model.entry(store.problem, entry));
    const canShow = at && model.SECTIONS.includes(at.section);
    return html('li', {class: kind}, html('span', null, one.words), canShow ? html('button', {type: 'button', class: 'small', click: () => { editor.use('select'); editor.choose(at); tab('problem'); }}, 'Show') : null);
  };
  place.replaceChildren(...(all.length ? all.map(item) : [html('li', {class: 'good'}, words)]));
}

// The text of the document as it is now, or why it has none.
async function settle() {
  const wrong = await text.flush();
  if (wrong) return {words: null, why: `the text is no problem file yet: ${wrong}`};
  for (let k = 0; k < 3 && text.of(store.problem) === null; k++) {
    check();
    if (!state.asked) return {words: null, why: 'there is no connection to the workbench'};
    await new Promise(resolve => { resolveSettled.push(resolve); setTimeout(resolve, 5000); });
  }
  return {words: text.of(store.problem), why: 'the problem cannot be written: it has a value that is missing or of the wrong kind'};
}

// A document from elsewhere, with the text that it was.
function take(words, problem) {
  if (words !== null) text.wrote(words, problem);
  Object.assign(editor, {chosen: null, point: null, drawn: [], tool: 'select', soil: 0});
  store.replace(problem);
  view.fit(model.allPoints(problem));
  tools();
}

function showFlow(field, problem) {
  flow.show(field, problem);
  if (problem) probe.again();
  get('motion').hidden = !field;
  const isCalm = matchMedia('(prefers-reduced-motion: reduce)').matches;
  get('play').setAttribute('aria-pressed', String(Boolean(field) && !isCalm));
  flow.play(Boolean(field) && !isCalm);
  later();
}

function hear(message) {
  switch (message.type) {
    case 'hello': hello(message); break;
    case 'file': opened(message); break;
    case 'checked': checked(message); break;
    case 'error':
      // A page whose token is refused does without the file.
      if (!state.greeted) start(null);
      files.tell(message.error.words, 'bad');
      break;
    default: solver.hear(message);
  }
}

function hello({file, templates}) {
  connection('ready', isInside ? 'solves in this browser' : file ? 'connected' : 'no file');
  files.name = file;
  get('save').textContent = file ? 'Save' : 'Download';
  get('download').hidden = !file;
  get('source').textContent = file ?? '';
  state.templates = templates;
  begin(templates, problem => take(null, problem));
  if (state.greeted) { check(); return; }
  // A page that may have the file waits for it.
  if (!file || !kept('session', 'token')) start(null);
}

function opened({text: words, problem, error}) {
  if (state.greeted) return;
  if (error) {
    start(null, words !== null);
    files.tell(error.words, 'bad');
    if (words === null) return;
    get('toml').value = words;
    text.wrong(error.words);
    tab('text');
    return;
  }
  if (problem) text.wrote(words, problem);
  start(problem);
}

// Begins with the file, with unsaved work that the browser kept, or with a choice.
// Who has a file that is no problem has a text to mend, and nothing to choose.
function start(problem, hasText = false) {
  const work = keptWork(files.name, problem => model.allPoints(problem) && JSON.stringify(model.list(problem, 'soil').map(soil => soil.name)));
  if (problem) { store.problem = problem; store.saved = JSON.stringify(problem); }
  state.greeted = true;
  if (work && JSON.stringify(work) !== JSON.stringify(store.problem)) {
    store.replace(work);
    files.tell(problem ? 'unsaved work of this browser is shown; undo takes the file as it is' : 'unsaved work of this browser is shown', 'good');
  } else if (!problem) { store.tell(); if (!hasText) get('begin').showModal(); } else store.tell();
  view.fit(model.allPoints(store.problem));
}

// Everything that has a unit, anew.
function newUnits() {
  get('units').setAttribute('aria-pressed', String(areCustomary()));
  get('exact-unit').textContent = unit('m');
  panel.update(true);
  whatIf.made = variant.drawn = '';
  whatIf.update();
  solver.draw();
  if (probe.line) probe.read();
  later();
}

function lost(reason) { connection('lost', reason ? `lost: ${reason}` : 'no connection'); solver.lost(); }
function connection(now, words) { Object.assign(get('link').dataset, {state: now}); get('link').textContent = words; }

function tab(name) {
  for (const button of document.querySelectorAll('[role=tab]')) {
    const is = button.dataset.tab === name;
    button.setAttribute('aria-selected', String(is));
    button.tabIndex = is ? 0 : -1;
    get(`panel-${button.dataset.tab}`).hidden = !is;
  }
  keep('session', 'tab', name);
  if (name === 'text') text.show();
}

function tools() {
  for (const button of document.querySelectorAll('[data-tool]')) button.setAttribute('aria-pressed', String(button.dataset.tool === editor.tool));
  const isDrawing = editor.tool !== 'select';
  get('drawing').hidden = !isDrawing;
  get('kind-of-line').hidden = editor.tool !== 'line';
  get('done').disabled = editor.drawn.length < (TOOLS[editor.tool].least ?? 1);
  get('back').disabled = !editor.drawn.length;
  section.dataset.tool = editor.tool;
}

new ResizeObserver(([{contentRect}]) => {
  const first = view.width === 100;
  view.size(contentRect.width, contentRect.height);
  if (first) view.fit(model.allPoints(store.problem));
}).observe(get('view'));
addEventListener('beforeunload', event => { if (store.dirty && !kept('local', `work.${files.name ?? ''}`)) event.preventDefault(); });
matchMedia('(prefers-color-scheme: dark)').addEventListener('change', later);
store.listen(changed);
view.listen(later);
controls({store, view, editor, flow, text, solver, files, section, tab, showFlow, later, newUnits});
keptTheme();
tab(kept('session', 'tab') ?? 'problem');
tools();
newUnits();
changed();
solver.draw();

// For whoever looks at the page from outside.
window.workbench = {store, view, editor, model, state, solver, flow, variant, files, link, settle, say};
