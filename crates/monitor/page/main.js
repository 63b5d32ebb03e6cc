// The connection, and what holds all parts together.
const page = {};
// A monitor says something every five seconds, a session every 33 ms.
const STALE_MS = 3500, LIFELESS_MS = 15000, MOST_WAIT_MS = 4000, SHIFT_PX = 30;
// Pictures in a second that are no movement: a change, and the same once more in full.
const RESTING = 2;
const get = id => document.getElementById(id);

class Link {
  constructor(hear, lost) { Object.assign(this, {hear, lost, wait: 250, last: performance.now()}); this.open(); }
  open() {
    const socket = this.socket = new WebSocket(`${location.protocol === 'https:' ? 'wss' : 'ws'}://${location.host}/socket`);
    this.last = performance.now();
    socket.onmessage = event => {
      this.last = performance.now();
      this.wait = 250;
      this.hear(JSON.parse(event.data));
    };
    socket.onopen = () => { this.connected = true; this.authorize(); };
    socket.onclose = event => this.again(event.reason);
  }
  again(reason) {
    this.connected = false;
    this.lost(reason);
    setTimeout(() => this.open(), this.wait);
    this.wait = Math.min(MOST_WAIT_MS, this.wait * 2);
  }
  authorize() { const token = takeToken(); if (token) this.send({type: 'authorize', token}); }
  // A connection that only looks like one says nothing, not even that it is closed.
  check() {
    if (!this.connected || performance.now() - this.last < LIFELESS_MS) return;
    Object.assign(this.socket, {onmessage: null, onclose: null}).close();
    this.again('the monitor is silent');
  }
  send(message) { if (this.socket.readyState === WebSocket.OPEN) this.socket.send(JSON.stringify(message)); }
}

// From the address, out of which it goes so that nobody reads it there; a reload still has it.
function takeToken() {
  const given = new URLSearchParams(location.hash.slice(1)).get('token');
  if (given) {
    page.token = given;
    keep('session', 'token', given);
    history.replaceState(null, '', location.pathname);
  }
  return page.token ?? kept('session', 'token');
}

// What the browser keeps for a page: `local` for all of them, `session` for this tab. Where that is blocked, nothing is kept.
function keep(where, name, value) { try { window[`${where}Storage`].setItem(name, value); } catch { /* then not */ } }
function kept(where, name) { try { return window[`${where}Storage`].getItem(name); } catch { return null; } }

// The place in a log that a reload is to find again. Whoever comes by the address begins where the monitor says.
function keepPlace() {
  if (page.player.log && page.player.state) keep('session', 'place', JSON.stringify({name: document.title, ...page.player.state}));
}
function keptPlace() {
  if (performance.getEntriesByType('navigation')[0]?.type !== 'reload') return null;
  const place = JSON.parse(kept('session', 'place'));
  return place?.name === document.title ? place : null;
}

function showLink(state, words) { Object.assign(get('link').dataset, {state}); get('link').textContent = words; }
function banner(words) { get('banner').hidden = !words; get('banner').textContent = words ?? ''; }

