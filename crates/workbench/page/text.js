// The problem file as text: what is typed there is read, and what is drawn is written there. Comments stay as long as only the text is edited.
import {get, say} from './dom.js';

const WAIT_MS = 350;

export class TextTab {
  constructor(store, link) {
    // The text that says just what the document `of` says.
    Object.assign(this, {store, link, area: get('toml'), source: {text: '', of: null}, timer: 0});
    this.area.addEventListener('input', () => { clearTimeout(this.timer); this.timer = setTimeout(() => this.read(), WAIT_MS); });
  }

  // A text and the document that it holds, from a file or from a check.
  know(text, problem) {
    const of = JSON.stringify(problem);
    // What the author wrote goes before what was made of it.
    if (this.source.of !== of) this.source = {text, of};
    this.show();
  }

  // Writes the text of the document, but not over one that is being typed, nor over one that is wrong until something else is changed.
  show() {
    const text = this.of(this.store.problem);
    if (text === null || document.activeElement === this.area || this.wrongWith === this.store.problem) return;
    if (this.area.value !== text) this.area.value = text;
    this.wrong(null);
  }

  // The text of the document, if it is known.
  of(problem) { return this.source.of === JSON.stringify(problem) ? this.source.text : null; }

  async read() {
    const text = this.area.value, answer = await this.link.ask({type: 'read', text}, 'read');
    if (!answer || text !== this.area.value) return;
    if (answer.error) { this.wrong(answer.error.words); return; }
    this.source = {text, of: JSON.stringify(answer.problem)};
    this.wrong(null);
    this.store.change(draft => { for (const key of Object.keys(draft)) delete draft[key]; Object.assign(draft, answer.problem); }, 'text');
  }

  wrong(words) {
    this.wrongWith = words ? this.store.problem : null;
    get('toml-wrong').hidden = !words;
    get('toml-wrong').textContent = words ?? '';
    this.area.setAttribute('aria-invalid', String(Boolean(words)));
    if (words) say(words);
  }
}
