// The connection to the monitor: messages there, messages back, again when it was lost.
const LIFELESS_MS = 15000, MOST_WAIT_MS = 4000;

export class Link {
  // `hear` takes messages, `lost` the reason why there are none.
  constructor(hear, lost) {
    Object.assign(this, {hear, lost, wait: 250, last: performance.now(), id: 0, asked: new Map()});
    this.open();
    setInterval(() => this.check(), 1000);
    // The address that the program printed, opened where the page is open already, changes nothing but its end.
    addEventListener('hashchange', () => this.authorize());
  }
  open() {
    const socket = this.socket = new WebSocket(`${location.protocol === 'https:' ? 'wss' : 'ws'}://${location.host}/socket`);
    this.last = performance.now();
    socket.onopen = () => { this.connected = true; this.authorize(); };
    socket.onmessage = event => {
      this.last = performance.now();
      this.wait = 250;
      const message = JSON.parse(event.data);
      if (message.type === 'ack' || message.type === 'error') this.answered(message);
      this.hear(message);
    };
    socket.onclose = event => this.again(event.reason);
  }
  again(reason) {
    this.connected = false;
    this.asked.clear();
    this.lost(reason);
    setTimeout(() => this.open(), this.wait);
    this.wait = Math.min(MOST_WAIT_MS, this.wait * 2);
  }
  // A connection that only looks like one says nothing, not even that it is closed.
  check() {
    if (!this.connected || performance.now() - this.last < LIFELESS_MS) return;
    Object.assign(this.socket, {onmessage: null, onclose: null}).close();
    this.again('the program is silent');
  }
  authorize() {
    const token = takeToken();
    if (token) this.send({type: 'authorize', token});
  }
  send(message) {
    if (this.socket.readyState !== WebSocket.OPEN) return false;
    this.socket.send(JSON.stringify(message));
    return true;
  }
  // A command; `done` gets its answer.
  command(command, done = () => {}) {
    this.id += 1;
    if (this.send({type: 'command', id: this.id, command})) this.asked.set(this.id, {done, at: performance.now()});
    return this.id;
  }
  // Which soil is dug next.
  choose(soil, done) {
    this.id += 1;
    if (this.send({type: 'choose_soil', id: this.id, soil})) this.asked.set(this.id, {done, at: performance.now()});
  }
  answered(message) {
    const asked = this.asked.get(message.id);
    this.asked.delete(message.id);
    asked?.done(message);
  }
  // For how long the oldest command has waited, in ms.
  waited() {
    const [oldest] = this.asked.values();
    return oldest ? performance.now() - oldest.at : 0;
  }
}

// From the address, out of which it goes so that nobody reads it there; a reload and the 3-D view still have it.
export function takeToken() {
  const given = new URLSearchParams(location.hash.slice(1)).get('token');
  if (given) {
    keep('session', 'token', given);
    history.replaceState(null, '', location.pathname);
  }
  return given ?? kept('session', 'token');
}

// What the browser keeps, as for the 3-D view; where that is blocked, nothing is kept.
export function keep(where, name, value) { try { window[`${where}Storage`].setItem(name, value); } catch { /* then not */ } }
export function kept(where, name) { try { return window[`${where}Storage`].getItem(name); } catch { return null; } }
