// What is told in words: readout, legend, events, commands.
const MOST_EVENTS = 400, MOST_JOINTS = 12, TICK_S = .002, PATIENCE_MS = 5000;
// The number behind an event, by the beginning of its kind: factor, digits, unit.
const EVENT_NUMBERS = {trajectory_ended: [TICK_S, 2, 's'], bias_taken: [1, 2, 'N'], surface_found: [1000, 1, 'mm'], wall_found: [1000, 1, 'mm'],
  inserted: [1000, 1, 'mm'], stroke_ended: [1, 2, 'N'], lift: [1, 2, '°'], rise: [1000, 2, 'mm'], friction_found: [1, 1, '°']};
class Panel {
  constructor(seek) {
    this.seek = seek;
    const get = id => document.getElementById(id);
    Object.assign(this, {readout: get('readout'), legend: get('legend'), events: get('events').querySelector('ol'), lost: get('lost')});
    this.entries = [];
    this.rows = {};
  }
  show(state, live) {
    const number = (value, digits, unit) => value === null || value === undefined ? '–' : `${value.toFixed(digits)} ${unit}`;
    const step = state.sequence ? `${state.sequence.replaceAll('_', ' ')} ${state.sequence_step}` : '–';
    this.row('Time', `${state.time_s.toFixed(2)} s${state.paused ? ', waits' : ''}`);
    this.row('Mode', state.mode + (state.waiting ? ', waits for soil' : ''), state.mode === 'fault' ? 'bad' : '');
    this.row('Sequence', step);
    this.row('Motion', state.trajectory?.replaceAll('_', ' ') ?? '–');
    this.row('Plate', state.plate ? `${number(Math.hypot(state.plate.x_m, state.plate.y_m) * 1000, 0, 'mm')}, ${number(state.plate.tool_angle_deg, 1, '°')}` : 'not homed');
    if (state.fault) this.row('Fault', faultWords(state.fault), 'bad');
    else this.row('Fault', null);
    this.mark('force', number(Math.hypot(...state.force_rtz_n), 1, 'N'));
    this.mark('lead', number(state.lead_m === null ? null : state.lead_m * 1000, 1, 'mm'));
    this.mark('safe', state.safe_force_n === null ? '' : number(state.safe_force_n, 1, 'N'));
    const lost = live ? Object.entries(state.dropped).filter(([, count]) => count).map(([what, count]) => `${count} ${what.replace('log_', '')}`) : [];
    this.lost.textContent = lost.length ? `lost: ${lost.join(', ')}` : '';
  }
  // Of a log of another program.
  showPose(pose, names, joints) {
    this.row('Time', `${pose.time_s.toFixed(2)} s`);
    this.row('End-point', pose.tip_m ? `${pose.tip_m.map(part => (part * 1000).toFixed(0)).join(', ')} mm` : '–');
    names.slice(0, MOST_JOINTS).forEach((name, k) => {
      const at = pose.positions[k], {factor, unit} = joints[k];
      this.row(`${k + 1} ${name}`, at === null || at === undefined ? '–' : `${(at * factor).toFixed(1)} ${unit}`, '', jointLook(k)[0]);
    });
    this.mark('force', pose.force_n ? `${Math.hypot(...pose.force_n).toFixed(1)} N` : '–');
  }
  row(name, words, tone = '', colour = '') {
    if (words === null) { this.rows[name]?.forEach(node => { node.hidden = true; }); return; }
    if (!this.rows[name]) {
      this.rows[name] = ['dt', 'dd'].map(tag => this.readout.appendChild(document.createElement(tag)));
      this.rows[name][0].textContent = name;
      if (colour) this.rows[name][0].style.color = `var(--${colour})`;
    }
    this.rows[name].forEach(node => { node.hidden = false; });
    const cell = this.rows[name][1];
    if (cell.textContent !== words) cell.textContent = words;
    cell.dataset.tone = tone;
  }
  mark(key, words) { this.legend.querySelector(`[data-key=${key}] b`).textContent = words; }
  clearEvents() { this.entries = []; this.events.replaceChildren(); this.current = null; }
  // Events of a whole log; a click goes to their time.
  setEvents(events) {
    this.clearEvents();
    this.events.append(...events.map(event => this.entry(event, true)));
  }
  addEvent(event) {
    const end = this.events.scrollHeight - this.events.scrollTop - this.events.clientHeight < 40;
    this.events.append(this.entry(event, false));
    if (this.entries.length > MOST_EVENTS) this.entries.shift().node.remove();
    if (end) this.events.scrollTop = this.events.scrollHeight;
  }
  entry(event, seekable) {
    const node = document.createElement('li'), part = (tag, words) => { const cell = node.appendChild(document.createElement(tag)); cell.textContent = words; return cell; };
    part('time', event.time_s.toFixed(2));
    part('span', event.kind.replaceAll('_', ' ').replaceAll('/', ' · ') + (event.index ? ` ${event.index}` : '')).className = /^(fault|sequence_failed)/.test(event.kind) ? 'fault' : '';
    const [factor, digits, unit] = EVENT_NUMBERS[event.kind.split('/')[0]] ?? [];
    const number = event.value && !(event.kind.startsWith('fault') && !event.limit);
    part('b', unit ? `${(event.value * factor).toFixed(digits)} ${unit}` : number ? Number(event.value.toPrecision(4)) : '');
    if (seekable) { node.dataset.seek = event.time_s; node.addEventListener('click', () => this.seek(event.time_s)); }
    this.entries.push({time_s: event.time_s, node});
    return node;
  }
  // The event before or after the one that is marked.
  key(key) {
    if (key !== 'ArrowUp' && key !== 'ArrowDown') return false;
    const now = this.entries[this.current]?.time_s ?? -1, {time_s, node} = (key === 'ArrowDown'
      ? this.entries.find(entry => entry.time_s > now + 1e-6) : this.entries.findLast(entry => entry.time_s < now - 1e-6)) ?? {};
    if (node?.dataset.seek) this.seek(time_s);
    return true;
  }
  // Marks the last event before a time of a log.
  at(time_s) {
    let place = this.entries.findLastIndex(entry => entry.time_s <= time_s + 1e-6);
    if (place === this.current) return;
    this.current = place;
    this.entries.forEach(({node}, k) => { node.classList.toggle('later', k > place); k === place ? node.setAttribute('aria-current', 'time') : node.removeAttribute('aria-current'); });
    const node = this.entries[place]?.node;
    if (node) this.events.scrollTop = node.offsetTop - this.events.offsetTop - this.events.clientHeight / 2;
  }
}

