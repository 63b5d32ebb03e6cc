// Where the arm's joints are, from the scene's tree of joints and the angles of a state.

const times = (a, b) => Array.from({length: 16}, (_, k) => [0, 1, 2, 3].reduce((sum, i) => sum + a[i * 4 + k % 4] * b[(k >> 2) * 4 + i], 0));
function turn([x, y, z], angle) {
  const c = Math.cos(angle), s = Math.sin(angle), d = 1 - c;
  return [x * x * d + c, x * y * d + z * s, x * z * d - y * s, 0, x * y * d - z * s, y * y * d + c, y * z * d + x * s, 0, x * z * d + y * s, y * z * d - x * s, z * z * d + c, 0, 0, 0, 0, 1];
}

// Places in m of the joints, from the base to the end-point. The encoders do not see the cables' stretch, but the controller's `plate` does: what
// they differ by is spread along the arm.
export function skeleton({joints}, angles_deg, tip, plate) {
  const links = {}, at = [], turning = joints.filter(joint => joint.turns);
  const above = Object.fromEntries(joints.map(joint => [joint.child, joint])), chain = [];
  for (let link = tip; above[link]; link = above[link].parent) chain.unshift(above[link]);
  for (const joint of chain) {
    const placed = times(links[joint.parent] ?? [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1], joint.place);
    links[joint.child] = joint.turns ? times(placed, turn(joint.axis, angles_deg[turning.indexOf(joint)] * Math.PI / 180)) : placed;
    at.push(placed.slice(12, 15));
  }
  const end = [plate.x_m, plate.y_m, plate.z_m], last = at.at(-1);
  return at.map((place, k) => place.map((part, i) => part + (end[i] - last[i]) * k / (at.length - 1)));
}
