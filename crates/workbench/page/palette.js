// Soils by colour and by hatch: each has both, so that they are told apart without colour, and in print.
import {svg} from './dom.js';

export const COUNT = 8;

// Strokes of a square of 14 pixels that repeats.
const HATCHES = [
  ['M3 4h.01M10 11h.01'],
  ['M0 14L14 0'],
  ['M0 4h9M5 11h9'],
  ['M0 0L14 14'],
  ['M7 3v8M3 7h8'],
  ['M0 14L14 0M0 0L14 14'],
  ['M7 7m-3 0a3 3 0 1 0 6 0a3 3 0 1 0 -6 0'],
  ['M0 7q3.5 -5 7 0t7 0'],
];

export const number = index => ((index % COUNT) + COUNT) % COUNT;
export const patternId = (index, prefix = 'soil') => `${prefix}-${number(index)}`;

// Definitions for a drawing. Colours are those of the style sheet.
export function patterns(prefix = 'soil') {
  return HATCHES.map(([path], index) => svg('pattern', {id: patternId(index, prefix), width: 14, height: 14, patternUnits: 'userSpaceOnUse'},
    svg('rect', {width: 14, height: 14, class: `tint-${index}`}), svg('path', {d: path, class: index === 0 ? 'hatch dot' : 'hatch'})));
}

// A small square in the colour and hatch of a soil.
export function swatch(index, prefix) {
  return svg('svg', {class: 'swatch', width: 28, height: 20, 'aria-hidden': 'true'},
    svg('rect', {width: 28, height: 20, rx: 3, fill: `url(#${patternId(index, prefix)})`, class: 'edge'}));
}
