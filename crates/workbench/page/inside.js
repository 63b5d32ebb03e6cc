// In place of a server: the same program as a module, in two workers of this browser. One looks at problems, so that it always answers;
// the other one solves and estimates, and is ended to stop it, since a worker that works hears nothing.
import {Messages} from './messages.js';

const AGAIN_MS = 4000;
const BROKEN = 'the solver broke off: there was too little memory, or this is a fault of the program. The problem is still on the page';
// What is asked of the worker that solves, because it knows what it found.
const OF_SOLVER = ['solve', 'stop', 'certificate', 'report', 'probe', 'next'];

export class Inside extends Messages {
  constructor(hear, lost) {
    super(hear, lost);
    this.mostBytes = 256 << 20;
    this.open();
    // Without a network the page is there again after a reload.
    navigator.serviceWorker?.register('offline.js').catch(() => { /* then not */ });
  }

  // Loads script and module once; workers are made of them without the network.
  async open() {
    try {
      const [script, module] = await Promise.all(['engine.js', 'engine.wasm'].map(async name => {
        const answer = await fetch(name);
        if (!answer.ok) throw new Error(`${name}: ${answer.status}`);
        return answer.arrayBuffer();
      }));
      this.script = URL.createObjectURL(new Blob([script], {type: 'text/javascript'}));
      this.module = await WebAssembly.compile(module);
    } catch (problem) {
      this.lost(`the solver could not be loaded (${problem.message})`);
      setTimeout(() => this.open(), AGAIN_MS);
      return;
    }
    this.connected = true;
    this.startDesk();
    this.startSolver();
  }

  worker(hear, broke) {
    const worker = new Worker(this.script);
    worker.onmessage = event => hear(event.data);
    worker.onerror = event => { event.preventDefault(); worker.terminate(); broke(); };
    worker.postMessage(this.module);
    return worker;
  }

  startDesk() {
    this.asked = this.latest = null;
    this.desk = this.worker(text => this.ofDesk(text), () => {
      const {asked} = this;
      this.forget();
      this.startDesk();
      if (asked) this.hear({type: 'checked', id: asked.id, toml: null, understood: null, answer: null, notes: [], error: {words: 'the check broke off; this is a fault of the program', entries: [], key: null, points: []}});
    });
  }

  startSolver() {
    const isGreeting = text => text.startsWith('{"type":"hello"');
    this.run = null;
    this.solver = this.worker(text => {
      if (isGreeting(text)) return;
      this.heard(text);
      if (/^{"type":"(solved|failed)"/.test(text)) this.run = null;
    }, () => {
      const {run} = this;
      this.forget();
      this.startSolver();
      if (run !== null) this.hear({type: 'failed', id: run, error: {words: BROKEN}});
    });
  }

  // Of several problems that wait to be looked at only the last is.
  ofDesk(text) {
    if (text.startsWith('{"type":"checked"')) {
      this.asked = this.latest;
      this.latest = null;
      if (this.asked) this.desk.postMessage(JSON.stringify(this.asked));
    }
    this.heard(text);
  }

  send(message) {
    if (!this.connected) return 0;
    if (message.type === 'check') {
      if (this.asked) this.latest = message;
      else { this.asked = message; this.desk.postMessage(JSON.stringify(message)); }
    } else if (message.type === 'stop') this.stop();
    else if (OF_SOLVER.includes(message.type)) {
      if (message.type === 'solve') { this.stop(true); this.run = message.id; }
      this.solver.postMessage(JSON.stringify(message));
    } else this.desk.postMessage(JSON.stringify(message));
    return message.id ?? 1;
  }

  // Ends the run; what it has told is what is left of it.
  stop(isSilent = false) {
    const {run} = this;
    if (run === null) return;
    this.solver.terminate();
    this.startSolver();
    if (!isSilent) this.hear({type: 'stopped', id: run});
  }
}
