// The arm as its URDF describes it: a tree of joints, and plain bodies on its links.
class Arm {
  constructor(urdf) {
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
      const at = origin(visual).slice(12, 15), reach = Vector.size(at);
      // What hangs behind a joint hangs on something.
      if (shape.tagName === 'sphere' && reach > 2 * number('radius') && at[2] < 0)
        this.bodies.push({link: visual.parentElement.getAttribute('name'), place: Matrix.move(Vector.times(at, .5)), mesh: Shapes.cylinder(.007, reach), colour: [.55, .56, .58, 1]});
      this.bodies.push({link: visual.parentElement.getAttribute('name'), place: origin(visual), mesh,
                        colour: colours[name] ?? [.7, .7, .7, 1], metal: shape.tagName === 'box'});
    }
    this.joints = [...robot.querySelectorAll(':scope > joint')].map(joint => ({
      parent: joint.querySelector('parent').getAttribute('link'), child: joint.querySelector('child').getAttribute('link'),
      place: origin(joint), axis: Vector.unit(numbers(joint.querySelector('axis')?.getAttribute('xyz'), [1, 0, 0])),
      turns: ['revolute', 'continuous'].includes(joint.getAttribute('type')),
    }));
  }
  // Matrices of all links for joint angles in degrees, in the order of the joints that turn.
  pose(angles) {
    const links = {}, children = new Set(this.joints.map(joint => joint.child));
    for (const joint of this.joints) if (!children.has(joint.parent)) links[joint.parent] = Matrix.unit();
    let left = this.joints.map((joint, n) => ({joint, angle: joint.turns ? angles[this.joints.slice(0, n).filter(j => j.turns).length] : 0}));
    while (left.length) {
      const ready = left.filter(({joint}) => links[joint.parent]);
      if (!ready.length) break;
      for (const {joint, angle} of ready) {
        const at = Matrix.times(links[joint.parent], joint.place);
        links[joint.child] = joint.turns ? Matrix.times(at, Matrix.turn(joint.axis, angle * Math.PI / 180)) : at;
      }
      left = left.filter(({joint}) => !links[joint.child]);
    }
    return links;
  }
}
