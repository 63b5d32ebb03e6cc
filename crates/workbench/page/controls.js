// Buttons and keys of the whole page; those of the drawing are the editor's.
import {get, html} from './dom.js';
import {TOOLS} from './editor.js';
import {KINDS} from './fields.js';
import {parse} from './form.js';
import * as model from './model.js';
import {turnTheme} from './theme.js';
import {fromField, turnUnits} from './units.js';

export function controls({store, view, editor, flow, text, solver, files, section, tab, showFlow, later, newUnits}) {
  for (const [tool, {name, key}] of Object.entries(TOOLS)) {
    get('tools').append(html('button', {type: 'button', 'data-tool': tool, title: `${name} (${key.toUpperCase()})`, 'aria-pressed': 'false', click: () => { editor.use(tool); section.focus({preventScroll: true}); }}, name));
  }
  get('kind').replaceChildren(...KINDS.filter(([kind]) => kind !== 'load').map(([value, words]) => html('option', {value}, words)));
  const on = (id, run, event = 'click') => get(id).addEventListener(event, run);
  on('kind', () => { editor.kind = get('kind').value; }, 'change');
  on('done', () => editor.finish());
  on('back', () => editor.back());
  on('cancel', () => editor.cancel());
  on('exact', event => {
    event.preventDefault();
    // A comma between the two numbers, or a semicolon or blank where the comma is in them.
    const parts = get('exact-point').value.trim().split(/\s*;\s*|\s*,\s+|\s+|,/).map(parse);
    if (parts.length !== 2 || parts.includes(null)) { get('exact-point').setCustomValidity('two numbers, such as 2.5, -3'); get('exact-point').reportValidity(); return; }
    editor.put(parts.map(part => fromField(part, 'm')));
    get('exact-point').value = '';
  }, 'submit');
  on('exact-point', () => get('exact-point').setCustomValidity(''), 'input');
  on('undo', () => store.undo());
  on('redo', () => store.redo());
  on('fit', () => view.fit(model.allPoints(store.problem)));
  on('zoom-in', () => view.zoom(1.3));
  on('zoom-out', () => view.zoom(1 / 1.3));
  on('snap', () => { editor.grid = !editor.grid; get('snap').setAttribute('aria-pressed', String(editor.grid)); });
  on('mirror', () => store.change(draft => model.mirror(draft)));
  on('begin-open', () => get('begin').showModal());
  on('help-open', () => get('help').showModal());
  on('theme', () => { turnTheme(); later(); });
  on('units', () => { turnUnits(); newUnits(); });
  on('play', () => { const now = get('play').getAttribute('aria-pressed') !== 'true'; get('play').setAttribute('aria-pressed', String(now)); flow.play(now); });
  on('amount', () => { flow.amount = Number(get('amount').value); get('play').setAttribute('aria-pressed', 'false'); flow.play(false); }, 'input');
  on('closer', () => view.fit(flow.moving?.length ? flow.moving : model.allPoints(store.problem)));
  on('flow-off', () => showFlow(null, null));
  for (const button of document.querySelectorAll('[role=tab]')) {
    button.addEventListener('click', () => tab(button.dataset.tab));
    button.addEventListener('keydown', event => {
      const step = {ArrowRight: 1, ArrowLeft: -1}[event.key], all = [...document.querySelectorAll('[role=tab]')];
      if (!step) return;
      const next = all[(all.indexOf(button) + step + all.length) % all.length];
      tab(next.dataset.tab);
      next.focus();
    });
  }

  addEventListener('keydown', event => {
    const command = event.ctrlKey || event.metaKey, key = event.key.toLowerCase(), isField = event.target.matches?.('input:not([type=checkbox], [type=radio], [type=range]), textarea, select');
    const use = run => { event.preventDefault(); run(); };
    if (document.querySelector('dialog[open]')) return;
    if (command && key === 's') return use(() => files.save());
    if (command && key === 'enter') return use(() => { tab('result'); solver.start(); });
    if (command && key === 'o') return use(() => get('open').click());
    // In the text, the browser's own undo.
    if (command && key === 'z' && event.target !== text.area) return use(() => event.shiftKey ? store.redo() : store.undo());
    if (command && key === 'y' && event.target !== text.area) return use(() => store.redo());
    if (command && key === 'd' && editor.shape) return use(() => editor.choose(store.change(draft => model.duplicate(draft, editor.chosen))));
    if (command || event.altKey || isField) return;
    const tool = Object.entries(TOOLS).find(([, {key: own}]) => own === key);
    if (tool) return use(() => { editor.use(tool[0]); section.focus({preventScroll: true}); });
    const act = {f: 'fit', g: 'snap', '?': 'help-open', '+': 'zoom-in', '-': 'zoom-out', t: 'begin-open', m: 'mirror'}[key];
    if (act) use(() => get(act).click());
  });
}
