// What WebGL draws of an arm, its box and the soil, for eyes anywhere. Everything is in the base frame, in m.
const FORCE_SCALE = /*FORCE_M_PER_N*/, LEAD_SCALE = /*LEAD_SCALE*/, SHADOW_PX = 1024;
const LOOKS = {
  light: {sky: [.46, .50, .56], ground: [.26, .24, .22], sun: .66, floor: [.88, .89, .90, 1], clear: [.914, .933, .953], table: [.76, .76, .75, 1], edge: [.35, .4, .45, .8]},
  dark: {sky: [.26, .30, .36], ground: [.12, .11, .11], sun: .72, floor: [.15, .17, .19, 1], clear: [.063, .082, .102], table: [.36, .38, .40, 1], edge: [.65, .72, .78, .7]},
};
const SUN = Vector.unit([.42, -.55, .95]);
// The middle of things and how large they are: the arm and its box.
const OWN_SPACE = {middle: [.3, 0, -.1], size: 1};
// Corners of the table that the arm stands on.
const TABLE = [[-.34, -.3, -.035], [.07, .3, 0]];

class Painter {
  constructor(canvas, options) {
    this.gl = canvas.getContext('webgl2', {alpha: false, powerPreference: 'high-performance', ...options});
    this.look = 'light';
    this.space = OWN_SPACE;
  }
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
    this.description = description;
    this.arm = new Arm(description.arm, description.sandbox);
    this.soil = description.sandbox && new Soil(description.sandbox);
    this.state = null;
    this.ground = description.ground_z_m ?? 0;
    this.space = spaceOf(description);
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
  // Matrices of all links in the state, with soil as it is now.
  pose() {
    const links = this.arm.pose(this.arm.values(this.state, this.description.joints));
    this.tip = links[this.description.tip_link]?.slice(12, 15);
    if (this.soil?.changed && this.soil.columns) {
      this.sand = this.mesh(this.soil, this.sand);
      this.skirt = this.mesh(this.soil.skirt(), this.skirt);
      this.soil.changed = false;
    }
    return links;
  }
  // What the sun sees.
  shade(links, look) {
    const gl = this.gl;
    gl.bindFramebuffer(gl.FRAMEBUFFER, this.frame);
    gl.viewport(0, 0, SHADOW_PX, SHADOW_PX);
    gl.enable(gl.DEPTH_TEST);
    gl.depthMask(true);
    gl.clear(gl.DEPTH_BUFFER_BIT);
    this.use(this.depth, {view: this.light, light: this.light});
    this.solids(links, look);
    this.earth();
  }
  // What an eye sees, into the framebuffer that is bound. `closely`: it stands inside the box.
  paint(links, look, {view, eye, shadows, closely}) {
    const {gl, space: {middle, size}} = this;
    gl.enable(gl.DEPTH_TEST);
    gl.enable(gl.BLEND);
    // Where the picture lies over what cameras see, its opacity counts.
    gl.blendFuncSeparate(gl.SRC_ALPHA, gl.ONE_MINUS_SRC_ALPHA, gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
    this.use(this.main, {view, light: this.light, eye, sun: SUN, sky: look.sky, ground: look.ground, sunlight: look.sun, shadows: shadows ? 1 : 0, level: this.ground, space: [middle[0], middle[1], size]});
    this.below(eye, look);
    this.earth();
    this.buried(links);
    this.solids(links, look);
    this.vectors();
    gl.depthMask(false);
    if (!closely) for (const wall of this.glass) this.put(wall, Matrix.unit(), this.look === 'dark' ? [.6, .75, .85, .06] : [.75, .87, .95, .12], KIND.flat);
    if (!closely) for (const [mesh, place] of this.rim) this.put(mesh, place, look.edge, KIND.flat);
    gl.depthMask(true);
  }
  // The floor, seen from above.
  below(eye, look) { if (eye[2] > this.floor[1][14]) this.put(this.floor[0], this.floor[1], look.floor, KIND.floor); }
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
  // An arrow in one colour.
  sign(from, vector, radius, colour) {
    const length = Vector.size(vector);
    if (length < 1e-3) return;
    const z = Vector.times(vector, 1 / length), [x, y] = across(z);
    this.arrowMesh = this.mesh(Shapes.arrow(length, radius * this.space.size), this.arrowMesh);
    this.put(this.arrowMesh, [...x, 0, ...y, 0, ...z, 0, ...from, 1], colour, KIND.sign);
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
