// Which stroke next: what would be left of the region after a stroke at each tool angle, with the best depth and width there. The plate stands
// below its bar as it would in the ground.
import {get, short, svg} from './dom.js';
import {size} from './plate_section.js';

const FOOT = 62, TOP = 22, LEFT = 8;

export class Next {
  // `attempt` takes a candidate to the plate.
  constructor(attempt) { Object.assign(this, {attempt, place: get('next')}); }

  show(all, why) {
    const {place} = this, words = get('next-words');
    place.toggleAttribute('hidden', !all?.length);
    if (!all?.length) { place.replaceChildren(); words.textContent = why; return; }
    const best = new Map();
    for (const one of all) if (!best.has(one.alpha_deg)) best.set(one.alpha_deg, one);
    const bars = [...best.values()].sort((a, b) => a.alpha_deg - b.alpha_deg), first = all[0];
    const {width, height} = size(place), top = Math.max(1, ...bars.map(one => one.area_left)), pitch = (width - 2 * LEFT) / bars.length;
    const y = part => TOP + (1 - part / top) * (height - TOP - FOOT);
    place.replaceChildren(svg('path', {d: `M${LEFT} ${y(0)}H${width - LEFT}`, class: 'ground'}), svg('path', {d: `M${LEFT} ${y(1)}H${width - LEFT}`, class: 'rule'}), ...bars.map((one, k) => {
      const middle = LEFT + (k + .5) * pitch, half = Math.min(15, .38 * pitch), turn = one.alpha_deg * Math.PI / 180, isBest = one === first;
      const [dx, dy] = [-30 * Math.cos(turn), -30 * Math.sin(turn)], floor = y(0) + 36;
      const told = `tool angle ${short(one.alpha_deg)}°, depth ${short(1000 * one.depth_m, 3)} mm, width ${short(1000 * one.width_m, 3)} mm: ${short(100 * one.area_left, 2)} % of the region is left, at most ${short(one.force_n, 3)} N`;
      const act = () => this.attempt(one);
      return svg('g', {role: 'button', tabindex: 0, class: isBest ? 'candidate best' : 'candidate', 'data-alpha': one.alpha_deg, 'aria-label': `show it: ${told}`, click: act, keydown: event => { if (event.key === 'Enter' || event.key === ' ') { event.preventDefault(); act(); } }},
        svg('title', null, told), svg('rect', {x: middle - pitch / 2, y: 0, width: pitch, height, class: 'touch'}),
        svg('rect', {x: middle - half, y: y(one.area_left), width: 2 * half, height: Math.max(1, y(0) - y(one.area_left)), class: 'bar'}),
        svg('text', {x: middle, y: y(one.area_left) - 5, 'text-anchor': 'middle', class: isBest ? 'strong' : null}, short(100 * one.area_left, 2)),
        svg('path', {d: `M${middle - dx / 2} ${floor}l${dx} ${dy}`, class: 'blade'}),
        svg('text', {x: middle, y: height - 6, 'text-anchor': 'middle'}, `${short(one.alpha_deg)}°`));
    }));
    words.textContent = `Best: a stroke at ${short(first.alpha_deg)}°, ${short(1000 * first.depth_m, 3)} mm deep, ${short(1000 * first.width_m, 3)} mm wide, at most ${short(first.force_n, 3)} N, would leave ${short(100 * first.area_left, 2)} % of the region on average: φ within ${short(first.phi_width_deg, 2)}°, ρ within ${short(first.density_width_kg_m3, 2)} kg/m³. Bars: what is left in %, at the best depth and width of each angle${all.some(one => one.model !== first.model) ? '; where the model has no answer, by Chen & Liu' : ''}.`;
  }
}
