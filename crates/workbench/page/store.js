// The document and its history. A document is what the problem file says, in its JSON form; each change makes a new one, so that nothing
// that was is lost: undo goes back to the very start.

export class Store {
  constructor(problem) {
    Object.assign(this, {problem, past: [], future: [], listeners: [], joined: null, saved: JSON.stringify(problem)});
  }

  // `edit` changes a copy of the document. Changes with the same `join` that follow each other are one step back: a drag, or
  // what is typed into one field.
  change(edit, join = null) {
    const draft = structuredClone(this.problem);
    const result = edit(draft);
    if (JSON.stringify(draft) === JSON.stringify(this.problem)) return result;
    if (join === null || join !== this.joined) this.past.push(this.problem);
    this.joined = join;
    this.future = [];
    this.problem = draft;
    this.tell();
    return result;
  }

  // Another document in place of this one; undo brings this one back.
  replace(problem) { this.change(draft => { for (const key of Object.keys(draft)) delete draft[key]; Object.assign(draft, structuredClone(problem)); }); }

  // What comes now is a step of its own.
  rest() { this.joined = null; }

  undo() { return this.step(this.past, this.future); }
  redo() { return this.step(this.future, this.past); }

  step(from, to) {
    if (!from.length) return false;
    to.push(this.problem);
    this.problem = from.pop();
    this.joined = null;
    this.tell();
    return true;
  }

  get dirty() { return JSON.stringify(this.problem) !== this.saved; }
  markSaved(problem = this.problem) { this.saved = JSON.stringify(problem); this.tell(); }

  listen(hear) { this.listeners.push(hear); }
  tell() { for (const hear of this.listeners) hear(this.problem); }
}
