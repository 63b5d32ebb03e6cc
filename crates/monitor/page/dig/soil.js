// The soil's surface: heights above the raked level on a grid of cells.
const HEIGHT_UNIT_M = 1e-5;

export class Soil {
  constructor(box) { Object.assign(this, {box, columns: 0, rows: 0, heights: new Float32Array(0), version: 0}); }
  patch({grid: [columns, rows], column, row, columns: wide, heights}) {
    if (columns !== this.columns || rows !== this.rows) Object.assign(this, {columns, rows, heights: new Float32Array(columns * rows)});
    heights.forEach((height, k) => { this.heights[(row + Math.floor(k / wide)) * columns + column + k % wide] = height * HEIGHT_UNIT_M; });
    this.version += 1;
  }
  // Height of the surface in m at a place, between centres of cells; none outside the box.
  at(x, y) {
    const {x_m: [x0, x1], y_m: [y0, y1], cell_m, surface_z_m} = this.box;
    if (!this.columns || x < x0 || x > x1 || y < y0 || y > y1) return null;
    const clamp = (value, most) => Math.max(0, Math.min(most, value));
    const u = clamp((x - x0) / cell_m - .5, this.columns - 1), v = clamp((y - y0) / cell_m - .5, this.rows - 1);
    const i = Math.min(Math.floor(u), this.columns - 2), j = Math.min(Math.floor(v), this.rows - 2), a = u - i, b = v - j;
    const h = (di, dj) => this.heights[(j + dj) * this.columns + i + di];
    return surface_z_m + (h(0, 0) * (1 - a) + h(1, 0) * a) * (1 - b) + (h(0, 1) * (1 - a) + h(1, 1) * a) * b;
  }
  // Deepest furrow and highest heap in m.
  extremes() { return this.heights.reduce(([low, high], h) => [Math.min(low, h), Math.max(high, h)], [0, 0]); }
}
