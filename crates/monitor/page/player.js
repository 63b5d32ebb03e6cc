// Playing a log: buttons, the track with its overview, and keys.
const SPEEDS = [.1, .25, .5, 1, 2, 5, 10, 20, 60];
class Player {
  constructor(send, moved) {
    Object.assign(this, {send, moved, id: 0});
    this.root = document.getElementById('player');
    const get = id => document.getElementById(id);
    Object.assign(this, {button: get('play'), scrub: get('scrub'), speed: get('speed'), time: get('time'), overview: get('overview')});
    for (const speed of SPEEDS) this.speed.add(new Option(`${speed} ×`, speed, speed === 1, speed === 1));
    this.button.addEventListener('click', () => this.toggle());
    get('back').addEventListener('click', () => this.step(-1));
    get('step').addEventListener('click', () => this.step(1));
    this.scrub.addEventListener('input', () => this.seek(Number(this.scrub.value)));
    this.speed.addEventListener('change', () => this.run(Number(this.speed.value)));
    new ResizeObserver(() => this.draw()).observe(this.overview);
  }
  get active() { return Boolean(this.log); }
  // A log, or null for a live session. After a lost connection the place is taken up again, and that of `kept` after a reload.
  open(log, kept) {
    const before = this.state ?? kept;
    [this.log, this.id] = [log, 0];
    if (this.state) this.state.id = 0;
    this.root.hidden = !log;
    if (!log) return;
    Object.assign(this.scrub, {min: log.from_s, max: log.to_s});
    this.draw();
    if (before) {
      this.seek(before.time_s);
      this.run(before.speed);
      if (before.playing) this.ask({type: 'play'}, {playing: true});
    }
  }
  // Asks the monitor, and shows at once what will come of it: the next key counts from there, however late the answer is.
  ask(request, change) {
    const {from_s, to_s} = this.log, state = {time_s: from_s, playing: false, speed: 1, ...this.state, ...change};
    this.id += 1;
    this.asked = performance.now();
    this.send({...request, id: this.id});
    this.set({...state, time_s: Math.min(to_s, Math.max(from_s, state.time_s))});
  }
  // Whether the monitor has said all that there is to what was asked. A request that was lost on the way is not waited for.
  get settled() { return (this.state?.id ?? 0) >= this.id || performance.now() - this.asked > PATIENCE_MS; }
  // What the monitor says; what it said before it heard the last request is out of date.
  show(state) {
    if (state.id >= this.id || this.settled) this.set(state);
  }
  set(state) {
    this.state = state;
    this.button.textContent = state.playing ? 'Pause' : 'Play';
    this.button.setAttribute('aria-pressed', state.playing);
    if (this.log) this.scrub.value = state.time_s;
    this.time.textContent = `${clock(state.time_s)} / ${clock(this.log?.to_s ?? 0)}`;
    this.scrub.setAttribute('aria-valuetext', `${state.time_s.toFixed(2)} s`);
    if (SPEEDS.includes(state.speed)) this.speed.value = state.speed;
    this.moved(state.time_s);
  }
  toggle() {
    const {playing, time_s} = this.state ?? {};
    if (playing) this.ask({type: 'pause'}, {playing: false});
    // From the end it begins anew.
    else this.ask({type: 'play'}, {playing: true, ...time_s >= this.log.to_s && {time_s: this.log.from_s}});
  }
  seek(time_s) { this.ask({type: 'seek', time_s}, {time_s}); }
  step(count) { this.ask({type: 'step', count}, {time_s: (this.state?.time_s ?? 0) + count * this.log.state_s, playing: false}); }
  run(speed) { this.ask({type: 'speed', speed}, {speed}); }
  faster(by) {
    const place = SPEEDS.findIndex(speed => speed >= (this.state?.speed ?? 1));
    this.run(SPEEDS[Math.min(SPEEDS.length - 1, Math.max(0, place + by))]);
  }
  key(key) {
    if (!this.log) return false;
    const now = this.state?.time_s ?? 0;
    const actions = {' ': () => this.toggle(), ',': () => this.step(-1), '.': () => this.step(1), j: () => this.seek(now - 5), l: () => this.seek(now + 5),
      Home: () => this.seek(this.log.from_s), End: () => this.seek(this.log.to_s), '+': () => this.faster(1), '-': () => this.faster(-1)};
    actions[key]?.();
    return key in actions;
  }
  draw() {
    const {log, overview} = this, ratio = devicePixelRatio || 1, width = overview.clientWidth, height = overview.clientHeight;
    if (!log || !width) return;
    [overview.width, overview.height] = [width * ratio, height * ratio];
    const pen = overview.getContext('2d'), style = getComputedStyle(document.documentElement), colour = name => style.getPropertyValue(`--${name}`).trim();
    pen.scale(ratio, ratio);
    const x = time => (time - log.from_s) / Math.max(1e-9, log.to_s - log.from_s) * width;
    pen.fillStyle = colour('grid');
    pen.fillRect(0, 0, width, height);
    pen.fillStyle = colour('second');
    pen.globalAlpha = .28;
    for (const {start_s, end_s} of log.strokes) pen.fillRect(x(start_s), 0, Math.max(2, x(end_s) - x(start_s)), height);
    pen.globalAlpha = .75;
    pen.fillStyle = colour('accent');
    const most = Math.max(1, ...log.overview_n), parts = log.overview_n.length;
    log.overview_n.forEach((force, k) => { const h = force / most * (height - 6); pen.fillRect(k / parts * width, height - h, width / parts + .5, h); });
    pen.globalAlpha = 1;
  }
}

function clock(seconds) {
  const minutes = Math.floor(seconds / 60);
  return `${minutes}:${(seconds - 60 * minutes).toFixed(2).padStart(5, '0')}`;
}
