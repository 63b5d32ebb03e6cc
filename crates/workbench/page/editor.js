// Drawing and editing by pointer and by keyboard.
import {say, short} from './dom.js';
import {between, same, segments} from './geometry.js';
import {hit} from './hit.js';
import * as model from './model.js';
import {snap} from './snap.js';

// Tools, their keys, and how many points end what they draw at once.
export const TOOLS = {
  select: {key: 'v', name: 'Select'},
  region: {key: 'r', name: 'Region', closed: true, least: 3},
  line: {key: 'b', name: 'Boundary', least: 2},
  load: {key: 'l', name: 'Load', least: 2, most: 2},
  water: {key: 'w', name: 'Water', least: 1},
  structure: {key: 's', name: 'Body', closed: true, least: 3},
  edge: {key: 'e', name: 'Footing', least: 2, most: 2},
  plate: {key: 'p', name: 'Plate', least: 2},
  member: {key: 'k', name: 'Sheet', least: 2, most: 2},
  head: {key: 'h', name: 'Head', least: 2},
  probe: {key: 'c', name: 'Section line', least: 2, most: 2},
};
const ARROWS = {ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1]};
// Fewer pixels of travel are no drag.
const DRAG_PX = 4;

export class Editor {
  // `changed` is told when something other than the document is to be drawn anew, `probed` the points of a section line.
  constructor(store, view, element, changed, probed) {
    Object.assign(this, {store, view, element, changed, probed, tool: 'select', chosen: null, point: null, drawn: [], cursor: null, snapped: null});
    Object.assign(this, {grid: true, points: true, soil: 0, kind: 'fixed', pointers: new Map(), drag: null});
    const listen = (name, hear, options) => element.addEventListener(name, hear, options);
    listen('pointerdown', event => this.down(event));
    listen('pointermove', event => this.move(event));
    listen('pointerup', event => this.up(event));
    listen('pointercancel', event => this.up(event));
    listen('pointerleave', () => { if (!this.drag && !this.usesKeys) { this.cursor = null; this.changed(); } });
    listen('dblclick', event => this.double(event));
    listen('wheel', event => { event.preventDefault(); this.view.zoom(Math.exp(-event.deltaY * (event.ctrlKey ? .01 : .0015)), this.place(event)); }, {passive: false});
    listen('keydown', event => { if (this.key(event)) event.preventDefault(); });
    listen('contextmenu', event => event.preventDefault());
  }

  get problem() { return this.store.problem; }
  get shape() { return model.shapeOf(this.problem, this.chosen); }

  use(tool) {
    if (this.tool !== tool) this.drawn = [];
    this.tool = tool;
    if (tool !== 'select') {
      this.choose(null);
      if (this.cursor) this.cursor = this.snap(this.cursor).at;
    }
    say(`${TOOLS[tool].name}${tool === 'select' ? '' : ': click, or arrow keys and Enter, for points; Enter twice ends'}`);
    this.changed('tool');
  }

  choose(chosen, point = null) {
    this.chosen = chosen && {section: chosen.section, index: chosen.index ?? null};
    this.point = point;
    this.changed('choice');
  }

  place(event) {
    const {left, top} = this.element.getBoundingClientRect();
    return [event.clientX - left, event.clientY - top];
  }

  snap(at, options = {}) { return snap(at, this.problem, this.view, {grid: this.grid, points: this.points, ...options}); }

  down(event) {
    this.element.focus({preventScroll: true});
    this.element.setPointerCapture(event.pointerId);
    const px = this.place(event), at = this.view.m(px);
    this.pointers.set(event.pointerId, px);
    this.usesKeys = false;
    if (this.pointers.size > 1) { this.drag = {kind: 'pinch', ...this.pinch()}; return; }
    const wide = event.pointerType === 'touch' ? 20 : 9;
    const found = this.tool === 'select' && event.button === 0 ? hit(at, this.problem, this.view, this.chosen, wide) : null;
    this.drag = {kind: 'press', px, at, found, alone: event.altKey, pans: event.button !== 0 || event.shiftKey};
  }

