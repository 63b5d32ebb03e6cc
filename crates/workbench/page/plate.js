// The plate's bench: what holds its parts together.
import {Asker} from './asker.js';
import {get, say} from './dom.js';
import {Inside} from './inside.js';
import {keep, kept} from './keep.js';
import {Link} from './link.js';
import {borne} from './plate_borne.js';
import {bracketWords, forces} from './plate_forces.js';
import {lines, section, swatch} from './plate_section.js';
import {Sliders} from './sliders.js';
import {Strokes} from './strokes.js';
import {keptTheme, turnTheme} from './theme.js';

const REST_MS = 350;
const FIRST = {alpha_deg: 80, beta_deg: 0, depth_m: .05, width_m: .127, phi_deg: 40, delta_deg: 20, density_kg_m3: 1450, cohesion_pa: 0, adhesion_pa: 0, surcharge_pa: 0, gravity_m_s2: 9.80665};
const one = (key, name, unit, scale, low, high, step) => ({key, name, unit, scale, low, high, step});
const MAIN = [one('alpha_deg', 'Tool angle α', '°', 1, 20, 140, 1), one('depth_m', 'Depth', 'mm', 1000, 5, 300, 1), one('width_m', 'Width', 'mm', 1000, 10, 1000, 1), one('phi_deg', 'Friction φ', '°', 1, 20, 55, .5), one('delta_deg', 'On the plate δ', '°', 1, 0, 50, .5), one('density_kg_m3', 'Density ρ', 'kg/m³', 1, 600, 2400, 10)];
const FURTHER = [one('beta_deg', 'Slope β', '°', 1, -35, 35, 1), one('cohesion_pa', 'Cohesion', 'kPa', .001, 0, 10, .05), one('adhesion_pa', 'Adhesion', 'kPa', .001, 0, 10, .05), one('surcharge_pa', 'Surcharge', 'kPa', .001, 0, 10, .05), one('gravity_m_s2', 'Gravity', 'm/s²', 1, .5, 12, .01)];

const values = {...FIRST, ...keptValues()};
const state = {shown: null, answered: 0, asked: 0, greeted: false, wrong: null};
const link = new (document.documentElement.dataset.solver === 'inside' ? Inside : Link)(hear, reason => connection('lost', reason ? `lost: ${reason}` : 'no connection'), {wantsFile: false});
const asker = new Asker(link, 'plate', told);
const main = new Sliders(values, MAIN, changed), further = new Sliders(values, FURTHER, changed);
const strokes = new Strokes(link, {soil: () => values, takeSoil, attempt});
let rest = 0;

function keptValues() {
  try {
    const found = JSON.parse(kept('local', 'plate')) ?? {};
    return Object.fromEntries(Object.entries(found).filter(([key, value]) => key in FIRST && Number.isFinite(value)));
  } catch { return {}; }
}

function connection(now, words) { Object.assign(get('link').dataset, {state: now}); get('link').textContent = words; }

function hear(message) {
  if (message.type !== 'hello') return;
  connection('ready', document.documentElement.dataset.solver === 'inside' ? 'computes in this browser' : 'connected');
  state.example = message.strokes;
  state.greeted = true;
  changed();
  if (state.models) strokes.hello(state.example, state.models);
}

function changed() {
  keep('local', 'plate', JSON.stringify(values));
  state.asked++;
  clearTimeout(rest);
  asker.ask({...values, slow: false});
  // Models that search are asked when the sliders rest.
  rest = setTimeout(() => asker.ask({...values, slow: true}), REST_MS);
  strokes.bands.draw();
}

function told(answer, question) {
  if (!answer) return;
  const isNow = Object.keys(values).every(key => values[key] === question[key]);
  state.answered++;
  if (answer.error) {
    if (isNow && state.wrong !== answer.error.words) { state.wrong = answer.error.words; say(state.wrong); draw(); }
    return;
  }
  Object.assign(state, {shown: answer.shown, of: question, wrong: null});
  draw();
  if (question.slow && isNow) say(get('bracket').textContent);
  if (!state.models) {
    state.models = [...new Set(answer.shown.models.map(model => model.id))];
    strokes.hello(state.example, state.models);
  }
}

function draw() {
  const {shown, of} = state;
  if (!shown) return;
  const all = lines(shown.models);
  section(of, shown, all);
  borne(of, shown);
  forces(shown.models, model => swatch(all, model));
  // What was before is pale while something is wrong.
  get('plate').classList.toggle('stale', Boolean(state.wrong));
  get('bracket').textContent = state.wrong ?? bracketWords(shown.models);
}

function put(some) {
  Object.assign(values, some);
  main.show();
  further.show();
  changed();
}

const rounded = (value, digits) => Number(value.toPrecision(digits));
function takeSoil({phi_deg, density_kg_m3, delta_deg}) { put({phi_deg: rounded(phi_deg, 4), density_kg_m3: rounded(density_kg_m3, 4), delta_deg: rounded(delta_deg, 4)}); }
// Shows a stroke that might be made in the soil that the strokes tell.
function attempt({alpha_deg, depth_m, width_m}, soil) {
  if (soil) takeSoil(soil);
  put({alpha_deg, depth_m, width_m});
  get('plate').scrollIntoView({behavior: matchMedia('(prefers-reduced-motion: reduce)').matches ? 'auto' : 'smooth'});
}

get('sliders').append(...main.rows);
get('further-sliders').append(...further.rows);
get('as-at-first').addEventListener('click', () => put(FIRST));
get('theme').addEventListener('click', turnTheme);
get('further').open = FURTHER.some(({key}) => values[key] !== FIRST[key]);
new ResizeObserver(() => { draw(); strokes.draw(); }).observe(document.querySelector('main'));
keptTheme();
main.show();
further.show();
if (!strokes.table.csv.trim()) strokes.nothing();

// For whoever looks at the page from outside.
window.bench = {values, state, asker, link, strokes, put};