const hear = {
  hello(message) {
    page.hello = message;
    page.charts.clear();
    page.panel.clearEvents();
    page.legend.hidden = !message.safe_force.angle_deg.length;
    banner(null);
  },
  scene(message) {
    page.live = message.live;
    page.words = message.words;
    page.charts.level_m = message.ground_z_m;
    page.scene.describe(message);
    const own = Boolean(message.sandbox), kinds = new Map(page.scene.arm.joints.map(joint => [joint.name, joint]));
    page.names = message.joints;
    page.joints = message.joints.map(name => kinds.get(name)?.slides ? {factor: 1000, unit: 'mm'} : {factor: 180 / Math.PI, unit: '°'});
    const shown = own ? ['force', 'friction', 'z', 'displacement', 'machine'] : [...message.has_force ? ['force'] : [], 'z', 'joints'];
    page.charts.choose(shown, page.joints.map(joint => joint.factor));
    get('events').hidden = !own;
    if (message.commands && !takeToken()) page.commands.lock();
    const key = name => get('legend').querySelector(`[data-key=${name}]`);
    key('lead').hidden = !own;
    key('force').hidden = !message.has_force;
    key('force').childNodes[1].textContent = own ? 'soil on plate ' : 'force as read ';
    get('source').textContent = [message.name, message.soil].filter(Boolean).join(' · ');
    document.title = `${message.name} – soilctl monitor`;
    if (page.live) { page.player.open(null); showLink('live', page.hello.real_time ? 'live, real time' : 'live, as fast as possible'); }
  },
  log(message) {
    page.panel.setEvents(message.events);
    page.scene.scaleForces(Math.max(0, ...message.overview_n));
    page.player.open(message, keptPlace());
    showLink('log', message.damage.length ? 'log, damaged' : 'log');
    for (const [id, lines] of [['damage', message.damage], ['notes', message.notes ?? []]]) {
      get(id).hidden = !lines.length;
      get(id).querySelector('ul').replaceChildren(...lines.map(words => Object.assign(document.createElement('li'), {textContent: words})));
    }
  },
  history(message) { page.charts.add(message); },
  soil(message) { page.scene.patch(message); },
  state(message) {
    page.state = message;
    page.scene.update(message, page.hello?.safe_force);
    page.panel.show(message, page.live);
    if (page.live) page.charts.addState(message);
    noteHeard(message);
  },
  pose(message) {
    page.state = message;
    page.scene.update(message);
    page.panel.showPose(message, page.names, page.joints);
    noteHeard(message);
  },
  event(message) { page.panel.addEvent(message); },
  player(message) { page.player.show(message); get('player').dataset.timeS = message.time_s; },
  link(message) {
    page.sessionLost = !message.connected;
    if (message.connected) { banner(null); return; }
    showLink('lost', 'session lost');
    banner(`Session lost, reconnecting … (${message.message})`);
  },
  authorized() { page.commands.allow(page.words ?? []); },
  ack(message) { page.commands.answered(message); },
  error(message) { page.commands.answered(message); },
};

// When which state came, for whoever measures.
function noteHeard(message) {
  page.heard.push([message.tick, performance.timeOrigin + performance.now()]);
  if (page.heard.length > 4000) page.heard.splice(0, 2000);
}

function keys(event) {
  // Also while a command is typed.
  if (event.key === '.' && (event.ctrlKey || event.metaKey) && !get('stop').hidden) {
    if (!event.repeat) get('stop').click();
    event.preventDefault();
    return;
  }
  if (event.ctrlKey || event.metaKey || event.altKey || get('help').open) return;
  const typing = event.target.matches('input[list], select');
  if (typing) return;
  const key = event.key.length === 1 ? event.key.toLowerCase() : event.key;
  const inScene = event.target === get('scene'), step = {ArrowLeft: -1, ArrowDown: -1, ArrowRight: 1, ArrowUp: 1}[key], turns = {ArrowLeft: [-5, 0], ArrowRight: [5, 0], ArrowUp: [0, 4], ArrowDown: [0, -4]};
  const views = {1: 'home', 2: 'side', 3: 'top', 4: 'plate'};
  if (inScene && turns[key] && event.shiftKey) page.scene.shift(...turns[key].map(part => -Math.sign(part) * SHIFT_PX));
  else if (inScene && turns[key]) page.scene.turn(...turns[key]);
  else if (inScene && '+-'.includes(key)) page.scene.zoom(key === '+' ? .87 : 1.15);
  else if (event.target === get('scrub') && step) page.player.step(step);
  else if (event.target.closest?.('#events ol') && page.panel.key(key)) { /* done */ }
  else if (views[key]) page.scene.show(views[key]);
  else if (key === '?') get('help').showModal();
  else if (key === 'd') theme();
  else if (key === ' ' && event.target.matches('button')) return;
  else if (event.target === get('scrub') && ['Home', 'End'].includes(key)) return;
  else if (!page.player.key(key)) return;
  event.preventDefault();
}

function theme(wanted) {
  const dark = matchMedia('(prefers-color-scheme: dark)').matches, now = document.documentElement.dataset.theme ?? (dark ? 'dark' : 'light');
  if (wanted === undefined) keep('local', 'theme', document.documentElement.dataset.theme = now === 'dark' ? 'light' : 'dark');
  page.scene.look = document.documentElement.dataset.theme ?? (dark ? 'dark' : 'light');
  page.scene.redraw();
  page.charts.redraw();
  page.player.draw();
}

