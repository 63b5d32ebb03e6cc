// The problem file as text: what is typed there is read, and what is drawn is written there. Comments stay as long as only the text is edited.
import {get, say} from './dom.js';

const WAIT_MS = 350;

export class TextTab {
  constructor(store, link) {
    // Texts with the documents that they hold: what somebody wrote, and what was made of the document as it is now.
    Object.assign(this, {store, link, area: get('toml'), written: {text: '', of: null}, made: {text: '', of: null}, timer: 0});
    this.area.addEventListener('input', () => { clearTimeout(this.timer); this.timer = setTimeout(() => this.read(), WAIT_MS); this.isTyped = true; });
  }

  // A text that somebody wrote, and the document that it holds.
  wrote(text, problem) { this.written = {text, of: JSON.stringify(problem)}; this.show(); }

  // The text that was made of a document.
  know(text, problem) { this.made = {text, of: JSON.stringify(problem)}; this.show(); }

  // Writes the text of the document, but not over one that is being typed, nor over one that is wrong until something else is changed.
  show() {
    const text = this.of(this.store.problem);
    if (text === null || document.activeElement === this.area || this.wrongWith === this.store.problem) return;
    if (this.area.value !== text) this.area.value = text;
    this.wrong(null);
  }

  // The text of the document, if it is known. What somebody wrote goes before what was made of it, also when an undo comes back to it.
  of(problem) {
    const of = JSON.stringify(problem), found = [this.written, this.made].find(one => one.of === of);
    return found ? found.text : null;
  }

  // Reads what was typed just now; says what is wrong with the text, or nothing.
  async flush() {
    clearTimeout(this.timer);
    if (this.isTyped) await this.read();
    return this.wrongWith === this.store.problem ? get('toml-wrong').textContent : null;
  }

  async read() {
    this.isTyped = false;
    const text = this.area.value, answer = await this.link.ask({type: 'read', text}, 'read');
    if (!answer || text !== this.area.value) return;
    if (answer.error) { this.wrong(answer.error.words); return; }
    this.written = {text, of: JSON.stringify(answer.problem)};
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
