// The connection to the server: messages there, messages back, again when it was lost.
import {keep, kept} from './keep.js';
import {Messages} from './messages.js';

const LIFELESS_MS = 15000, MOST_WAIT_MS = 4000;

// A message has at most 4 MiB, with all that JSON adds to a text.
export class Link extends Messages {
  // Who wants no file shows no token.
  constructor(hear, lost, {wantsFile = true} = {}) {
    super(hear, lost);
    Object.assign(this, {wantsFile, wait: 250, last: performance.now(), mostBytes: 3 << 20});
    this.open();
    setInterval(() => this.check(), 1000);
  }

  open() {
    const socket = this.socket = new WebSocket(`${location.protocol === 'https:' ? 'wss' : 'ws'}://${location.host}/socket`);
    this.last = performance.now();
    socket.onopen = () => {
      this.connected = true;
      const token = takeToken();
      if (token && this.wantsFile) this.send({type: 'authorize', token});
    };
    socket.onmessage = event => {
      this.last = performance.now();
      this.wait = 250;
      this.heard(event.data);
    };
    socket.onclose = event => this.again(event.reason);
  }

  again(reason) {
    this.connected = false;
    this.forget();
    this.lost(reason);
    setTimeout(() => this.open(), this.wait);
    this.wait = Math.min(MOST_WAIT_MS, this.wait * 2);
  }

  // A connection that only looks like one says nothing, not even that it is closed.
  check() {
    if (!this.connected || performance.now() - this.last < LIFELESS_MS) return;
    Object.assign(this.socket, {onmessage: null, onclose: null}).close();
    this.again('the workbench is silent');
  }

  // Returns the number of the message, or 0 if there is no connection.
  send(message) {
    if (this.socket.readyState !== WebSocket.OPEN) return 0;
    this.socket.send(JSON.stringify(message));
    return message.id ?? 1;
  }
}

// From the address, out of which it goes so that nobody reads it there; a reload still has it.
function takeToken() {
  const given = new URLSearchParams(location.hash.slice(1)).get('token');
  if (!given) return kept('session', 'token');
  keep('session', 'token', given);
  history.replaceState(null, '', location.pathname);
  return given;
}
