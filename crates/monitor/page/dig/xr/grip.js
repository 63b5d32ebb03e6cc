// What holds the plate. The target moves as the hand has moved since it took hold, so that nothing jumps.

export class Grip {
  constructor(hand) { Object.assign(this, {hand, source: null, from: null, tilt: null}); }
  // From the next pose of this source on.
  take(source) { Object.assign(this, {source, from: null, tilt: null}); }
  drop() {
    if (this.source) this.hand.drop();
    Object.assign(this, {source: null, from: null, tilt: null});
  }
  // Where the source is: a point and an attitude (a quaternion) in the base frame. While it is squeezed the plate turns with it.
  follow({point, attitude}, squeezed) {
    const {hand} = this;
    if (!this.from) {
      hand.drag({});
      if (hand.target) this.from = {point, target: upright(hand.target)};
      return;
    }
    // Somebody else let go: it takes a new grip to go on.
    if (!hand.dragged || !hand.target) { this.drop(); return; }
    const place = around(this.from.target.map((part, i) => part + point[i] - this.from.point[i]), hand.target.base);
    if (squeezed) {
      this.tilt ??= {attitude, tool: hand.target.tool};
      place.tool = this.tilt.tool + turnedAbout(this.tilt.attitude, attitude, [Math.sin(place.base), -Math.cos(place.base), 0]) * 180 / Math.PI;
    } else this.tilt = null;
    hand.drag(place);
    if (squeezed) hand.wantedTool = hand.target.tool;
  }
}

// From the hand's coordinates to those of the base frame, and back, with the base angle that is nearest to a given one.
export const upright = ({radius, base, z}) => [radius * Math.cos(base), radius * Math.sin(base), z];
function around([x, y, z], near) { return {radius: Math.hypot(x, y), base: near + nearest(Math.atan2(y, x) - near), z}; }
const nearest = angle => angle - 2 * Math.PI * Math.round(angle / (2 * Math.PI));

// By which angle in rad an attitude is turned about an axis against one before: the twist in the quotient of both.
export function turnedAbout([a, b, c, d], [x, y, z, w], [u, v, s]) {
  const along = (d * x - w * a + c * y - b * z) * u + (d * y - w * b + a * z - c * x) * v + (d * z - w * c + b * x - a * y) * s;
  return nearest(2 * Math.atan2(along, w * d + x * a + y * b + z * c));
}
