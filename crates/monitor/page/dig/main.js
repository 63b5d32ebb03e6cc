// Holds all parts together: what comes from the session, what is shown, what the hand does.
import {skeleton} from './arm.js';
import {Curve} from './curve.js';
import {Hand} from './hand.js';
import {dragIn, keysOn} from './input.js';
import {Link, keep, kept, takeToken} from './link.js';
import {Map as Above} from './map.js';
import {Pad} from './pad.js';
import {Section} from './section.js';
import {Sense} from './sense.js';
import {Soil} from './soil.js';
import {Speaker, faultWords, forceWords, heldWords, number} from './words.js';
import {Entrance} from './xr/enter.js';

const SLOW_PACE = .9, PACE_MS = 3000, STALE_MS = 1500, AIR_M = .02, REFUSAL_MS = 6000;
// Where the plate is brought from high up, and how long it takes to tare the force.
const HIGH_M = .2, START = {radius: .43, base: 0, z: .05, tool: 90}, BIAS_MS = 400;
const BODIES = [[9.80665, 'Earth'], [3.71, 'Mars'], [1.62, 'Moon']];
const get = id => document.getElementById(id);
const page = {state: null, scene: null, soil: null, hello: null, authorized: false, paces: []};

const link = page.link = new Link(message => hear[message.type]?.(message), reason => {
  page.authorized = false;
  showLink('lost', 'connection lost');
  banner(`Connection lost, trying again …${reason ? ` (${reason})` : ''} The arm stops by itself.`);
});
const hand = page.hand = new Hand(link, ready, take, answer => tell(answer.message, 'bad'));
const pad = page.pad = new Pad(hand, name => { get('pad').textContent = name ? `Gamepad: ${name}` : ''; });
const sense = page.sense = new Sense(pad, (strong, weak) => page.visit?.shake(strong, weak)), speaker = new Speaker(get('say'));
const section = page.section = new Section(get('section')), above = page.above = new Above(get('map')), curve = page.curve = new Curve(get('curve'));

function showLink(state, words) { get('link').dataset.state = state; get('link').textContent = words; }
function banner(words, tone = 'bad') {
  if (get('banner').textContent === (words ?? '') && get('banner').hidden === !words) return;
  Object.assign(get('banner'), {hidden: !words, textContent: words ?? ''}).dataset.tone = tone;
}
function tell(words, tone = '') {
  get('told').textContent = words;
  get('told').dataset.tone = tone;
  page.toldAt = performance.now();
}

// Whether the plate can be led now.
function ready() { return page.authorized && page.hello?.simulated && page.hello.real_time && page.state?.mode === 'ready' && page.state.homed; }

// Switches the arm on, after whatever went wrong, and tares its force in free air.
function take() {
  if (!page.authorized || page.taking || !page.state) return;
  page.taking = true;
  const steps = [];
  if (page.state.mode === 'fault') steps.push({name: 'release_stop'}, {name: 'reset'});
  if (page.state.mode !== 'ready') steps.push({name: 'enable'});
  if (page.state.plate?.z_m > page.scene.sandbox.surface_z_m + AIR_M) steps.push({name: 'bias'});
  const next = () => {
    const step = steps.shift();
    if (!step) {
      page.taking = false;
      tell('The plate is yours: drag it.');
      // From where it is parked, to above the soil.
      if (page.state.plate?.z_m > page.scene.sandbox.surface_z_m + HIGH_M) setTimeout(() => hand.bring({...START, z: page.scene.sandbox.surface_z_m + START.z}), BIAS_MS);
      return;
    }
    link.command(step, answer => {
      if (answer.type === 'ack') return next();
      page.taking = false;
      tell(answer.message, 'bad');
    });
  };
  next();
}

