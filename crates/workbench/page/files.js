// In and out: save, download, open from disk, a picture of the section.
import {get, html, say, short, svg} from './dom.js';

// What `soilctl solve --save` writes, and the page's own certificates.
// Drawings before 2007 are not UTF-8; names of layers are all that this matters for.
async function drawingText(file) {
  const bytes = await file.arrayBuffer();
  try { return new TextDecoder('utf-8', {fatal: true}).decode(bytes); } catch { return new TextDecoder('windows-1252').decode(bytes); }
}

const isCertificate = text => text.slice(0, 400).includes('"soilctl.solution/');

const PICTURE_STYLE = `text{font:12px system-ui,sans-serif;fill:#1f2328}.grid path{stroke:#000;stroke-opacity:.075;fill:none}.grid text{fill:#5a626b;font-size:10px}
.region{stroke:#444;stroke-width:1.2}.region.unknown{stroke:#b3261e;stroke-dasharray:4 3}.hatch{stroke:#0006;stroke-width:1;fill:none}.dot{stroke-width:2;stroke-linecap:round}
.side{fill:none;stroke:#1f2328;stroke-width:2}.side.far{stroke-dasharray:7 5;stroke-width:1.4}.side.smooth{stroke-width:1.2}.thin{stroke:#1f2328;stroke-width:.8;fill:none}.roller{fill:none;stroke:#1f2328;stroke-width:.8}
.acting .shaft{stroke:#c25400;fill:none;stroke-width:1.3}.acting .head{fill:#c25400}.live .shaft{stroke-width:2.2}.motion .shaft{stroke:#1f2328;stroke-width:3;fill:none}.motion .head{fill:#1f2328}
.pond{fill:#0072b233}.table{stroke:#0072b2;fill:none;stroke-width:1.5}.mark{fill:#0072b2}.body{fill:#8a8f96;stroke:#1f2328;stroke-width:1.5}.plate{fill:none;stroke:#1f2328;stroke-width:5}.member{fill:none;stroke:#b4470f;stroke-width:3}
.entry{fill:none;stroke:none}.name text{paint-order:stroke;stroke:#fff;stroke-width:4px;stroke-linejoin:round;font-weight:600}.name .small{font-weight:400}.value{paint-order:stroke;stroke:#fff;stroke-width:4px;stroke-linejoin:round}
${['#f3e2b3', '#d9e8d2', '#d6e4f2', '#eedbd3', '#e6dcef', '#dde3dd', '#f6e7ee', '#e3e0d2'].map((tint, k) => `.tint-${k}{fill:${tint}}`).join('')}`;

export function download(name, kind, content) {
  const url = URL.createObjectURL(new Blob([content], {type: kind}));
  const link = html('a', {href: url, download: name});
  document.body.append(link);
  link.click();
  link.remove();
  setTimeout(() => URL.revokeObjectURL(url), 1000);
}

// A name for a file from a title.
export const fileName = (problem, ending) => `${(problem.title ?? '').toLowerCase().replace(/[^a-z0-9]+/g, '_').replace(/^_|_$/g, '') || 'problem'}.${ending}`;

// The section as a picture of its own: in light colours, for paper, with the failure mechanism if it is shown.
export function picture(section, view, flow) {
  const copy = section.cloneNode(true);
  copy.setAttribute('xmlns', 'http://www.w3.org/2000/svg');
  for (const [name, value] of [['viewBox', `0 0 ${view.width} ${view.height}`], ['width', view.width], ['height', view.height]]) copy.setAttribute(name, value);
  for (const name of ['tabindex', 'role', 'aria-roledescription', 'aria-describedby', 'class', 'id']) copy.removeAttribute(name);
  for (const part of copy.querySelectorAll('.editing, .faults')) part.remove();
  const first = [svg('style', null, PICTURE_STYLE), svg('rect', {width: view.width, height: view.height, fill: '#fff'})];
  if (flow.field) first.push(svg('image', {href: flow.onPaper(), width: view.width, height: view.height}));
  copy.prepend(...first);
  return `<?xml version="1.0" encoding="UTF-8"?>\n${new XMLSerializer().serializeToString(copy)}\n`;
}

