// The soil's surface and its body in the box, as triangles.
const HEIGHT_UNIT_M = 1e-5;
class Soil {
  constructor(box) { this.box = box; this.columns = 0; this.changed = false; }
  patch({grid, column, row, columns, heights}) {
    const [n, m] = grid;
    if (n !== this.columns || m !== this.rows) this.begin(n, m);
    heights.forEach((height, k) => {
      const i = column + k % columns, j = row + Math.floor(k / columns);
      this.heights[j * n + i] = height * HEIGHT_UNIT_M;
    });
    this.refresh(column, row, column + columns - 1, row + Math.ceil(heights.length / columns) - 1);
  }
  begin(n, m) {
    Object.assign(this, {columns: n, rows: m, heights: new Float32Array(n * m), points: new Float32Array(6 * n * m)});
    const faces = new Uint32Array(6 * (n - 1) * (m - 1));
    let f = 0;
    for (let j = 0; j + 1 < m; j++) for (let i = 0; i + 1 < n; i++) {
      const p = j * n + i;
      faces.set([p, p + 1, p + n, p + n, p + 1, p + n + 1], f);
      f += 6;
    }
    this.faces = faces;
    this.refresh(0, 0, n - 1, m - 1);
  }
  // Centre of a cell; the outermost ones reach to the walls.
  place(i, j) {
    const {x_m: [x0, x1], y_m: [y0, y1], cell_m} = this.box;
    return [i === 0 ? x0 : i === this.columns - 1 ? x1 : x0 + (i + .5) * cell_m, j === 0 ? y0 : j === this.rows - 1 ? y1 : y0 + (j + .5) * cell_m];
  }
  refresh(i0, j0, i1, j1) {
    const {columns: n, rows: m, heights: h, points} = this, cell = this.box.cell_m;
    for (let j = Math.max(0, j0 - 1); j <= Math.min(m - 1, j1 + 1); j++) for (let i = Math.max(0, i0 - 1); i <= Math.min(n - 1, i1 + 1); i++) {
      const k = j * n + i, [x, y] = this.place(i, j);
      const left = i > 0 ? 1 : 0, right = i + 1 < n ? 1 : 0, down = j > 0 ? n : 0, up = j + 1 < m ? n : 0;
      const dx = (h[k + right] - h[k - left]) / ((left + right) * cell), dy = (h[k + up] - h[k - down]) / (((down ? 1 : 0) + (up ? 1 : 0)) * cell);
      const size = Math.hypot(dx, dy, 1);
      points.set([x, y, this.box.surface_z_m + h[k], -dx / size, -dy / size, 1 / size], 6 * k);
    }
    this.changed = true;
  }
  // The sides of the sand behind the glass.
  skirt() {
    const {columns: n, rows: m} = this, points = [], faces = [], floor = this.box.floor_z_m;
    const edge = (cells, normal) => {
      const first = points.length / 6;
      cells.forEach((k, c) => {
        const [x, y, z] = this.points.subarray(6 * k, 6 * k + 3);
        points.push(x, y, z, ...normal, x, y, floor, ...normal);
        if (c) { const p = first + 2 * c - 2; faces.push(p, p + 1, p + 2, p + 2, p + 1, p + 3); }
      });
    };
    const row = j => Array.from({length: n}, (_, i) => j * n + i), column = i => Array.from({length: m}, (_, j) => j * n + i);
    edge(row(0), [0, -1, 0]); edge(row(m - 1), [0, 1, 0]); edge(column(0), [-1, 0, 0]); edge(column(n - 1), [1, 0, 0]);
    return {points: new Float32Array(points), faces: new Uint32Array(faces)};
  }
}
