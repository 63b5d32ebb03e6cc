// Where the sandbox stands in the room: the middle of its sand at a place, turned about the vertical, and scaled.
import {Matrix, Vector} from './painter.js';

// Below and before the eyes in m, and seen from the side from which the 3-D view shows it.
const BELOW_M = .5, AHEAD_M = .7, SIDE = -55 * Math.PI / 180;
const LEAST_SCALE = .5, MOST_SCALE = 4;
// From the base frame, whose z points up, into the room's, whose y does.
const UPRIGHT = [1, 0, 0, 0, 0, 0, -1, 0, 0, 1, 0, 0, 0, 0, 0, 1], LYING = [1, 0, 0, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1];
const UP = [0, 1, 0];

const swing = (v, angle) => Matrix.point(Matrix.turn(UP, angle), v);
const heading = ([x, , z]) => Math.atan2(-z, x);

export class Place {
  constructor({x_m, y_m, surface_z_m}) {
    Object.assign(this, {middle: [(x_m[0] + x_m[1]) / 2, (y_m[0] + y_m[1]) / 2, surface_z_m], at: [0, 0, 0], turned: 0, scale: 1});
  }
  // At its true size before somebody, from the matrix of the head.
  before(head) {
    const ahead = Place.ahead(head), eye = [...head.slice(12, 15)];
    Object.assign(this, {at: Vector.plus(eye, [AHEAD_M * ahead[0], -BELOW_M, AHEAD_M * ahead[2]]), turned: heading(Vector.times(ahead, -1)) - SIDE, scale: 1});
  }
  // Where somebody looks, on the level; who looks straight down has it along the top of the head.
  static ahead(head) {
    const level = Math.hypot(head[8], head[10]) > .2 ? [-head[8], 0, -head[10]] : [head[4], 0, head[6]];
    return Vector.unit(level);
  }
  move(way) { this.at = Vector.plus(this.at, way); }
  turn(angle) { this.turned += angle; }
  grow(factor) { this.scale = Math.max(LEAST_SCALE, Math.min(MOST_SCALE, this.scale * factor)); }
  // As two hands hold it that took it at two points and are at two others now.
  carry({at, turned, scale, points: [a, b]}, [c, d]) {
    const before = Vector.minus(b, a), now = Vector.minus(d, c), angle = heading(now) - heading(before);
    this.scale = scale;
    this.grow(Vector.size(now) / Math.max(.05, Vector.size(before)));
    this.turned = turned + angle;
    const middle = (p, q) => Vector.times(Vector.plus(p, q), .5);
    this.at = Vector.plus(middle(c, d), swing(Vector.times(Vector.minus(at, middle(a, b)), this.scale / scale), angle));
  }
  // From the base frame to the room, and back.
  matrix() { return chain(Matrix.move(this.at), Matrix.turn(UP, this.turned), Matrix.scale(Array(3).fill(this.scale)), UPRIGHT, Matrix.move(Vector.times(this.middle, -1))); }
  inverse() { return chain(Matrix.move(this.middle), LYING, Matrix.scale(Array(3).fill(1 / this.scale)), Matrix.turn(UP, -this.turned), Matrix.move(Vector.times(this.at, -1))); }
  toRoom(point) { return Matrix.point(this.matrix(), point); }
  toBase(point) { return Matrix.point(this.inverse(), point); }
  // A direction of the room in the base frame, of the same size.
  turnToBase(v) { return Matrix.point(LYING, swing(v, -this.turned)); }
}

const chain = (...all) => all.reduce(Matrix.times);