const hear = {
  hello(message) {
    page.hello = message;
    curve.clear();
    page.paces = [];
    page.taking = false;
    hand.letGo();
    showLink('live', message.real_time ? 'live' : 'live, not by the clock');
  },
  scene(message) {
    page.scene = message;
    page.soil = new Soil(message.sandbox);
    hand.limit(message.hand);
    get('source').textContent = message.soil;
    document.title = `${message.soil} – soilctl dig`;
    const {speed_m_s, force_n, lease_s} = message.hand;
    get('limits').textContent = `The edge follows with at most ${1000 * speed_m_s} mm/s and pushes with at most ${force_n} N. It stops ${lease_s} s after the last word of the hand, and 0.1 s to brake: also where the connection is lost. These are seconds of the session.`;
    redraw();
  },
  soil(message) { page.soil?.patch(message); page.visit?.patch(message); redraw(); },
  dig(message) { showDig(message); },
  state(message) { page.state = message; seen(message); },
  authorized() { page.authorized = true; get('stop').hidden = false; showGrip(); },
  link(message) {
    if (message.connected) { banner(null); return; }
    showLink('lost', 'session lost');
    banner(page.changing ? 'Fresh soil is being prepared …' : `The session is gone, waiting for it … (${message.message})`, page.changing ? 'warn' : 'bad');
  },
  error(message) {
    if (message.problem === 'forbidden') page.authorized = false;
    if (message.id === null) tell(message.message, 'bad');
  },
};

function seen(state) {
  hand.seen(state);
  const force = Math.hypot(...state.force_rtz_n), {plate} = state, surface = plate && page.soil?.at(plate.x_m, plate.y_m);
  const depth = depthOf(plate) ?? 0;
  const other = state.led && state.led.hand !== hand.number, limit = state.led && !other ? state.led.limit : 'none';
  curve.add(state.time_s, force);
  sense.feel(force, force / (page.scene?.hand.force_n ?? 1));
  get('force').firstElementChild.textContent = force.toFixed(1);
  get('load').value = Math.min(1, loadOf(state));
  const held = other ? 'Another hand leads the plate' : heldWords(limit);
  if (get('held').textContent !== held) get('held').textContent = held;
  get('held').dataset.limit = other ? 'other' : limit;
  const [r, t, z] = state.force_rtz_n;
  rows([['outwards', number(r, 1, 'N')], ['sideways', number(t, 1, 'N')], ['upwards', number(z, 1, 'N')], ['depth', plate ? number(1000 * Math.max(0, depth), 0, 'mm') : '–'],
    ['from the base', plate ? number(1000 * Math.hypot(plate.x_m, plate.y_m), 0, 'mm') : '–'], ['tool angle', plate ? number(plate.tool_angle_deg, 0, '°') : '–'],
    ['surface here', surface ? number(1000 * (surface - page.scene.sandbox.surface_z_m), 1, 'mm') : '–'], ['time', number(state.time_s, 1, 's')]]);
  if (plate && document.activeElement !== get('tool')) { get('tool').value = plate.tool_angle_deg; get('tool-out').textContent = `${Math.round(plate.tool_angle_deg)}°`; }
  speaker.say(forceWords(state, depth, limit), limit);
  keepPace(state);
  showGrip();
  redraw();
}

// The level that the plate went into is not that of its own furrow.
function depthOf(plate) { return plate && page.scene ? page.scene.sandbox.surface_z_m - plate.z_m : null; }
function loadOf(state) { return state.led ? state.led.load : Math.hypot(...state.force_rtz_n) / (page.scene?.hand.force_n ?? 1); }

// What a board in the headset says: the page's own words.
function boardWords() {
  const {state} = page, refusal = get('told').dataset.tone === 'bad' && performance.now() - page.toldAt < REFUSAL_MS ? get('told').textContent : '';
  return {
    force_n: state ? Math.hypot(...state.force_rtz_n) : null, load: state ? loadOf(state) : 0, depth_m: depthOf(state?.plate), tool_deg: state?.plate?.tool_angle_deg,
    held: get('held').textContent, warning: get('banner').hidden ? refusal : get('banner').textContent, soil: page.scene?.soil ?? '',
  };
}

