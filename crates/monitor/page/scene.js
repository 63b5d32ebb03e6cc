// The 3-D view. Everything is in the base frame, in m.
const FORCE_SCALE = /*FORCE_M_PER_N*/, LEAD_SCALE = /*LEAD_SCALE*/, FOV_DEG = 32, SHADOW_PX = 1024, TIP_PX = 9;
const LOOKS = {
  light: {sky: [.46, .50, .56], ground: [.26, .24, .22], sun: .66, floor: [.88, .89, .90, 1], clear: [.914, .933, .953], table: [.76, .76, .75, 1], edge: [.35, .4, .45, .8]},
  dark: {sky: [.26, .30, .36], ground: [.12, .11, .11], sun: .72, floor: [.15, .17, .19, 1], clear: [.063, .082, .102], table: [.36, .38, .40, 1], edge: [.65, .72, .78, .7]},
};
const SUN = Vector.unit([.42, -.55, .95]);
// The middle of things and how large they are: the arm and its box.
const OWN_SPACE = {middle: [.3, 0, -.1], size: 1};
// Views with `fits` have the arm and the box in their picture, wherever the arm is, until somebody turns, moves or zooms them.
const VIEWS = {
  home: {azimuth: -55, elevation: 22, distance: 2.2, off: [0, 0, 0], fits: true}, side: {azimuth: -90, elevation: 3, distance: 1.9, off: [0, 0, 0], fits: true},
  top: {azimuth: -90, elevation: 89, distance: 1.9, off: [0, 0, -.23]}, plate: {azimuth: -118, elevation: 30, distance: .6, off: null},
};
// The room around what a view fits. When less than the least is left it is fitted anew, with some to spare, so that it seldom moves.
const ROOM_PX = 22, LEAST_ROOM_PX = 5, SPARE = 1.06;
// Other views stand further away where width by height is less.
const NARROW = 1.12;
// Corners of the table that the arm stands on.
const TABLE = [[-.34, -.3, -.035], [.07, .3, 0]];

