// The arm as its URDF describes it: a tree of joints, and plain bodies on its links. Links without one are drawn as bones.
class Arm {
  // `rods`: what hangs behind a joint hangs on something.
  constructor(urdf, rods) {
    const robot = new DOMParser().parseFromString(urdf, 'application/xml').documentElement;
    const numbers = (text, other) => text ? text.trim().split(/\s+/).map(Number) : other;
    const origin = node => {
      const place = node.querySelector(':scope > origin');
      return Matrix.times(Matrix.move(numbers(place?.getAttribute('xyz'), [0, 0, 0])),
                          Matrix.attitude(numbers(place?.getAttribute('rpy'), [0, 0, 0])));
    };
    const colours = {};
    for (const material of robot.querySelectorAll(':scope > material'))
      colours[material.getAttribute('name')] = numbers(material.querySelector('color')?.getAttribute('rgba'));
    this.bodies = [];
    for (const visual of robot.querySelectorAll(':scope > link > visual')) {
      const shape = visual.querySelector(':scope > geometry')?.firstElementChild, number = name => Number(shape.getAttribute(name));
      const mesh = shape?.tagName === 'cylinder' ? Shapes.cylinder(number('radius'), number('length'))
        : shape?.tagName === 'sphere' ? Shapes.sphere(number('radius'))
        : shape?.tagName === 'box' ? Shapes.box(numbers(shape.getAttribute('size'))) : null;
      if (!mesh) continue;
      const name = visual.querySelector(':scope > material')?.getAttribute('name');
      const own = visual.querySelector(':scope > material > color')?.getAttribute('rgba');
      const at = origin(visual).slice(12, 15), reach = Vector.size(at);
      if (rods && shape.tagName === 'sphere' && reach > 2 * number('radius') && at[2] < 0)
        this.bodies.push({link: visual.parentElement.getAttribute('name'), place: Matrix.move(Vector.times(at, .5)), mesh: Shapes.cylinder(.007, reach), colour: [.55, .56, .58, 1]});
      this.bodies.push({link: visual.parentElement.getAttribute('name'), place: origin(visual), mesh,
                        colour: numbers(own) ?? colours[name] ?? [.7, .7, .7, 1], metal: shape.tagName === 'box',
                        size: shape.tagName === 'box' ? numbers(shape.getAttribute('size')) : null});
    }
    for (const body of this.bodies) body.corners = Shapes.around(body.mesh);
    this.joints = [...robot.querySelectorAll(':scope > joint')].map(joint => {
      const type = joint.getAttribute('type'), mimic = joint.querySelector(':scope > mimic');
      return {
        name: joint.getAttribute('name'), parent: joint.querySelector('parent').getAttribute('link'), child: joint.querySelector('child').getAttribute('link'),
        place: origin(joint), axis: Vector.unit(numbers(joint.querySelector('axis')?.getAttribute('xyz'), [1, 0, 0])),
        turns: ['revolute', 'continuous'].includes(type), slides: type === 'prismatic',
        mimic: mimic && {joint: mimic.getAttribute('joint'), factor: Number(mimic.getAttribute('multiplier') ?? 1), offset: Number(mimic.getAttribute('offset') ?? 0)},
      };
    });
    const drawn = new Set(this.bodies.map(body => body.link));
    this.bones = this.joints.filter(joint => joint.slides || !drawn.has(joint.parent));
    // How far it can reach at most, sliding joints left out.
    const parent = Object.fromEntries(this.joints.map(joint => [joint.child, joint]));
    const out = link => parent[link] ? out(parent[link].parent) + Vector.size(parent[link].place.slice(12, 15)) : 0;
    this.reach_m = Math.max(...this.joints.map(joint => out(joint.child)));
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
