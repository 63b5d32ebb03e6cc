// The strokes of the bench: a table that is typed, pasted or dragged, and what it says.
import {Asker} from './asker.js';
import {get, html, say, short} from './dom.js';
import {download} from './files.js';
import {parse} from './form.js';
import {keep, kept} from './keep.js';
import {NAMES} from './plate_forces.js';
import {Bands} from './stroke_bands.js';
import {Next} from './stroke_next.js';
import {StrokeRows} from './stroke_rows.js';
import {StrokeTable} from './stroke_table.js';

const TYPED_MS = 120, REST_MS = 700, MOST_BYTES = 1 << 20;
// What is known beside the table; null: nothing.
const KNOWN = {model: 'table', delta_deg: null, delta_tol_deg: 1, density_kg_m3: null, density_tol: .04, force_limit_n: null};
const FIELDS = [['delta_deg', 'Interface friction', '°', 1, 'as in the table'], ['delta_tol_deg', 'known to ±', '°', 1], ['density_kg_m3', 'Density', 'kg/m³', 1, 'unknown'], ['density_tol', 'known to ±', '%', 100], ['force_limit_n', 'The arm exerts', 'N', 1, 'any force']];

function keptKnown() {
  try { return {...KNOWN, ...Object.fromEntries(Object.entries(JSON.parse(kept('local', 'known')) ?? {}).filter(([key]) => key in KNOWN))}; } catch { return {...KNOWN}; }
}

export class Strokes {
  // `soil()` is that of the sliders; `attempt` takes a candidate and a soil to them; `takeSoil` a soil.
  constructor(link, {soil, attempt, takeSoil}) {
    const table = new StrokeTable(kept('local', 'strokes') ?? ''), rows = new StrokeRows(table);
    Object.assign(this, {table, rows, soil, takeSoil, known: keptKnown(), bands: new Bands(rows), next: new Next(one => attempt(one, this.shown?.answer.best_estimate)), asker: new Asker(link, 'strokes', (...all) => this.told(...all)), chooser: new Asker(link, 'next', (...all) => this.chosen(...all)), shown: null, candidates: null, answered: 0, timer: 0, rest: 0});
    const area = this.area = get('csv');
    area.value = table.csv;
    area.addEventListener('input', () => table.set(area.value, 'typed'));
    area.addEventListener('dragover', event => event.preventDefault());
    area.addEventListener('drop', event => { const [file] = event.dataTransfer.files; if (file) { event.preventDefault(); this.open(file); } });
    get('open').addEventListener('click', () => get('file').click());
    get('file').addEventListener('change', () => { this.open(get('file').files[0]); get('file').value = ''; });
    get('download').addEventListener('click', () => download('strokes.csv', 'text/csv', table.csv));
    get('undo').addEventListener('click', () => table.undo());
    get('example').addEventListener('click', () => { if (this.example) { table.set(this.example.csv); get('example-words').textContent = this.example.source; } });
    table.listen(() => this.changed());
  }

  // The models are those that the plate knows.
  hello(example, models) {
    this.example = example;
    const {known} = this, change = () => { keep('local', 'known', JSON.stringify(known)); this.ask(); };
    const choice = html('select', {id: 'known.model', change: () => { known.model = choice.value; change(); }}, ...models.map(id => html('option', {value: id}, NAMES[id] ?? id)));
    choice.value = known.model;
    const field = ([key, label, unit, scale, hint]) => {
      const input = html('input', {id: `known.${key}`, inputmode: 'decimal', autocomplete: 'off', placeholder: hint, value: known[key] === null ? '' : short(known[key] * scale), 'aria-label': `${label} in ${unit}`, input: () => {
        const value = parse(input.value), isNone = !input.value.trim() && hint;
        input.setAttribute('aria-invalid', String(value === null && !isNone));
        if (value !== null || isNone) { known[key] = isNone ? null : value / scale; change(); }
      }});
      return html('div', {class: 'field'}, html('label', {for: input.id}, label), html('span', {class: 'control'}, input, html('span', {class: 'unit'}, unit)));
    };
    get('known').replaceChildren(html('div', {class: 'field'}, html('label', {for: 'known.model'}, 'Force model'), html('span', {class: 'control'}, choice)), html('div', {class: 'two'}, ...FIELDS.map(field)));
    this.ask();
  }

