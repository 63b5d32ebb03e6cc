// Units that are shown and typed: SI, as the document has them, or US customary. The document, its text and what the solver says stay in SI.
import {keep, kept} from './keep.js';

// A foot in m and a pound-force in kN, exactly (NIST SP 811).
const FOOT = .3048, POUND = .0044482216152605;
// What one of an SI unit is in the customary one.
const US = {
  m: ['ft', 1 / FOOT], kPa: ['psf', FOOT ** 2 / POUND], 'kPa/m': ['psf/ft', FOOT ** 3 / POUND], 'kN/m³': ['pcf', FOOT ** 3 / POUND],
  'kN/m': ['lb/ft', FOOT / POUND], 'kNm/m': ['lb·ft/ft', 1 / POUND], 'm/s': ['ft/s', 1 / FOOT], MPa: ['psi', 1000 * FOOT ** 2 / POUND / 144],
};
// Digits of a number in a field, and of what a field makes of one that is typed.
const SHOWN = 7, READ = 12;
let isUs = kept('local', 'units') === 'us';

const per = name => isUs ? US[name]?.[1] ?? 1 : 1;

// What a unit is called.
export const unit = name => isUs ? US[name]?.[0] ?? name : name;
// A value in the unit that is shown, as it is.
export const inUnit = (value, name) => Number.isFinite(value) ? value * per(name) : value;
// The same for a field; what is no number stays what it is.
export const toField = (value, name) => per(name) === 1 || !Number.isFinite(value) ? value : Number(inUnit(value, name).toPrecision(SHOWN));
// What was typed, in the document's unit.
export const fromField = (value, name) => per(name) === 1 || !Number.isFinite(value) ? value : Number((value / per(name)).toPrecision(READ));

export const areCustomary = () => isUs;
export function turnUnits() { isUs = !isUs; keep('local', 'units', isUs ? 'us' : 'si'); }
