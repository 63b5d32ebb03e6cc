// What the page has fields for, by section of the problem file. Keys that are not here stay in the document as they are.

const optional = true;
const number = (key, label, unit, more = {}) => ({key, label, unit, kind: 'number', ...more});
const choice = (key, label, options, more = {}) => ({key, label, kind: 'choice', options, ...more});
const text = (key, label, more = {}) => ({key, label, kind: 'text', ...more});

const HELD = choice('held', 'Held', [['', 'moves'], ['fixed', 'fixed'], ['smooth', 'smooth']], {optional, help: 'every structure but the one whose force is bounded'});
const FACES = [number('delta_deg', 'Friction δ of faces', '°', {zero: true}), number('adhesion_kpa', 'Adhesion of faces', 'kPa', {zero: true})];
const ACTION = choice('action', 'Action', [['', 'not said'], ['permanent', 'permanent'], ['variable', 'variable'], ['favourable', 'favourable']], {optional, help: 'for the partial factors of cases'});

export const KINDS = [['fixed', 'fixed: no motion'], ['smooth', 'smooth: slides along'], ['symmetric', 'symmetric'], ['free', 'free'], ['far', 'far: goes on'], ['load', 'load']];
export const SIDES = ['left', 'right', 'bottom', 'top'];

export const SOIL = [
  text('name', 'Name'),
  number('phi_deg', 'φ', '°', {title: 'friction angle', only: of => !of.strength}),
  number('cohesion_kpa', 'c', 'kPa', {zero: true, title: 'cohesion', only: of => !of.strength}),
  number('unit_weight_kn_m3', 'γ', 'kN/m³', {title: 'unit weight, with the water in the pores'}),
];
export const SOIL_MORE = [
  number('cohesion_gradient_kpa_per_m', 'c grows by', 'kPa/m', {zero: true, only: of => !of.strength}),
  number('cohesion_level_m', 'below y', 'm', {optional, only: of => !of.strength}),
  number('strength_factor', 'Strength times', '', {optional, title: 'what the law of strength is multiplied by', only: of => of.strength}),
  number('dilation_deg', 'Dilation ψ', '°', {optional, title: 'less than the flow rule says: strength after Davis, an approximation', only: of => !of.strength}),
  number('tension_kpa', 'Tension at most', 'kPa', {optional}),
  number('pore_pressure_ratio', 'Pore pressure ratio', '', {zero: true}),
  number('permeability_m_per_s', 'Permeability', 'm/s', {optional, title: 'downwards, where water flows between heads'}),
  number('permeability_ratio', 'k along x over that', '', {optional, title: 'permeability along x over that downwards; 1 if not said'}),
];

export const ENTRY = {
  region: [text('name', 'Name', {optional}), {key: 'soil', label: 'Soil', kind: 'soil'}],
  boundary: [
    text('name', 'Name', {optional}),
    choice('kind', 'What holds', KINDS),
    {key: 'sides', label: 'On whole sides', kind: 'words', options: SIDES, only: of => !of.line?.length},
    {key: 'pressure_kpa', label: 'Pressure', unit: 'kPa', kind: 'profile', only: of => of.kind === 'load'},
    {key: 'shear_kpa', label: 'Shear stress along the line', unit: 'kPa', kind: 'profile', only: of => of.kind === 'load'},
    {key: 'live', label: 'Live: its factor is bounded', kind: 'flag', only: of => of.kind === 'load'},
    {...ACTION, only: of => of.kind === 'load'},
  ],
  structure: [text('name', 'Name'), ...FACES, HELD],
  plate: [text('name', 'Name'), ...FACES, HELD],
  member: [
    text('name', 'Name'), number('tensile_kn_per_m', 'Tension at most', 'kN/m'), number('compressive_kn_per_m', 'Compression at most', 'kN/m', {zero: true}),
    number('bond_factor', 'Bond over strength of soil', '', {optional, help: '1 if not said', only: of => of.pullout_kn_per_m2 === undefined}),
    {key: 'pullout_kn_per_m2', label: 'Pullout resistance, if soil goes on between bars', unit: 'kPa', kind: 'profile', empty: 'a sheet', only: of => of.moment_knm_per_m === undefined},
    number('free_length_m', 'Free length from the start', 'm', {zero: true, only: of => of.pullout_kn_per_m2 !== undefined || of.free_length_m !== undefined}),
    {key: 'attached', label: 'Attached ends', kind: 'words', options: ['start', 'end']},
    number('moment_knm_per_m', 'Bending moment at most', 'kNm/m', {optional, help: 'a beam, if it is said; with a shear force'}),
    number('shear_kn_per_m', 'Shear force at most', 'kN/m', {optional}),
  ],
  head: [text('name', 'Name', {optional}), number('head_m', 'Total head: y of the water in a standpipe', 'm')],
  water: [number('unit_weight_kn_m3', 'Unit weight of water', 'kN/m³'), number('rise_m', 'Higher than its points by', 'm', {zero: true})],
};

export const OBJECTIVES = [
  ['structure', 'force of a structure'], ['load', 'factor on live loads'], ['strength-reduction', 'factor of safety'], ['unit-weight', 'factor on unit weights'], ['seismic', 'earthquake acceleration'],
];
export const PROBLEM = [
  text('title', 'Title', {optional}),
  number('surcharge_kpa', 'Surcharge on free ground', 'kPa', {zero: true}),
  choice('default_boundary', 'Other outline is', [['', 'not said'], ...KINDS.filter(([kind]) => kind !== 'load')], {optional}),
];
export const SEISMIC = [number('kh', 'k_h towards the right', 'g', {zero: true}), number('kv', 'k_v upwards', 'g', {zero: true})];

export const WORDS = {
  force_kn_per_m: {name: 'force of the structure on the soil along its motion', unit: 'kN/m'},
  load_factor: {name: 'factor on the live loads', unit: ''},
  weight_factor: {name: 'factor on the unit weights', unit: ''},
  acceleration_over_g: {name: 'horizontal acceleration over gravity', unit: 'g'},
  factor_of_safety: {name: 'factor of safety', unit: ''},
};