  async open(file) {
    if (!file) return;
    if (file.size > MOST_BYTES) { this.wrong(`${file.name} has more than 1 MiB; soilctl estimate reads it`); return; }
    this.table.set(await file.text());
  }

  changed() {
    const {area, table} = this;
    if (area.value !== table.csv) area.value = table.csv;
    get('undo').disabled = !table.past.length;
    keep('local', 'strokes', table.csv);
    clearTimeout(this.timer);
    // What is dragged is asked for at once, what is typed after a moment.
    if (document.activeElement === area) this.timer = setTimeout(() => this.ask(), TYPED_MS); else this.ask();
  }

  ask() {
    clearTimeout(this.rest);
    this.candidates = null;
    if (!this.table.csv.trim()) { this.wrong(null); this.nothing(); return; }
    this.asker.ask({csv: this.table.csv, ...this.known});
  }

  told(answer, question, isMore) {
    if (!answer) { this.wrong('there is no connection to the workbench; nothing is lost, it is estimated when that is back'); return; }
    const isNow = question.csv === this.table.csv;
    if (answer.error) {
      if (isNow) { this.wrong(answer.error.words); this.nothing(); }
      this.answered++;
      return;
    }
    this.wrong(null);
    const {shown} = answer, before = this.shown?.answer.verdict;
    Object.assign(this, {shown, csvOf: question.csv});
    this.rows.show(shown, isNow && !this.bands.held);
    this.draw();
    if (isNow && shown.answer.verdict !== before) say(shown.answer.verdict);
    this.answered++;
    // Which stroke next takes longer; it is asked for when all rests.
    if (isNow && !isMore && shown.answer.consistent) this.rest = setTimeout(() => this.chooser.ask(question), REST_MS);
  }

  // Which stroke next, unless all has changed since.
  chosen(answer, question) {
    if (!answer || question.csv !== this.table.csv || Object.keys(this.known).some(key => question[key] !== this.known[key])) return;
    Object.assign(this, {candidates: answer.strokes, why: answer.error?.words ?? 'No stroke of the menu is within the force of the arm and the model.'});
    this.draw();
  }

  nothing() {
    Object.assign(this, {shown: null, candidates: null});
    this.rows.outline = '';
    for (const id of ['rows', 'soil']) get(id).replaceChildren();
    get('bands-words').textContent = this.table.csv.trim() ? 'Nothing can be drawn of this table.' : 'Paste a table of strokes, or take the example.';
    this.draw();
  }

  draw() {
    const {shown} = this;
    this.bands.show(shown, this.soil());
    this.next.show(this.candidates, !shown ? 'Strokes come first.' : !shown.answer.consistent ? 'No soil explains all strokes; there is nothing to narrow.' : this.candidates ? this.why : 'Told when all rests.');
    if (shown) get('soil').replaceChildren(...this.words(shown.answer));
  }

  words(answer) {
    const pair = (name, [low, high], unit, digits) => html('div', null, html('dt', null, name), html('dd', {'data-low': low, 'data-high': high}, `${short(low, digits)} – ${short(high, digits)}`, html('small', null, ` ${unit}`)));
    const {best_estimate: best} = answer;
    const notes = [...answer.warnings, ...answer.cut_by.length ? [`The region touches the ${answer.cut_by.join(' and the ')}: it may reach further.`] : []];
    return [
      answer.consistent ? html('dl', {class: 'pair', id: 'intervals'}, pair('φ', answer.phi_deg, '°', 3), pair('ρ', answer.density_kg_m3, 'kg/m³', 4)) : null,
      html('p', {class: answer.consistent ? 'proof good' : 'verdict bad', id: 'verdict'}, answer.verdict),
      notes.length ? html('details', null, html('summary', null, `${notes.length} to keep in mind`), html('ul', {class: 'plain'}, ...notes.map(words => html('li', null, words)))) : null,
      best ? html('button', {type: 'button', id: 'take-soil', click: () => this.takeSoil(best)}, `Take the soil of least misfit (${short(best.phi_deg, 3)}°, ${short(best.density_kg_m3, 4)} kg/m³)`) : null,
    ].filter(Boolean);
  }

  wrong(words) {
    get('csv-wrong').hidden = !words;
    if (words && get('csv-wrong').textContent !== words) say(words);
    get('csv-wrong').textContent = words ?? '';
    this.area.setAttribute('aria-invalid', String(Boolean(words)));
  }
}
