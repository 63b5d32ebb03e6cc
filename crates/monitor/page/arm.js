// The arm: a tree of joints, and plain bodies on its links. Links without one are drawn as bones.
class Arm {
  // `rods`: what hangs behind a joint hangs on something.
  constructor({bodies, joints}, rods) {
    this.bodies = [];
    for (const {link, place, shape, colour} of bodies) {
      if (shape.kind === 'mesh') {
        // Drawn once it is there.
        this.bodies.push({link, place: Matrix.times(place, Matrix.scale(shape.scale)), number: shape.number, colour, corners: corners(...shape.bounds)});
        continue;
      }
      const {kind, size, radius, length} = shape, at = place.slice(12, 15), reach = Vector.size(at);
      const mesh = kind === 'cylinder' ? Shapes.cylinder(radius, length) : kind === 'sphere' ? Shapes.sphere(radius)
        : kind === 'capsule' ? Shapes.capsule(radius, length) : kind === 'box' ? Shapes.box(size) : null;
      if (!mesh) continue;
      if (rods && kind === 'sphere' && reach > 2 * radius && at[2] < 0)
        this.bodies.push({link, place: Matrix.move(Vector.times(at, .5)), mesh: Shapes.cylinder(.007, reach), colour: [.55, .56, .58, 1]});
      this.bodies.push({link, place, mesh, colour: colour ?? [.7, .7, .7, 1], metal: kind === 'box', size: kind === 'box' ? size : null});
    }
    for (const body of this.bodies) body.corners ??= Shapes.around(body.mesh);
    this.joints = joints;
    const drawn = new Set(this.bodies.map(body => body.link));
    this.bones = this.joints.filter(joint => joint.slides || !drawn.has(joint.parent));
  }
  // Asks for the meshes; whether there were any.
  async fetchMeshes() {
    const numbers = [...new Set(this.bodies.filter(body => !body.mesh).map(body => body.number))];
    const parts = new Map(await Promise.all(numbers.map(async number => {
      const answer = await fetch(`mesh/${number}`).catch(() => null);
      return [number, answer?.ok ? Arm.parts(await answer.arrayBuffer()) : []];
    })));
    this.bodies = this.bodies.flatMap(body => body.mesh ? [body] : parts.get(body.number).map((part, k) => (
      {...body, mesh: part, colour: body.colour ?? part.colour, corners: k ? [] : body.corners})));
    return numbers.length > 0;
  }
  // Parts of a mesh as the monitor packs them.
  static parts(buffer) {
    const words = new Uint32Array(buffer), values = new Float32Array(buffer), parts = [];
    for (let k = 0, at = 1; k < words[0]; k++) {
      const [red, green, blue, opacity] = values.subarray(at, at + 4), points = 6 * words[at + 4], count = words[at + 5];
      at += 6;
      parts.push({points: values.subarray(at, at + points), faces: words.subarray(at + points, at + points + count), colour: [red, green, blue, opacity < 0 ? 1 : opacity]});
      at += points + count;
    }
    return parts;
  }
  // Positions by name, in rad or m: of the states of another program in the order of `names`, else in the order of the joints that turn.
  values(state, names) {
    if (names.length) return Object.fromEntries(names.map((name, k) => [name, state?.positions[k] ?? 0]));
    const angles = state?.joints_deg ?? [0, 30, 100, 0, 30];
    return Object.fromEntries(this.joints.filter(joint => joint.turns).map((joint, k) => [joint.name, angles[k] * Math.PI / 180]));
  }
  // Points between which everything lies.
  extent(links) {
    const ends = this.bones.flatMap(({parent, child}) => [links[parent], links[child]]).filter(Boolean).map(link => link.slice(12, 15));
    return ends.concat(this.bodies.filter(({link}) => links[link]).flatMap(({link, place, corners}) => {
      const at = Matrix.times(links[link], place);
      return corners.map(corner => Matrix.point(at, corner));
    }));
  }
  // Matrices of all links.
  pose(values) {
    const links = {}, children = new Set(this.joints.map(joint => joint.child));
    for (const joint of this.joints) if (!children.has(joint.parent)) links[joint.parent] = Matrix.unit();
    const value = ({name, mimic}) => values[name] ?? (mimic ? mimic.factor * (values[mimic.joint] ?? 0) + mimic.offset : 0);
    let left = this.joints;
    while (left.length) {
      const ready = left.filter(joint => links[joint.parent]);
      if (!ready.length) break;
      for (const joint of ready) {
        const at = Matrix.times(links[joint.parent], joint.place);
        links[joint.child] = joint.turns ? Matrix.times(at, Matrix.turn(joint.axis, value(joint)))
          : joint.slides ? Matrix.times(at, Matrix.move(Vector.times(joint.axis, value(joint)))) : at;
      }
      left = left.filter(joint => !links[joint.child]);
    }
    return links;
  }
}