  move(event) {
    const px = this.place(event), before = this.pointers.get(event.pointerId);
    if (before) this.pointers.set(event.pointerId, px);
    if (this.drag?.kind === 'pinch') return this.pinched();
    if (!this.drag) return this.hover(this.view.m(px));
    if (this.drag.kind === 'press' && Math.hypot(px[0] - this.drag.px[0], px[1] - this.drag.px[1]) > DRAG_PX) this.begin(px);
    if (this.drag.kind === 'pan') this.view.pan(px[0] - before[0], px[1] - before[1]);
    if (this.drag.kind === 'point') this.pull(px);
    if (this.drag.kind === 'shape') this.push(px);
  }

  hover(at) {
    if (this.tool === 'select') { this.cursor = at; this.changed('cursor'); return; }
    const {at: to, kind} = this.snap(at, {extra: this.drawn.slice(0, 1)});
    Object.assign(this, {cursor: to, snapped: kind});
    this.changed();
  }

  // What a press becomes when it moves.
  begin() {
    const {found, pans} = this.drag;
    this.store.rest();
    if (!pans && found?.point !== null && found?.point !== undefined) {
      this.choose(found, found.point);
      Object.assign(this.drag, {kind: 'point', from: [...this.shape.points[found.point]], join: `drag ${Date.now()}`});
    } else if (!pans && found && model.isSame(found, this.chosen)) {
      Object.assign(this.drag, {kind: 'shape', first: structuredClone(this.shape.points), join: `drag ${Date.now()}`});
    } else this.drag.kind = 'pan';
  }

  pull(px) {
    const {from, alone, join} = this.drag, now = this.shape.points[this.point];
    const {at} = this.snap(this.view.m(px), {skip: p => same(p, now) || same(p, from)});
    this.store.change(draft => model.movePoint(draft, this.chosen, this.point, at, alone), join);
  }

  // Whole shapes keep their first point on the grid.
  push(px) {
    const {first, at, join} = this.drag, to = this.view.m(px), now = this.shape.points[0];
    const wanted = [first[0][0] + to[0] - at[0], first[0][1] + to[1] - at[1]];
    const snapped = this.snap(wanted, {points: false}).at;
    this.store.change(draft => model.moveShape(draft, this.chosen, [snapped[0] - now[0], snapped[1] - now[1]]), join);
  }

  up(event) {
    this.pointers.delete(event.pointerId);
    const drag = this.drag;
    if (drag?.kind === 'pinch' && this.pointers.size) return;
    this.drag = null;
    this.store.rest();
    if (drag?.kind !== 'press' || event.type === 'pointercancel') return;
    if (this.tool === 'select') this.choose(drag.found, drag.found?.point ?? null);
    else if (!drag.pans) this.put(this.snap(drag.at, {extra: this.drawn.slice(0, 1)}).at);
  }

  double(event) {
    if (this.tool !== 'select') return this.finish();
    const at = this.view.m(this.place(event)), found = hit(at, this.problem, this.view, this.chosen);
    if (found && found.segment !== null) this.insert(found, found.segment, this.snap(at, {points: false}).at);
  }

  insert(of, k, at) {
    const point = this.store.change(draft => model.insertPoint(draft, of, k, at));
    this.choose(of, point);
  }

  pinch() {
    const [a, b] = [...this.pointers.values()];
    return {apart: Math.max(1, Math.hypot(b[0] - a[0], b[1] - a[1])), centre: [(a[0] + b[0]) / 2, (a[1] + b[1]) / 2]};
  }

  pinched() {
    if (this.pointers.size < 2) return;
    const now = this.pinch();
    this.view.zoom(now.apart / this.drag.apart, now.centre);
    this.view.pan(now.centre[0] - this.drag.centre[0], now.centre[1] - this.drag.centre[1]);
    Object.assign(this.drag, now);
  }

  // Puts a point of what is being drawn. A point where the last one is, or on the first of an area, ends it.
  put(at) {
    const {closed, most} = TOOLS[this.tool], last = this.drawn.at(-1);
    if (last && same(last, at)) return this.finish();
    if (closed && this.drawn.length > 2 && same(this.drawn[0], at)) return this.finish();
    this.drawn.push([...at]);
    say(`point ${this.drawn.length} at ${short(at[0])}, ${short(at[1])}`);
    if (this.drawn.length === most) this.finish(); else this.changed('drawn');
  }

