// Triangles of plain bodies: {points: [x, y, z, nx, ny, nz, ...], faces: [...]}.
const Shapes = {
  // A body of revolution about z from its outline [radius, z], with edges where the outline has corners.
  turned(outline, parts = 40) {
    const points = [], faces = [];
    for (let n = 0; n + 1 < outline.length; n++) {
      const [r0, z0] = outline[n], [r1, z1] = outline[n + 1], length = Math.hypot(r1 - r0, z1 - z0);
      if (!length) continue;
      const nr = (z1 - z0) / length, nz = -(r1 - r0) / length, first = points.length / 6;
      for (let k = 0; k <= parts; k++) {
        const a = 2 * Math.PI * k / parts, c = Math.cos(a), s = Math.sin(a);
        points.push(r0 * c, r0 * s, z0, nr * c, nr * s, nz, r1 * c, r1 * s, z1, nr * c, nr * s, nz);
        if (k < parts) { const p = first + 2 * k; faces.push(p, p + 2, p + 1, p + 1, p + 2, p + 3); }
      }
    }
    return {points, faces};
  },
  cylinder(radius, length) {
    const h = length / 2, b = Math.min(radius, h) * .12;
    return Shapes.turned([[0, -h], [radius - b, -h], [radius, -h + b], [radius, h - b], [radius - b, h], [0, h]]);
  },
  sphere(radius, rings = 20) {
    const points = [], faces = [], parts = 32;
    for (let j = 0; j <= rings; j++) for (let k = 0; k <= parts; k++) {
      const t = Math.PI * j / rings, a = 2 * Math.PI * k / parts;
      const n = [Math.sin(t) * Math.cos(a), Math.sin(t) * Math.sin(a), -Math.cos(t)];
      points.push(...n.map(v => v * radius), ...n);
      if (j < rings && k < parts) { const p = j * (parts + 1) + k, q = p + parts + 1; faces.push(p, p + 1, q, q, p + 1, q + 1); }
    }
    return {points, faces};
  },
  // A cylinder with half a ball on each end.
  capsule(radius, length) {
    const arc = (from, z) => Array.from({length: 9}, (_, k) => (from + k / 8) * Math.PI / 2).map(a => [radius * Math.cos(a), z + radius * Math.sin(a)]);
    return Shapes.turned([...arc(-1, -length / 2), ...arc(0, length / 2)]);
  },
  box([x, y, z]) {
    const points = [], faces = [], half = [x / 2, y / 2, z / 2];
    for (let axis = 0; axis < 3; axis++) for (const side of [-1, 1]) {
      const u = (axis + 1) % 3, v = (axis + 2) % 3, first = points.length / 6, n = [0, 0, 0];
      n[axis] = side;
      for (const [a, b] of [[-1, -1], [1, -1], [1, 1], [-1, 1]]) {
        const p = [0, 0, 0];
        p[axis] = side * half[axis]; p[u] = a * half[u]; p[v] = b * half[v];
        points.push(...p, ...n);
      }
      faces.push(...(side > 0 ? [0, 1, 2, 0, 2, 3] : [0, 2, 1, 0, 3, 2]).map(k => first + k));
    }
    return {points, faces};
  },
  // The edges of a box, as lines.
  edges([x, y, z]) {
    const ends = corners([-x / 2, -y / 2, -z / 2], [x / 2, y / 2, z / 2]), faces = [];
    for (const bit of [1, 2, 4]) for (let k = 0; k < 8; k++) if (!(k & bit)) faces.push(k, k | bit);
    return {points: ends.flatMap(end => [...end, 0, 0, 1]), faces};
  },
  // Corners of the box around a body.
  around({points}) {
    const low = [0, 1, 2].map(axis => Infinity), high = low.map(value => -value);
    points.forEach((value, k) => { const axis = k % 6; if (axis < 3) [low[axis], high[axis]] = [Math.min(low[axis], value), Math.max(high[axis], value)]; });
    return corners(low, high);
  },
  // From the origin along z; thick ones have a head.
  arrow(length, radius) {
    const head = Math.min(length, radius * 5);
    return Shapes.turned([[0, 0], [radius, 0], [radius, length - head], [radius * 2.4, length - head], [0, length]], 24);
  },
};