function pointers(canvas) {
  const held = new Map();
  canvas.addEventListener('pointerdown', event => { canvas.setPointerCapture(event.pointerId); held.set(event.pointerId, [event.clientX, event.clientY]); });
  for (const kind of ['pointerup', 'pointercancel']) canvas.addEventListener(kind, event => held.delete(event.pointerId));
  canvas.addEventListener('pointermove', event => {
    const before = held.get(event.pointerId);
    if (!before) return;
    const [dx, dy] = [event.clientX - before[0], event.clientY - before[1]], others = [...held].filter(([id]) => id !== event.pointerId);
    held.set(event.pointerId, [event.clientX, event.clientY]);
    if (others.length) {
      const [x, y] = others[0][1], gap = (u, v) => Math.hypot(u - x, v - y) || 1;
      page.scene.zoom(gap(...before) / gap(event.clientX, event.clientY));
      page.scene.shift(dx / 2, dy / 2);
    } else if (event.shiftKey || event.buttons === 4) page.scene.shift(dx, dy);
    else page.scene.turn(-dx * .4, dy * .4);
  });
  canvas.addEventListener('wheel', event => { event.preventDefault(); page.scene.zoom(Math.exp(event.deltaY * .0012)); }, {passive: false});
}

// How much of the view lies behind readout and legend, in px from above and from below.
function covered() {
  const {clientWidth, clientHeight} = get('view'), readout = get('readout'), legend = get('legend'), most = .3 * clientHeight;
  const above = readout.offsetWidth > clientWidth / 2 ? readout.offsetTop + readout.offsetHeight : 0;
  return [Math.min(above, most), Math.min(legend.offsetHeight && clientHeight - legend.offsetTop, most)];
}

function start() {
  const send = message => page.link.send(message);
  page.heard = [];
  page.scene = new Scene(get('scene'), ready => { get('no-webgl').hidden = ready; }, covered);
  page.player = new Player(send, time_s => page.panel.at(time_s));
  page.charts = new Charts(get('charts'), time_s => page.player.active && page.player.seek(time_s));
  page.panel = new Panel(time_s => page.player.seek(time_s));
  page.commands = new Commands(send);
  page.legend = get('legend').querySelector('[data-key=safe]');
  page.link = new Link(message => hear[message.type]?.(message), reason => {
    showLink('lost', 'stream lost');
    banner(`Stream lost, reconnecting …${reason ? ` (${reason})` : ''}`);
    page.commands.forget();
  });
  get('window').addEventListener('change', event => { page.charts.window_s = Number(event.target.value); page.charts.redraw(); });
  get('views').addEventListener('click', event => event.target.dataset.view && page.scene.show(event.target.dataset.view));
  get('theme').addEventListener('click', () => theme());
  get('help-open').addEventListener('click', () => get('help').showModal());
  matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => theme(null));
  document.addEventListener('keydown', keys);
  // The address that the monitor printed, opened where the page is open already, changes nothing but its end.
  addEventListener('hashchange', () => { takeToken(); if (page.link.connected) page.link.authorize(); });
  addEventListener('pagehide', keepPlace);
  new ResizeObserver(() => page.scene.redraw()).observe(get('view'));
  pointers(get('scene'));
  if (['light', 'dark'].includes(kept('local', 'theme'))) document.documentElement.dataset.theme = kept('local', 'theme');
  theme(null);
  setInterval(() => {
    const drawn = page.scene.drawn.filter(time => time > performance.now() - 1000).length;
    const moves = page.player.state?.playing ? drawn > 0 : drawn > RESTING;
    get('rate').textContent = page.scene.ready && moves ? `${drawn} frames/s` : '';
    page.link.check();
    page.commands.check();
    const silent = performance.now() - page.link.last;
    if (page.live && page.link.connected && !page.sessionLost) banner(silent > STALE_MS ? `No data for ${Math.round(silent / 1000)} s` : null);
  }, 500);
}
// For tests and the curious.
window.monitor = page;
start();
