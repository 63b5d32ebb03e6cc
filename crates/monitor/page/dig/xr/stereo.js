// Paints the sandbox for the eyes of a headset, as the 3-D view does, with what leads the plate.
import {LOOKS, Matrix, Painter, Shapes, Vector, across, KIND} from './painter.js';
import {Board} from './board.js';
import {upright} from './grip.js';
import {FORCE_M_PER_N} from '../section.js';

const FORCE = [.04, .52, .84], HAND = [.91, .42, 0], FREE = [.45, .52, .6];
// How strongly that is seen which is behind sand.
const BEHIND = .35;
const HANDLE_M = .1, HANDLE_RADIUS_M = .011, TARGET_RADIUS_M = .007, THREAD_RADIUS_M = .0012;

export class Stereo extends Painter {
  constructor(canvas) {
    super(canvas, {xrCompatible: true});
    this.ready = Boolean(this.gl);
    if (!this.ready) return;
    this.begin();
    this.block = this.mesh(Shapes.box([1, 1, 1]));
    this.board = new Board(this);
  }
  // All of the surface at once; patches follow.
  fill({columns, rows, heights}) {
    if (!columns) return;
    this.soil.begin(columns, rows);
    this.soil.heights.set(heights);
    this.soil.refresh(0, 0, columns - 1, rows - 1);
  }
  // `shown`: the state, the hand's target, the hands, what the board says, and where the floor is.
  show({framebuffer, eyes, place, clear, shown}) {
    const {gl} = this, look = LOOKS[this.look];
    Object.assign(this, shown);
    const links = this.reached(this.pose()), placed = place.matrix();
    this.board.write(this.says);
    this.board.hang(place, place.toBase(eyes[0].position));
    this.shade(links, look);
    gl.bindFramebuffer(gl.FRAMEBUFFER, framebuffer);
    gl.clearColor(...clear ? [0, 0, 0, 0] : [...look.clear, 1]);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    for (const {viewport: {x, y, width, height}, projection, inverse, position} of eyes) {
      const view = Matrix.times(projection, Matrix.times(inverse, placed));
      gl.viewport(x, y, width, height);
      this.paint(links, look, {view, eye: place.toBase(position), shadows: true});
      this.board.put(view);
    }
  }
  // The encoders do not see the cables' stretch, but the controller's plate does: what they differ by is spread along the arm.
  reached(links) {
    const {plate} = this.state ?? {}, above = new Map(this.arm.joints.map(joint => [joint.child, joint.parent])), chain = [];
    for (let link = this.description.tip_link; above.has(link); link = above.get(link)) chain.unshift(link);
    if (!plate || !this.tip || chain.length < 2) return links;
    const off = Vector.minus([plate.x_m, plate.y_m, plate.z_m], this.tip);
    chain.forEach((link, k) => { links[link] = Matrix.times(Matrix.move(Vector.times(off, k / (chain.length - 1))), links[link]); });
    this.tip = links[this.description.tip_link].slice(12, 15);
    return links;
  }
  // The room's floor, if it is known, and what the box and the arm's table stand on.
  below(eye, look) {
    if (this.floor_z_m === null) return;
    const {x_m, y_m, floor_z_m} = this.description.sandbox, block = ([x0, x1], [y0, y1], top) => {
      if (top > this.floor_z_m) this.put(this.block, Matrix.times(Matrix.move([(x0 + x1) / 2, (y0 + y1) / 2, (top + this.floor_z_m) / 2]), Matrix.scale([x1 - x0, y1 - y0, top - this.floor_z_m])), look.table, KIND.body, .05);
    };
    if (eye[2] > this.floor_z_m) this.put(this.floor[0], Matrix.move([this.floor[1][12], this.floor[1][13], this.floor_z_m]), look.floor, KIND.floor);
    block([-.3, .04], [-.26, .26], -.036);
    block(x_m, y_m, floor_z_m - .017);
  }
  // Force, target and hands; what is behind sand is seen through it.
  vectors() {
    const {gl} = this;
    gl.depthMask(false);
    gl.depthFunc(gl.GREATER);
    this.signs(BEHIND);
    gl.depthMask(true);
    gl.depthFunc(gl.LESS);
    this.signs(1);
    for (const {matrix, grips} of this.hands) this.put(this.rod, Matrix.times(matrix, Matrix.scale([HANDLE_RADIUS_M, HANDLE_RADIUS_M, HANDLE_M])), [...grips ? HAND : FREE, 1], KIND.sign);
  }
  signs(opacity) {
    const {state, target, tip} = this;
    if (!tip || !state?.plate) return;
    const [r, t, z] = state.force_rtz_n, base = Math.atan2(tip[1], tip[0]), [c, s] = [Math.cos(base), Math.sin(base)];
    this.sign(tip, Vector.times([r * c - t * s, r * s + t * c, z], FORCE_M_PER_N), .0035, [...FORCE, opacity]);
    if (!target) return;
    const at = upright(target), ball = TARGET_RADIUS_M;
    this.put(this.ball, Matrix.times(Matrix.move(at), Matrix.scale([ball, ball, ball])), [...HAND, opacity], KIND.sign);
    this.thread(tip, at, [...HAND, .6 * opacity]);
    const hand = this.hands.find(({grips}) => grips);
    if (hand && opacity === 1) this.thread(at, hand.matrix.slice(12, 15), [...HAND, .4]);
  }
  thread(from, to, colour) {
    const way = Vector.minus(to, from), length = Vector.size(way);
    if (length < 1e-3) return;
    const [x, y] = across(Vector.times(way, 1 / length)), half = Vector.times(Vector.plus(from, to), .5);
    this.put(this.rod, [...Vector.times(x, THREAD_RADIUS_M), 0, ...Vector.times(y, THREAD_RADIUS_M), 0, ...way, 0, ...half, 1], colour, KIND.sign);
  }
}
