// Where a camera stands that has everything in its picture.
// `out`: the direction from what it looks at to the camera; `room`: how far the picture reaches to the left, to the right, down and up,
// as tangents. Returns the target, amid the points' depths, and the distance from it.
function standpoint(points, out, {left, right, down, up}) {
  const x = Vector.unit(Vector.cross([0, 0, 1], out)), y = Vector.cross(out, x), places = points.map(point => [x, y, out].map(axis => Vector.dot(point, axis)));
  // With the camera at u across and at d in depth, a point at a and c is in the picture if u is from a - plus (d - c) to a + minus (d - c).
  const across = (axis, minus, plus) => {
    const least = Math.max(...places.map(place => place[axis] + plus * place[2])), most = Math.min(...places.map(place => place[axis] - minus * place[2]));
    return {depth: (least - most) / (minus + plus), at: depth => (least + most + (minus - plus) * depth) / 2};
  };
  const wide = across(0, left, right), high = across(1, down, up), depth = Math.max(wide.depth, high.depth), depths = places.map(place => place[2]);
  const middle = (Math.min(...depths) + Math.max(...depths)) / 2;
  const target = [Vector.times(x, wide.at(depth)), Vector.times(y, high.at(depth)), Vector.times(out, middle)].reduce(Vector.plus);
  return {target, distance: depth - middle};
}

// Corners of a box.
function corners([x0, y0, z0], [x1, y1, z1]) {
  return [x0, x1].flatMap(x => [y0, y1].flatMap(y => [z0, z1].map(z => [x, y, z])));
}