export class Files {
  // `settle` waits for the text of the document, or why there is none; `take` takes a document from elsewhere.
  constructor(store, link, {settle, take, section, view, flow, certify}) {
    Object.assign(this, {store, link, settle, take, certify, name: null});
    get('save').addEventListener('click', () => this.save());
    get('download').addEventListener('click', () => this.download());
    get('picture').addEventListener('click', () => { download(fileName(store.problem, 'svg'), 'image/svg+xml', picture(section, view, flow)); });
    get('dxf').addEventListener('click', () => this.drawing());
    get('open').addEventListener('click', () => get('file').click());
    get('file').addEventListener('change', () => this.open(get('file').files[0]));
  }

  async download() {
    const {words, why} = await this.settle();
    if (words === null) { this.tell(why, 'bad'); return; }
    download(this.name?.replace(/\.json$/, '.toml') ?? fileName(this.store.problem, 'toml'), 'application/toml', words);
  }

  async save(anyway = false) {
    if (!this.name) return this.download();
    const {words, why} = await this.settle(), {problem} = this.store;
    if (words === null) { this.tell(why, 'bad'); return; }
    const answer = await this.link.ask({type: 'save', text: words, anyway}, 'saved', 'not_saved');
    if (answer?.type === 'saved') { this.store.markSaved(problem); this.tell(`${answer.name} was saved`, 'good'); return; }
    this.tell(answer?.error.words ?? 'there is no connection, and nothing was saved; download the problem instead', 'bad');
    if (answer?.changed) get('told').append(' ', html('button', {type: 'button', click: () => this.save(true)}, 'Save over it'));
  }

  async open(file) {
    get('file').value = '';
    if (!file) return;
    if (/json$/i.test(file.name) && isCertificate(await file.slice(0, 400).text())) {
      if (file.size <= this.link.mostBytes) await this.certify(file.name, await file.text());
      else this.tell(`${file.name} has more than ${short(this.link.mostBytes / (1 << 20))} MiB; soilctl certify checks it`, 'bad');
      return;
    }
    if (/\.(dxf|geojson|csv)$/i.test(file.name)) return this.draw(file);
    if (file.size > 1 << 20) { this.tell(`${file.name} has more than 1 MiB; a problem file has at most that`, 'bad'); return; }
    const text = await file.text(), answer = await this.link.ask({type: 'read', text}, 'read');
    if (!answer || answer.error) { this.tell(`${file.name}: ${answer?.error.words ?? 'there is no connection'}`, 'bad'); return; }
    this.take(text, answer.problem);
    this.tell(`${file.name} was opened; undo brings back what was here`, 'good');
  }

  // A drawing becomes a problem. Its strengths are still to be put in, and what was not read is told.
  async draw(file) {
    if (file.size > this.link.mostBytes) { this.tell(`${file.name} has more than ${short(this.link.mostBytes / (1 << 20))} MiB; soilctl convert reads it`, 'bad'); return; }
    const answer = await this.link.ask({type: 'draw', name: file.name, text: await drawingText(file)}, 'drawn');
    if (!answer || answer.error) { this.tell(answer?.error.words ?? `${file.name}: there is no connection`, 'bad'); return; }
    this.take(null, answer.problem);
    this.tell([`${file.name} was opened; undo brings back what was here`, ...answer.notes].join('. '), 'good');
  }

  async drawing() {
    const answer = await this.link.ask({type: 'drawing', problem: this.store.problem}, 'drawing');
    if (!answer?.dxf) { this.tell(answer?.error.words ?? 'there is no connection', 'bad'); return; }
    download(fileName(this.store.problem, 'dxf'), 'image/vnd.dxf', answer.dxf);
  }

  tell(words, tone) { Object.assign(get('told'), {textContent: words}); get('told').dataset.tone = tone; say(words); }
}
