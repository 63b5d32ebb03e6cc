'use strict';
// 4 x 4 matrices, column by column, as WebGL takes them.
const Matrix = {
  unit: () => [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1],
  times(a, b) {
    const c = new Array(16);
    for (let j = 0; j < 4; j++) for (let i = 0; i < 4; i++) {
      let sum = 0;
      for (let k = 0; k < 4; k++) sum += a[k * 4 + i] * b[j * 4 + k];
      c[j * 4 + i] = sum;
    }
    return c;
  },
  move: ([x, y, z]) => [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, x, y, z, 1],
  scale: ([x, y, z]) => [x, 0, 0, 0, 0, y, 0, 0, 0, 0, z, 0, 0, 0, 0, 1],
  turn([x, y, z], angle) {
    const c = Math.cos(angle), s = Math.sin(angle), d = 1 - c;
    return [x * x * d + c, x * y * d + z * s, x * z * d - y * s, 0, x * y * d - z * s, y * y * d + c, y * z * d + x * s, 0,
            x * z * d + y * s, y * z * d - x * s, z * z * d + c, 0, 0, 0, 0, 1];
  },
  // Roll, pitch and yaw of a URDF.
  attitude([roll, pitch, yaw]) {
    const about = Matrix.turn;
    return Matrix.times(about([0, 0, 1], yaw), Matrix.times(about([0, 1, 0], pitch), about([1, 0, 0], roll)));
  },
  perspective(fovRad, aspect, near, far) {
    const f = 1 / Math.tan(fovRad / 2);
    return [f / aspect, 0, 0, 0, 0, f, 0, 0, 0, 0, (far + near) / (near - far), -1, 0, 0, 2 * far * near / (near - far), 0];
  },
  box(half, near, far) {
    return [1 / half, 0, 0, 0, 0, 1 / half, 0, 0, 0, 0, -2 / (far - near), 0, 0, 0, -(far + near) / (far - near), 1];
  },
  look(eye, target, up) {
    const z = Vector.unit(Vector.minus(eye, target)), x = Vector.unit(Vector.cross(up, z)), y = Vector.cross(z, x);
    return [x[0], y[0], z[0], 0, x[1], y[1], z[1], 0, x[2], y[2], z[2], 0, -Vector.dot(x, eye), -Vector.dot(y, eye), -Vector.dot(z, eye), 1];
  },
  point: (m, [x, y, z]) => [0, 1, 2].map(i => m[i] * x + m[4 + i] * y + m[8 + i] * z + m[12 + i]),
};

const Vector = {
  plus: (a, b) => a.map((v, i) => v + b[i]),
  minus: (a, b) => a.map((v, i) => v - b[i]),
  times: (a, s) => a.map(v => v * s),
  dot: (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2],
  cross: (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]],
  size: a => Math.hypot(...a),
  unit: a => { const s = Math.hypot(...a) || 1; return a.map(v => v / s); },
};
