// The 3-D view: what is painted on a canvas, from where a camera stands.
const FOV_DEG = 32, TIP_PX = 9;
// Views with `fits` have the arm and the box in their picture, wherever the arm is, until somebody turns, moves or zooms them.
const VIEWS = {
  home: {azimuth: -55, elevation: 22, distance: 2.2, off: [0, 0, 0], fits: true}, side: {azimuth: -90, elevation: 3, distance: 1.9, off: [0, 0, 0], fits: true},
  top: {azimuth: -90, elevation: 89, distance: 1.9, off: [0, 0, -.23]}, plate: {azimuth: -118, elevation: 30, distance: .6, off: null},
};
// The room around what a view fits. When less than the least is left it is fitted anew, with some to spare, so that it seldom moves.
const ROOM_PX = 22, LEAST_ROOM_PX = 5, SPARE = 1.06;
// Other views stand further away where width by height is less.
const NARROW = 1.12;

class Scene extends Painter {
  constructor(canvas, say, covered) {
    super(canvas, {antialias: !isSoftware()});
    Object.assign(this, {canvas, say, covered});
    this.ready = Boolean(this.gl);
    this.pace = new Pace(() => this.redraw());
    this.show('home');
    this.drawn = [];
    say(this.ready);
    if (!this.ready) return;
    canvas.addEventListener('webglcontextlost', event => { event.preventDefault(); this.setReady(false); });
    canvas.addEventListener('webglcontextrestored', () => { this.setReady(true); this.begin(); if (this.description) this.build(); });
    this.begin();
  }
  setReady(ready) { this.ready = ready; this.say(ready); }
  describe(description) {
    if (description.urdf !== this.description?.urdf) this.camera.points = null;
    this.forceScale = FORCE_SCALE;
    const before = JSON.stringify(this.space);
    super.describe(description);
    if (JSON.stringify(this.space) !== before) this.show(this.camera.view);
  }
  build() {
    super.build();
    this.redraw();
  }
  patch(patch) { this.soil?.patch(patch); this.redraw(); }
  show(view) {
    const {off, distance, ...look} = VIEWS[view], {middle, size} = this.space;
    const target = off && Vector.plus(middle, this.space === OWN_SPACE ? off : [0, 0, 0]);
    this.camera = {...look, distance: distance * size, target, view, narrow: NARROW};
    this.redraw();
  }
  turn(azimuth, elevation) {
    const camera = this.camera;
    camera.fits = false;
    camera.azimuth += azimuth;
    camera.elevation = Math.min(89, Math.max(-10, camera.elevation + elevation));
    this.redraw();
  }
  zoom(factor) { this.camera.fits = false; this.camera.distance = Math.min(6 * this.space.size, Math.max(.15 * this.space.size, this.camera.distance * factor)); this.redraw(); }
  shift(x, y) {
    const {eye, target} = this.lens(), z = Vector.unit(Vector.minus(eye, target)), right = Vector.unit(Vector.cross([0, 0, 1], z)), up = Vector.cross(z, right);
    const scale = 2 * this.camera.distance * Math.tan(FOV_DEG * Math.PI / 360) / this.canvas.clientHeight;
    this.camera.fits = false;
    this.camera.target = Vector.plus(target, Vector.plus(Vector.times(right, -x * scale), Vector.times(up, y * scale)));
    this.redraw();
  }
  // From what is seen to the camera.
  out() {
    const {azimuth, elevation} = this.camera, rad = Math.PI / 180;
    return [Math.cos(elevation * rad) * Math.cos(azimuth * rad), Math.cos(elevation * rad) * Math.sin(azimuth * rad), Math.sin(elevation * rad)];
  }
  // Where the camera is. A view that has become narrow stands further away, so that the same width is seen.
  lens() {
    const target = this.camera.target ?? (this.tip ? [...this.tip] : [.4, 0, -.33]);
    const narrow = Math.max(1, this.camera.narrow / (this.canvas.clientWidth / this.canvas.clientHeight || 1));
    return {eye: Vector.plus(target, Vector.times(this.out(), this.camera.distance * narrow)), target, up: [0, 0, 1]};
  }
  // Fits a view to where the arm is and was. It is fitted again when the arm leaves it, or when its size changes.
  fit(links) {
    const {camera, canvas: {clientWidth: width, clientHeight: height}} = this;
    if (!camera.fits || !this.state) return;
    const points = this.arm.extent(links), size = `${width} ${height}`;
    if (camera.points && camera.size === size && points.every(point => this.sees(point))) return;
    const {sandbox: box, tip_box_m: tips} = this.description;
    const still = box ? [...corners([box.x_m[0], box.y_m[0], box.floor_z_m], [box.x_m[1], box.y_m[1], box.top_z_m]), ...corners(...TABLE)] : corners(...tips);
    const spare = camera.points && camera.size === size ? SPARE : 1, [above, below] = this.covered();
    Object.assign(camera, {points: [...(camera.points ?? still), ...points], size, narrow: width / height});
    const pixel = 2 * Math.tan(FOV_DEG * Math.PI / 360) / height, room = (all, px) => (all / 2 - px) * pixel / spare, side = room(width, ROOM_PX);
    Object.assign(camera, standpoint(camera.points, this.out(), {left: side, right: side, down: room(height, below + ROOM_PX / 2), up: room(height, above + ROOM_PX)}));
  }
  // Whether a point is in the picture, and not just so.
  sees(point) {
    const {eye, target} = this.lens(), {clientWidth: width, clientHeight: height} = this.canvas, z = Vector.unit(Vector.minus(eye, target));
    const x = Vector.unit(Vector.cross([0, 0, 1], z)), y = Vector.cross(z, x), way = Vector.minus(point, eye);
    const scale = height / 2 / Math.tan(FOV_DEG * Math.PI / 360) / -Vector.dot(way, z);
    return scale > 0 && Math.abs(Vector.dot(way, x)) * scale < width / 2 - LEAST_ROOM_PX && Math.abs(Vector.dot(way, y)) * scale < height / 2 - LEAST_ROOM_PX;
  }
  update(state, safeForce) { [this.state, this.safeForce] = [state, safeForce]; this.redraw(); }
  redraw() {
    if (this.waiting || !this.ready) return;
    this.waiting = true;
    requestAnimationFrame(begin => {
      this.waiting = false;
      this.draw(this.pace.level(begin));
      this.pace.drawn(begin);
    });
  }
  // With `level` above 0 coarser and without shadows.
  draw(level = 0) {
    this.level = level;
    const {gl, canvas} = this;
    if (!this.ready || !this.arm || !canvas.clientWidth) return;
    const ratio = Math.min(devicePixelRatio || 1, 2) * [1, .7, .5][level], size = [Math.round(canvas.clientWidth * ratio), Math.round(canvas.clientHeight * ratio)];
    if (canvas.width !== size[0] || canvas.height !== size[1]) [canvas.width, canvas.height] = size;
    const {size: scale} = this.space, links = this.pose();
    this.fit(links);
    const lens = this.lens(), look = LOOKS[this.look];
    const view = Matrix.times(Matrix.perspective(FOV_DEG * Math.PI / 180, size[0] / size[1], .05 * scale, 12 * scale), Matrix.look(lens.eye, lens.target, lens.up));
    if (!level) this.shade(links, look);
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    gl.viewport(0, 0, ...size);
    gl.clearColor(...look.clear, 1);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    this.paint(links, look, {view, eye: lens.eye, shadows: !level, closely: this.camera.view === 'plate'});
    gl.depthMask(false);
    this.marker(ratio);
    gl.depthMask(true);
    this.note(lens);
  }
  // Forces of so many N at most are known.
  scaleForces(most_n) {
    if (!this.description.sandbox && most_n > 0) this.forceScale = .3 * this.space.size / most_n;
    this.redraw();
  }
  // An arrow from the end-point along a vector.
  arrow(vector, radius, colour) {
    const {eye} = this.lens(), z = Vector.unit(vector);
    // It begins at the rim of the end-point's disc, which would hide a short one.
    const pixel = 2 * Vector.size(Vector.minus(eye, this.tip)) * Math.tan(FOV_DEG * Math.PI / 360) / this.canvas.clientHeight;
    this.sign(Vector.plus(this.tip, Vector.times(z, (TIP_PX / 2 + 2) * pixel)), vector, radius, colour);
  }
  vectors() {
    const state = this.state, {gl} = this;
    if (!this.tip || !(state?.plate || state?.force_n)) return;
    if (state.force_n) {
      gl.disable(gl.DEPTH_TEST);
      this.arrow(Vector.times(state.force_n, this.forceScale), .0035, [.04, .52, .84, 1]);
      gl.enable(gl.DEPTH_TEST);
      return;
    }
    const [r, t, z] = state.force_rtz_n, out = Vector.unit([this.tip[0], this.tip[1], 0]), rtz = (a, b, c) => [a * out[0] - b * out[1], a * out[1] + b * out[0], c];
    const safe = this.safeForce, plate = state.plate.tool_angle_deg - 90;
    gl.disable(gl.DEPTH_TEST);
    if (safe?.angle_deg.length && state.trajectory === 'stroke') {
      const points = [...this.tip, 0, 0, 1], faces = [], first = safe.angle_deg[0], last = safe.angle_deg.at(-1), parts = 32;
      for (let k = 0; k <= parts; k++) {
        const angle = first + (last - first) * k / parts, incline = (plate + angle) * Math.PI / 180, size = FORCE_SCALE * interpolate(safe, angle);
        points.push(...Vector.plus(this.tip, rtz(size * Math.cos(incline), 0, size * Math.sin(incline))), 0, 0, 1);
        if (k) faces.push(0, k, k + 1);
      }
      this.safeMesh = this.mesh({points, faces: new Uint32Array(faces)}, this.safeMesh);
      this.put(this.safeMesh, Matrix.unit(), [.18, .71, .5, .45], KIND.flat);
    }
    this.arrow(Vector.times(rtz(r, t, z), FORCE_SCALE), .0035, [.04, .52, .84, 1]);
    if (state.lead_m !== null) {
      const incline = state.lead_inclination_deg * Math.PI / 180, size = LEAD_SCALE * state.lead_m;
      this.arrow(rtz(-size * Math.cos(incline), 0, -size * Math.sin(incline)), .003, [.91, .42, 0, 1]);
    }
    gl.enable(gl.DEPTH_TEST);
  }
  // The end-point: a disc of a colour that nothing else has, in front of everything.
  marker(ratio) {
    const {gl, places} = this;
    if (!this.tip) return;
    gl.disable(gl.DEPTH_TEST);
    for (const [size, colour] of [[TIP_PX + 3, [1, 1, 1, -1]], [TIP_PX, [1, 0, 1, -1]]]) {
      gl.uniform1f(places.dot_px, size * ratio);
      this.put(this.point, Matrix.move(this.tip), colour, KIND.flat, 0, gl.POINTS);
    }
    gl.enable(gl.DEPTH_TEST);
  }
  // Says what was drawn, for whoever wants to compare.
  note({eye, target, up}) {
    const now = performance.now(), {dataset, clientWidth, clientHeight} = this.canvas;
    this.drawn.push(now);
    while (this.drawn[0] < now - 1000) this.drawn.shift();
    dataset.camera = JSON.stringify({eye, target, up, fov_deg: FOV_DEG, width: clientWidth, height: clientHeight});
    dataset.tick = this.state?.tick ?? '';
    dataset.frames = Number(dataset.frames ?? 0) + 1;
  }
}

// Whether there is no graphics processor.
function isSoftware() {
  const gl = document.createElement('canvas').getContext('webgl2'), names = gl?.getExtension('WEBGL_debug_renderer_info');
  const name = gl ? String(gl.getParameter(names ? names.UNMASKED_RENDERER_WEBGL : gl.RENDERER)) : '';
  gl?.getExtension('WEBGL_lose_context')?.loseContext();
  return /swiftshader|llvmpipe|software|basic render/i.test(name);
}

function interpolate({angle_deg: angles, force_n: forces}, angle) {
  const above = angles.findIndex(a => a >= angle);
  if (above <= 0) return above ? forces.at(-1) : forces[0];
  const share = (angle - angles[above - 1]) / (angles[above] - angles[above - 1]);
  return forces[above - 1] + share * (forces[above] - forces[above - 1]);
}