// Faults that are a yes or no have no limit.
function faultWords({kind, value, limit}) {
  return kind.replaceAll('_', ' ') + (limit ? `: ${value?.toPrecision(4)} over ${limit.toPrecision(4)}` : '');
}

class Commands {
  constructor(send) {
    this.send = send;
    this.id = 0;
    const get = id => document.getElementById(id);
    Object.assign(this, {root: get('commands'), locked: get('locked'), answer: get('answer'), words: get('words'), stop: get('stop')});
    get('line').addEventListener('submit', event => { event.preventDefault(); this.line(get('text').value.trim()); get('text').value = ''; });
    get('quick').addEventListener('click', event => event.target.dataset.line && this.line(event.target.dataset.line));
    this.stop.addEventListener('click', () => this.line('emergency_stop'));
  }
  // The commands and the stop, which is always in sight, or why they are not there.
  open(allowed, locked) { [this.root.hidden, this.stop.hidden, this.locked.hidden] = [!allowed, !allowed, !locked]; }
  allow(words) {
    this.open(true, false);
    this.words.replaceChildren(...words.map(([word, help]) => new Option(help, word)));
  }
  lock() { this.open(false, true); }
  forget() {
    this.open(false, false);
    this.asked = null;
  }
  // An emergency stop that nobody answers must not look like one that is done.
  check() {
    if (!this.asked || performance.now() - this.asked < PATIENCE_MS) return;
    this.asked = null;
    this.say(`${this.last}: no answer for ${PATIENCE_MS / 1000} s; whether it is done is not known yet`, 'bad');
  }
  line(text) {
    if (!text) return;
    this.id += 1;
    [this.last, this.asked] = [text, performance.now()];
    this.say(`${text} …`);
    this.send({type: 'line', id: this.id, text});
  }
  answered(message) {
    if (message.id === this.id) this.asked = null;
    if (message.type === 'ack' && message.id === this.id) this.say(`${this.last}: done in tick ${message.tick}`);
    if (message.problem === 'forbidden') this.lock();
    if (message.type === 'error' && !this.root.hidden) this.say(message.message, 'bad');
  }
  say(words, tone = '') { this.answer.textContent = words; this.answer.dataset.tone = tone; }
}