// Where the hand of somebody else is.
function othersTarget() {
  const led = page.state?.led;
  return led && led.hand !== hand.number ? {radius: Math.hypot(led.x_m, led.y_m), base: Math.atan2(led.y_m, led.x_m), z: led.z_m} : null;
}

function rows(list) {
  const place = get('readout');
  if (place.childElementCount !== 2 * list.length) place.replaceChildren(...list.flatMap(([name]) => [Object.assign(document.createElement('dt'), {textContent: name}), document.createElement('dd')]));
  list.forEach(([, value], k) => { place.children[2 * k + 1].textContent = value; });
}

// Whether the session keeps up with the clock, over the last seconds.
function keepPace(state) {
  const now = performance.now();
  page.paces.push([now, state.time_s]);
  while (page.paces.length > 2 && now - page.paces[0][0] > PACE_MS) page.paces.shift();
  const [from, time_s] = page.paces[0], passed = (now - from) / 1000;
  page.pace = passed > 2 ? (state.time_s - time_s) / passed : 1;
}

function showGrip() {
  const {state} = page, fault = state?.mode === 'fault';
  get('take').disabled = !page.authorized || state?.mode === 'ready';
  get('take').textContent = fault ? 'Reset and take the plate' : state?.mode === 'ready' ? 'The arm is on' : 'Take the plate';
  get('hold').disabled = get('tool').disabled = !page.authorized;
  get('hold').setAttribute('aria-pressed', hand.held);
  document.body.dataset.grips = hand.grips() ? 'yes' : 'no';
  warn(state, fault);
}

// The most important of what is wrong.
function warn(state, fault) {
  const silent = performance.now() - link.last;
  if (!link.connected || get('link').dataset.state === 'lost') return;
  if (page.problem) banner(page.problem);
  else if (page.hello && !page.hello.real_time) banner('This session does not keep to the clock; dig in one with --real-time, or in soilctl dig.', 'warn');
  else if (page.hello && !page.hello.simulated) banner('This session drives a real arm. The plate of a simulated one can be dragged here.', 'warn');
  else if (fault && state.fault) banner(`The arm is off: ${faultWords(state.fault)}`);
  else if (silent > STALE_MS) banner(`No news of the session for ${(silent / 1000).toFixed(0)} s`, 'warn');
  else if (page.pace < SLOW_PACE) banner(`This machine is too slow for the session: ${(100 * Math.max(0, page.pace)).toFixed(0)} % of real time, ${state.behind_s.toFixed(1)} s behind since it began.`, 'warn');
  else if (!page.authorized && !takeToken()) banner('Watching only: open the address that the program printed to dig.', 'warn');
  else banner(null);
}

function showDig(message) {
  page.dig = message;
  page.problem = message.problem;
  page.changing = false;
  get('choose').hidden = false;
  const groups = new Map();
  for (const soil of message.soils) {
    const body = BODIES.find(([gravity]) => Math.abs(gravity - soil.gravity_m_s2) < .01)?.[1] ?? 'elsewhere', label = `${body}, ${soil.gravity_m_s2.toFixed(2)} m/s²`;
    if (!groups.has(label)) groups.set(label, Object.assign(document.createElement('optgroup'), {label}));
    groups.get(label).append(new Option(soil.title, soil.name, false, soil.name === message.soil));
  }
  get('soil').replaceChildren(...groups.values());
  const here = message.soils.find(soil => soil.name === message.soil);
  get('soil-words').textContent = here ? `${here.title}, under ${here.gravity_m_s2.toFixed(2)} m/s²` : '';
  get('log').textContent = message.log ? `being written: ${message.log}` : 'no session runs';
  get('dug').replaceChildren(...message.dug.map(({soil, log, steps, problems}) => Object.assign(document.createElement('li'), {textContent: `${log}: ${soil}, ${(steps / 500).toFixed(1)} s${problems.length ? `; ${problems.join('; ')}` : ''}`})));
}

