// Messages there and back, whoever answers: a server, or workers of this browser.

export class Messages {
  // `hear` is told each message, `lost` why nobody answers.
  constructor(hear, lost) { Object.assign(this, {hear, lost, next: 1, waiting: new Map()}); }

  number() { return this.next++; }

  // The answer of one of these types; null if there will be none.
  ask(message, ...types) {
    const id = this.number();
    return new Promise(done => {
      this.waiting.set(id, {types, done});
      if (!this.send({...message, id})) { this.waiting.delete(id); done(null); }
    });
  }

  heard(text) {
    const message = JSON.parse(text), answer = this.waiting.get(message.id);
    if (answer && answer.types.includes(message.type)) { this.waiting.delete(message.id); answer.done(message); }
    this.hear(message);
  }

  // Nothing that was asked will be answered any more.
  forget() {
    for (const {done} of this.waiting.values()) done(null);
    this.waiting.clear();
  }
}