  finish() {
    const {closed, least} = TOOLS[this.tool], points = model.cleaned(this.drawn, closed);
    if (!this.drawn.length) return;
    if (points.length < least) { say(`this needs ${least} points at least`); return; }
    this.drawn = [];
    // A section line is no part of the document.
    if (this.tool === 'probe') { this.tool = 'select'; this.probed(points); this.changed('tool'); return; }
    const made = this.store.change(draft => model.add(draft, this.tool, points, {soil: this.soil, kind: this.kind}));
    this.tool = 'select';
    this.choose(made);
    say(`${model.label(this.problem, made)} was added`);
    this.changed('tool');
  }

  cancel() {
    if (this.drawn.length) this.drawn = [];
    else if (this.tool !== 'select') this.tool = 'select';
    else if (this.point !== null) this.point = null;
    else this.chosen = null;
    this.changed('choice');
    this.changed('tool');
  }

  back() { this.drawn.pop(); this.changed('drawn'); }

  remove() {
    if (!this.chosen) return;
    const words = model.label(this.problem, this.chosen), {chosen, point} = this;
    this.choose(null);
    this.store.change(draft => point === null ? model.remove(draft, chosen) : model.removePoint(draft, chosen, point));
    say(point === null ? `${words} was removed` : 'the point was removed');
  }

  next(step) {
    const all = model.shapes(this.problem);
    if (!all.length) return;
    const k = all.findIndex(shape => model.isSame(shape, this.chosen));
    const shape = all[(k + step + all.length + (k < 0 && step < 0 ? 1 : 0)) % all.length];
    this.choose(shape);
    say(model.label(this.problem, shape));
  }

  nextPoint(step) {
    const shape = this.shape;
    if (!shape) return;
    this.choose(this.chosen, ((this.point ?? (step > 0 ? -1 : 0)) + step + shape.points.length) % shape.points.length);
    say(`point ${this.point + 1} at ${shape.points[this.point].map(x => short(x)).join(', ')}`);
  }

  // Keys of the drawing; whether one was used.
  key(event) {
    if (event.ctrlKey || event.metaKey) return false;
    const {key} = event, arrow = ARROWS[key];
    if (arrow) return this.arrow(arrow, event.shiftKey ? 10 : 1);
    switch (key) {
      case 'Enter': case ' ': if (this.tool === 'select') return false; this.put(this.cursor ?? this.home()); return true;
      case 'Escape': this.cancel(); return true;
      case 'Backspace': if (this.tool === 'select') this.remove(); else this.back(); return true;
      case 'Delete': this.remove(); return true;
      case 'n': case 'N': this.next(event.shiftKey ? -1 : 1); return true;
      case '.': this.nextPoint(1); return true;
      case ',': this.nextPoint(-1); return true;
      case 'i': {
        const shape = this.shape, k = this.point ?? 0, ends = shape && segments(shape.points, shape.closed)[k];
        if (ends) this.insert(this.chosen, k, between(ends, .5).map(model.tidy));
        return true;
      }
    }
    return false;
  }

  home() { return this.snap([this.view.x, this.view.y]).at; }

  arrow([x, y], times) {
    const step = this.view.step(), by = [x * times * step, y * times * step];
    this.usesKeys = true;
    if (this.tool !== 'select') {
      const from = this.cursor ?? this.home();
      const to = [model.tidy(from[0] + by[0]), model.tidy(from[1] + by[1])];
      Object.assign(this, {cursor: to, snapped: this.snap(to).kind});
      say(`${short(to[0])}, ${short(to[1])}${this.snapped === 'point' ? ', at a point' : ''}`);
      this.changed('cursor');
    } else if (this.shape) {
      const {chosen, point} = this, join = `arrows ${chosen.section} ${chosen.index} ${point}`;
      this.store.change(draft => {
        if (point === null) return model.moveShape(draft, chosen, by);
        const at = model.shapeOf(draft, chosen).points[point];
        return model.movePoint(draft, chosen, point, [model.tidy(at[0] + by[0]), model.tidy(at[1] + by[1])]);
      }, join);
      say(this.shape.points[point ?? 0].map(value => short(value)).join(', '));
    } else this.view.pan(-x * 40 * times, y * 40 * times);
    return true;
  }
}