class Scene {
  constructor(canvas, say, covered) {
    Object.assign(this, {canvas, say, covered});
    this.gl = canvas.getContext('webgl2', {antialias: !isSoftware(), alpha: false, powerPreference: 'high-performance'});
    this.ready = Boolean(this.gl);
    this.pace = new Pace(() => this.redraw());
    this.look = 'light';
    this.space = OWN_SPACE;
    this.show('home');
    this.drawn = [];
    say(this.ready);
    if (!this.ready) return;
    canvas.addEventListener('webglcontextlost', event => { event.preventDefault(); this.setReady(false); });
    canvas.addEventListener('webglcontextrestored', () => { this.setReady(true); this.begin(); if (this.description) this.build(); });
    this.begin();
  }
  setReady(ready) { this.ready = ready; this.say(ready); }
  begin() {
    const gl = this.gl;
    this.meshes = [];
    this.main = this.program(VERTEX, FRAGMENT);
    this.depth = this.program(VERTEX, SHADOW_FRAGMENT);
    this.shadow = gl.createTexture();
    gl.bindTexture(gl.TEXTURE_2D, this.shadow);
    gl.texStorage2D(gl.TEXTURE_2D, 1, gl.DEPTH_COMPONENT24, SHADOW_PX, SHADOW_PX);
    for (const [key, value] of [[gl.TEXTURE_MIN_FILTER, gl.LINEAR], [gl.TEXTURE_MAG_FILTER, gl.LINEAR], [gl.TEXTURE_WRAP_S, gl.CLAMP_TO_EDGE],
      [gl.TEXTURE_WRAP_T, gl.CLAMP_TO_EDGE], [gl.TEXTURE_COMPARE_MODE, gl.COMPARE_REF_TO_TEXTURE], [gl.TEXTURE_COMPARE_FUNC, gl.LEQUAL]]) gl.texParameteri(gl.TEXTURE_2D, key, value);
    this.frame = gl.createFramebuffer();
    gl.bindFramebuffer(gl.FRAMEBUFFER, this.frame);
    gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.DEPTH_ATTACHMENT, gl.TEXTURE_2D, this.shadow, 0);
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    this.rod = this.mesh(Shapes.cylinder(1, 1));
    this.ball = this.mesh(Shapes.sphere(1, 12));
    this.point = this.mesh({points: [0, 0, 0, 0, 0, 1], faces: [0]});
    this.bodies = [];
    this.lasting = this.meshes.length;
  }
  program(vertex, fragment) {
    const gl = this.gl, program = gl.createProgram();
    for (const [type, source] of [[gl.VERTEX_SHADER, vertex], [gl.FRAGMENT_SHADER, fragment]]) {
      const shader = gl.createShader(type);
      gl.shaderSource(shader, source);
      gl.compileShader(shader);
      gl.attachShader(program, shader);
    }
    gl.linkProgram(program);
    if (!gl.getProgramParameter(program, gl.LINK_STATUS)) throw new Error(`the 3-D view: ${gl.getProgramInfoLog(program)}`);
    const places = {};
    for (let n = 0; n < gl.getProgramParameter(program, gl.ACTIVE_UNIFORMS); n++) {
      const {name} = gl.getActiveUniform(program, n);
      places[name] = gl.getUniformLocation(program, name);
    }
    return {program, places};
  }
  mesh({points, faces}, old) {
    const gl = this.gl, mesh = old ?? {array: gl.createVertexArray(), points: gl.createBuffer(), faces: gl.createBuffer()};
    if (!old) this.meshes.push(mesh);
    gl.bindVertexArray(mesh.array);
    gl.bindBuffer(gl.ARRAY_BUFFER, mesh.points);
    gl.bufferData(gl.ARRAY_BUFFER, points instanceof Float32Array ? points : new Float32Array(points), old ? gl.DYNAMIC_DRAW : gl.STATIC_DRAW);
    if (!old || mesh.count !== faces.length) {
      gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, mesh.faces);
      gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, faces instanceof Uint32Array ? faces : new Uint32Array(faces), gl.STATIC_DRAW);
    }
    for (const [place, offset] of [[0, 0], [1, 12]]) {
      gl.enableVertexAttribArray(place);
      gl.vertexAttribPointer(place, 3, gl.FLOAT, false, 24, offset);
    }
    mesh.count = faces.length;
    return mesh;
  }
  // What does not move; begins anew.
  describe(description) {
    if (description.urdf !== this.description?.urdf) this.camera.points = null;
    this.description = description;
    this.arm = new Arm(description.arm, description.sandbox);
    this.soil = description.sandbox && new Soil(description.sandbox);
    this.state = null;
    this.forceScale = FORCE_SCALE;
    this.ground = description.ground_z_m ?? 0;
    const before = JSON.stringify(this.space);
    this.space = spaceOf(description);
    if (JSON.stringify(this.space) !== before) this.show(this.camera.view);
    if (this.ready) this.build();
    const {arm} = this;
    arm.fetchMeshes().then(found => { if (found && this.arm === arm && this.ready) this.build(); });
  }
  // What the graphics processor has to know; it forgets it with its context.
  build() {
    const {gl, description} = this, {middle, size} = this.space;
    for (const mesh of this.meshes.splice(this.lasting)) { gl.deleteVertexArray(mesh.array); gl.deleteBuffer(mesh.points); gl.deleteBuffer(mesh.faces); }
    this.light = Matrix.times(Matrix.box(.85 * size, .5 * size, 4 * size), Matrix.look(Vector.plus(middle, Vector.times(SUN, 2 * size)), middle, [0, 0, 1]));
    this.bodies = this.arm.bodies.filter(body => body.mesh).map(body => ({...body, mesh: this.mesh(body.mesh)}));
    this.edges = description.sandbox ? this.arm.bodies.filter(body => body.size).map(body => ({...body, mesh: this.mesh(Shapes.edges(body.size))})) : [];
    this.sand = this.skirt = this.arrowMesh = this.safeMesh = undefined;
    if (this.soil) this.soil.changed = true;
    this.fixed = this.rim = this.glass = [];
    if (description.sandbox) this.box(description.sandbox);
    else this.floor = this.slab([middle[0] - 2 * size, middle[1] - 2 * size, this.ground - .02 * size], [middle[0] + 2 * size, middle[1] + 2 * size, this.ground - .002 * size]);
    this.redraw();
  }
  slab(from, to) { return [this.mesh(Shapes.box(Vector.minus(to, from))), Matrix.move(Vector.times(Vector.plus(from, to), .5))]; }
  // The box of the sand and the table of the arm.
  box({x_m, y_m, floor_z_m, top_z_m}) {
    const wide = [x_m[1] - x_m[0], y_m[1] - y_m[0]], slab = this.slab.bind(this);
    const table = slab(...TABLE);
    const tray = slab([x_m[0] - .012, y_m[0] - .012, floor_z_m - .016], [x_m[1] + .012, y_m[1] + .012, floor_z_m - .001]);
    this.fixed = [table, tray];
    this.floor = slab([-1.7, -2, floor_z_m - .022], [2.3, 2, floor_z_m - .0175]);
    // A little outside, or sand and glass would be drawn through each other.
    const [x0, x1] = [x_m[0] - .002, x_m[1] + .002], [y0, y1] = [y_m[0] - .002, y_m[1] + .002];
    this.glass = [[x0, y0, x1, y0], [x1, y0, x1, y1], [x1, y1, x0, y1], [x0, y1, x0, y0]]
      .map(([x, y, u, v]) => this.mesh({points: [x, y, floor_z_m, u, v, floor_z_m, u, v, top_z_m, x, y, top_z_m].reduce((all, value, n) => (all.push(value), n % 3 === 2 && all.push(...Vector.unit([y - v, u - x, 0])), all), []), faces: [0, 1, 2, 0, 2, 3]}));
    const t = .003, rim = [];
    for (const y of y_m) rim.push([[x_m[0], y, top_z_m], [wide[0] + t, t, t], 0]);
    for (const x of x_m) rim.push([[x, y_m[0], top_z_m], [t, wide[1] + t, t], 1]);
    for (const x of x_m) for (const y of y_m) rim.push([[x, y, floor_z_m], [t, t, top_z_m - floor_z_m], 2]);
    this.rim = rim.map(([at, size, axis]) => [this.mesh(Shapes.box(size)), Matrix.move(at.map((v, i) => v + (i === axis ? size[i] / 2 - t / 2 : 0)))]);
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
    const {size: scale, middle} = this.space, links = this.arm.pose(this.arm.values(this.state, this.description.joints));
    this.tip = links[this.description.tip_link]?.slice(12, 15);
    if (this.soil?.changed && this.soil.columns) {
      this.sand = this.mesh(this.soil, this.sand);
      this.skirt = this.mesh(this.soil.skirt(), this.skirt);
      this.soil.changed = false;
    }
    this.fit(links);
    const lens = this.lens(), look = LOOKS[this.look];
    const view = Matrix.times(Matrix.perspective(FOV_DEG * Math.PI / 180, size[0] / size[1], .05 * scale, 12 * scale), Matrix.look(lens.eye, lens.target, lens.up));
    gl.bindFramebuffer(gl.FRAMEBUFFER, this.frame);
    gl.viewport(0, 0, SHADOW_PX, SHADOW_PX);
    gl.enable(gl.DEPTH_TEST);
    gl.depthMask(true);
    if (!level) {
      gl.clear(gl.DEPTH_BUFFER_BIT);
      this.use(this.depth, {view: this.light, light: this.light});
      this.solids(links, look);
      this.earth();
    }
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    gl.viewport(0, 0, ...size);
    gl.clearColor(...look.clear, 1);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    gl.enable(gl.BLEND);
    gl.blendFuncSeparate(gl.SRC_ALPHA, gl.ONE_MINUS_SRC_ALPHA, gl.ZERO, gl.ONE);
    this.use(this.main, {view, light: this.light, eye: lens.eye, sun: SUN, sky: look.sky, ground: look.ground, sunlight: look.sun, shadows: level ? 0 : 1, level: this.ground, space: [middle[0], middle[1], scale]});
    if (lens.eye[2] > this.floor[1][14]) this.put(this.floor[0], this.floor[1], look.floor, KIND.floor);
    this.earth();
    this.buried(links);
    this.solids(links, look);
    this.vectors(links);
    gl.depthMask(false);
    // Who looks closely stands inside the box.
    if (this.camera.view !== 'plate') for (const wall of this.glass) this.put(wall, Matrix.unit(), this.look === 'dark' ? [.6, .75, .85, .06] : [.75, .87, .95, .12], KIND.flat);
    if (this.camera.view !== 'plate') for (const [mesh, place] of this.rim) this.put(mesh, place, look.edge, KIND.flat);
    this.marker(ratio);
    gl.depthMask(true);
    this.note(lens);
  }
  use({program, places}, values) {
    const gl = this.gl;
    gl.useProgram(program);
    this.places = places;
    for (const [name, value] of Object.entries(values)) {
      const place = places[name];
      if (!place) continue;
      if (typeof value === 'number') gl.uniform1f(place, value);
      else if (value.length === 3) gl.uniform3fv(place, value);
      else gl.uniformMatrix4fv(place, false, value);
    }
    gl.activeTexture(gl.TEXTURE0);
    gl.bindTexture(gl.TEXTURE_2D, program === this.main.program ? this.shadow : null);
    if (places.shadow) gl.uniform1i(places.shadow, 0);
  }
  put(mesh, place, colour, kind, gloss = 0, type = this.gl.TRIANGLES) {
    const {gl, places} = this;
    gl.uniformMatrix4fv(places.place, false, place);
    if (places.kind) {
      gl.uniform1i(places.kind, kind);
      gl.uniform4fv(places.colour, colour);
      gl.uniform1f(places.gloss, gloss);
    }
    gl.bindVertexArray(mesh.array);
    gl.drawElements(type, mesh.count, gl.UNSIGNED_INT, 0);
  }
  solids(links, look) {
    for (const slab of this.fixed) this.put(...slab, look.table, KIND.body, .1);
    for (const {link, place, mesh, colour, metal} of this.bodies)
      if (links[link]) this.put(mesh, Matrix.times(links[link], place), colour, KIND.body, metal ? .9 : .35);
    this.skeleton(links);
  }
  earth() {
    if (!this.sand) return;
    this.put(this.sand, Matrix.unit(), [.90, .79, .60, 1], KIND.sand);
    this.put(this.skirt, Matrix.unit(), [.84, .72, .53, 1], KIND.sand);
  }
  // The edges of the plate where sand hides them: behind it, before anything else is drawn.
  buried(links) {
    const {gl} = this;
    gl.depthFunc(gl.GREATER);
    gl.depthMask(false);
    for (const {link, place, mesh} of this.edges) if (links[link]) this.put(mesh, Matrix.times(links[link], place), [.13, .19, .27, .8], KIND.flat, 0, gl.LINES);
    gl.depthMask(true);
    gl.depthFunc(gl.LESS);
  }
  // Bones from link to link, and balls where joints move.
  skeleton(links) {
    const radius = .011 * this.space.size, colour = [.62, .66, .70, 1];
    for (const joint of this.arm.bones) {
      const from = links[joint.parent]?.slice(12, 15), to = links[joint.child]?.slice(12, 15);
      if (!from || !to) continue;
      const way = Vector.minus(to, from), length = Vector.size(way);
      if (length > 1e-4) {
        const z = Vector.times(way, 1 / length), [x, y] = across(z), half = Vector.times(Vector.plus(from, to), .5);
        this.put(this.rod, [...Vector.times(x, radius), 0, ...Vector.times(y, radius), 0, ...way, 0, ...half, 1], colour, KIND.body, .5);
      }
      if (joint.turns || joint.slides)
        this.put(this.ball, Matrix.times(Matrix.move(to), Matrix.scale(Array(3).fill(1.7 * radius))), [.30, .45, .60, 1], KIND.body, .5);
    }
  }
  // Forces of so many N at most are known.
  scaleForces(most_n) {
    if (!this.description.sandbox && most_n > 0) this.forceScale = .3 * this.space.size / most_n;
    this.redraw();
  }
  // An arrow from the end-point along a vector.
  arrow(vector, radius, colour) {
    const length = Vector.size(vector);
    if (length < 1e-3) return;
    const z = Vector.times(vector, 1 / length), [x, y] = across(z), {eye} = this.lens();
    // It begins at the rim of the end-point's disc, which would hide a short one.
    const pixel = 2 * Vector.size(Vector.minus(eye, this.tip)) * Math.tan(FOV_DEG * Math.PI / 360) / this.canvas.clientHeight;
    const from = Vector.plus(this.tip, Vector.times(z, (TIP_PX / 2 + 2) * pixel));
    this.arrowMesh = this.mesh(Shapes.arrow(length, radius * this.space.size), this.arrowMesh);
    this.put(this.arrowMesh, [...x, 0, ...y, 0, ...z, 0, ...from, 1], colour, KIND.sign);
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

// Around all that the arm takes.
function spaceOf({sandbox, space_m}) {
  if (sandbox) return OWN_SPACE;
  const [low, high] = space_m, size = Math.max(Vector.size(Vector.minus(high, low)), .05);
  return {middle: Vector.times(Vector.plus(low, high), .5), size: size / 1.1};
}

// Two directions across a third one.
function across(z) {
  const x = Vector.unit(Vector.cross(Math.abs(z[2]) < .9 ? [0, 0, 1] : [1, 0, 0], z));
  return [x, Vector.cross(z, x)];
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