function freshSoil(name) {
  page.changing = true;
  hand.letGo();
  tell('Fresh soil; the log so far is closed.');
  link.choose(name, answer => { page.changing = false; tell(answer.message ?? '', 'bad'); });
}

function redraw() {
  if (page.waiting) return;
  page.waiting = true;
  requestAnimationFrame(() => {
    page.waiting = false;
    const {scene, state, soil} = page;
    const shown = {scene, state, soil, target: hand.target ?? othersTarget(), grips: hand.grips(), dragged: hand.dragged, skeleton: scene && state?.plate ? skeleton(scene.arm, state.joints_deg, scene.tip_link, state.plate) : null};
    section.draw(shown);
    above.draw(shown);
    curve.draw(scene?.hand.force_n ?? 20);
    get('section').dataset.tick = state?.tick ?? '';
  });
}

function isDark() {
  const {theme: kind} = document.documentElement.dataset;
  return kind ? kind === 'dark' : matchMedia('(prefers-color-scheme: dark)').matches;
}

function theme(turned) {
  const root = document.documentElement, kind = kept('local', 'theme');
  if (!turned) { if (['light', 'dark'].includes(kind)) root.dataset.theme = kind; return; }
  keep('local', 'theme', root.dataset.theme = isDark() ? 'light' : 'dark');
  redraw();
}

function toggle(id, set) {
  const on = get(id).getAttribute('aria-pressed') !== 'true';
  get(id).setAttribute('aria-pressed', on);
  set(on);
}

function start() {
  const stage = get('stage'), plate = () => page.state?.plate;
  dragIn(get('section'), section, hand, stage, plate);
  dragIn(get('map'), above, hand, stage, plate);
  const acts = {
    h: () => { hand.hold(!hand.held); showGrip(); }, m: () => toggle('sound', on => sense.sound(on)),
    v: () => toggle('shake', on => { sense.shakes = on; }), t: () => theme(true), '?': () => get('help').showModal(),
  };
  keysOn(stage, hand, key => { acts[key]?.(); return Boolean(acts[key]); });
  for (const [id, key] of [['hold', 'h'], ['sound', 'm'], ['shake', 'v'], ['theme', 't'], ['help-open', '?']]) get(id).addEventListener('click', acts[key]);
  get('take').addEventListener('click', () => { take(); stage.focus({preventScroll: true}); });
  get('stop').addEventListener('click', () => link.command({name: 'emergency_stop'}, answer => tell(answer.message ?? 'Emergency stop.', 'bad')));
  get('tool').addEventListener('input', event => { hand.tilt(Number(event.target.value)); get('tool-out').textContent = `${event.target.value}°`; });
  get('soil').addEventListener('change', event => freshSoil(event.target.value));
  get('fresh').addEventListener('click', () => freshSoil(get('soil').value));
  get('shake').hidden = !navigator.vibrate && !navigator.getGamepads;
  // Also while something else has the focus.
  addEventListener('keydown', event => {
    if (event.key === 'Escape') { hand.letGo(); showGrip(); }
    if (event.key !== '.' || !(event.ctrlKey || event.metaKey) || get('stop').hidden) return;
    if (!event.repeat) get('stop').click();
    event.preventDefault();
  });
  matchMedia('(prefers-color-scheme: dark)').addEventListener('change', redraw);
  new ResizeObserver(redraw).observe(stage);
  setInterval(showGrip, 300);
  page.entrance = new Entrance(page, get, {
    tell, says: boardWords, others: othersTarget, dark: isDark,
    refused: () => tell('The plate cannot be led from here.', 'bad'), stop: () => { if (!get('stop').hidden) get('stop').click(); },
  });
  theme(false);
  stage.focus({preventScroll: true});
}
// For tests and the curious.
window.dig = page;
start();
