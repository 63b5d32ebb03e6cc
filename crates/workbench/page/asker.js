// Asks one question at a time. Of those that come while it is answered only the last is asked, so that who drags a slider never waits for
// what was.

export class Asker {
  // `told` is told each answer, null if nobody answers, and whether another one follows at once.
  constructor(link, type, told) { Object.assign(this, {link, type, told, isAsked: false, next: null}); }

  ask(question) {
    if (this.isAsked) this.next = question; else this.go(question);
  }

  get isBusy() { return this.isAsked; }

  async go(question) {
    this.isAsked = true;
    const answer = await this.link.ask({type: this.type, [this.type]: question}, this.type), {next} = this;
    Object.assign(this, {isAsked: false, next: null});
    if (next) this.go(next);
    this.told(answer, question, Boolean(next));
  }
}
