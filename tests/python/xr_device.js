// A headset that is made up for tests: `navigator.xr` by the words of the WebXR Device API, with what throws there thrown here.
// `headset` moves it: `head` and the hands are [position, quaternion] in the room, whose floor is at height 0.
(() => {
  const WIDTH = window.HEADSET_PX ?? 120, REST_MS = 40, HEIGHT = WIDTH, EYES_M = .064, FLOOR_M = 1.6, ASKED = new Set(['viewer', 'local']);
  const headset = window.headset = {modes: ['immersive-vr'], refuse: null, hasFloor: true, head: [[0, 1.6, 0], [0, 0, 0, 1]], tracked: true, sources: [], pulses: [], session: null, frames: 0, blend: 'opaque'};
  const fail = (name, words) => { throw new DOMException(words, name); };
  const transform = ([[x, y, z], [a, b, c, d]]) => new XRRigidTransform({x, y, z}, {x: a, y: b, z: c, w: d});
  const turned = ([x, y, z, w], [a, b, c]) => {
    const [u, v, s] = [2 * (y * c - z * b), 2 * (z * a - x * c), 2 * (x * b - y * a)];
    return [a + w * u + y * s - z * v, b + w * v + z * u - x * s, c + w * s + x * v - y * u];
  };

  class Space extends EventTarget {
    constructor(session, where) { super(); Object.assign(this, {session, where}); }
  }
  // A reference space is `low` below the floor's; hands and head are told in it.
  class Reference extends Space {
    constructor(session, low) { super(session, null); this.low = low; }
  }
  const within = ([[x, y, z], attitude], space) => [[x, y - space.low, z], attitude];

  class View {
    constructor(frame, eye, place, k) {
      Object.assign(this, {frame, eye, k, transform: transform(place)});
      // Fields of view as of a headset: not the same to both sides.
      const near = frame.session.renderState.depthNear, far = frame.session.renderState.depthFar, [l, r] = eye === 'left' ? [-1.05, .9] : [-.9, 1.05], [b, t] = [-1, .95];
      this.projectionMatrix = new Float32Array([2 / (r - l), 0, 0, 0, 0, 2 / (t - b), 0, 0, (r + l) / (r - l), (t + b) / (t - b), (far + near) / (near - far), -1, 0, 0, 2 * far * near / (near - far), 0]);
    }
  }

  class Frame {
    constructor(session) { Object.assign(this, {session, active: true}); }
    check(space) {
      if (!this.active) fail('InvalidStateError', 'the frame is not active');
      if (space.session !== this.session) fail('InvalidStateError', 'the space belongs to another session');
    }
    getViewerPose(space) {
      this.check(space);
      if (!(space instanceof Reference)) throw new TypeError('no reference space');
      if (!headset.tracked) return null;
      const [head, attitude] = within(headset.head, space);
      const eye = side => turned(attitude, [side * EYES_M / 2, 0, 0]).map((v, i) => v + head[i]);
      return {transform: transform([head, attitude]), emulatedPosition: false, views: [['left', -1], ['right', 1]].map(([name, side], k) => new View(this, name, [eye(side), attitude], k))};
    }
    getPose(space, base) {
      this.check(space);
      this.check(base);
      const at = space.where();
      return at && {transform: transform(within(at, base)), emulatedPosition: Boolean(space.source?.guessed)};
    }
  }

  class Session extends EventTarget {
    constructor(mode, features) {
      super();
      Object.assign(this, {mode, features, ended: false, visibilityState: 'visible', environmentBlendMode: headset.blend, calls: new Map(), handle: 0, given: [], inputSources: []});
      this.renderState = {baseLayer: null, depthNear: .1, depthFar: 1000};
      headset.session = this;
      requestAnimationFrame(time => this.tick(time));
    }
    updateRenderState(state) {
      if (this.ended) fail('InvalidStateError', 'the session has ended');
      if (state.baseLayer && state.baseLayer.session !== this) fail('InvalidStateError', 'the layer belongs to another session');
      this.renderState = {...this.renderState, ...state};
    }
    async requestReferenceSpace(kind) {
      if (this.ended) fail('InvalidStateError', 'the session has ended');
      if (!ASKED.has(kind) && !this.features.includes(kind)) fail('NotSupportedError', `${kind} was not asked for`);
      if (kind === 'local-floor' && !headset.hasFloor) fail('NotSupportedError', 'no floor is known');
      return this.space = new Reference(this, kind === 'local' ? FLOOR_M : 0);
    }
    requestAnimationFrame(call) {
      if (this.ended) return 0;
      this.calls.set(this.handle += 1, call);
      return this.handle;
    }
    cancelAnimationFrame(handle) { this.calls.delete(handle); }
    tick(time) {
      if (this.ended) return;
      // Leaves the processor, which paints here, to the session of the arm.
      setTimeout(() => requestAnimationFrame(next => this.tick(next)), REST_MS);
      const layer = this.renderState.baseLayer, calls = [...this.calls.values()];
      if (!layer || !calls.length || this.visibilityState === 'hidden') return;
      this.calls.clear();
      const frame = new Frame(this);
      layer.open();
      for (const call of calls) call(time, frame);
      frame.active = false;
      layer.close();
      headset.frames += 1;
    }
    async end() {
      if (this.ended) fail('InvalidStateError', 'the session has ended already');
      this.ended = true;
      headset.session = null;
      this.tell('end');
    }
    tell(kind, more = {}) { this.dispatchEvent(Object.assign(new Event(kind), {session: this, ...more})); }
  }

  // Its framebuffer can be drawn into while a frame is under way, and is cleared then.
  window.XRWebGLLayer = class {
    constructor(session, gl) {
      if (session.ended) fail('InvalidStateError', 'the session has ended');
      if (gl.isContextLost() || !gl.compatible) fail('InvalidStateError', 'the context is lost or not made compatible');
      Object.assign(this, {session, gl, framebufferWidth: 2 * WIDTH, framebufferHeight: HEIGHT, framebuffer: gl.createFramebuffer(), colour: gl.createTexture(), depth: gl.createRenderbuffer()});
      gl.bindTexture(gl.TEXTURE_2D, this.colour);
      gl.texStorage2D(gl.TEXTURE_2D, 1, gl.RGBA8, 2 * WIDTH, HEIGHT);
      gl.bindRenderbuffer(gl.RENDERBUFFER, this.depth);
      gl.renderbufferStorage(gl.RENDERBUFFER, gl.DEPTH_COMPONENT24, 2 * WIDTH, HEIGHT);
    }
    attach(colour, depth) {
      const {gl} = this, before = gl.getParameter(gl.FRAMEBUFFER_BINDING);
      gl.bindFramebuffer(gl.FRAMEBUFFER, this.framebuffer);
      gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, colour, 0);
      gl.framebufferRenderbuffer(gl.FRAMEBUFFER, gl.DEPTH_ATTACHMENT, gl.RENDERBUFFER, depth);
      return before;
    }
    open() { this.gl.bindFramebuffer(this.gl.FRAMEBUFFER, this.attach(this.colour, this.depth)); }
    close() {
      const {gl} = this;
      if (headset.wanted) {
        const pixels = new Uint8Array(8 * WIDTH * HEIGHT);
        gl.bindFramebuffer(gl.FRAMEBUFFER, this.framebuffer);
        gl.readPixels(0, 0, 2 * WIDTH, HEIGHT, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
        headset.wanted(pixels);
        headset.wanted = null;
      }
      const error = gl.getError();
      if (error && error !== gl.CONTEXT_LOST_WEBGL) console.error(`WebGL says ${error}`);
      gl.bindFramebuffer(gl.FRAMEBUFFER, this.attach(null, null));
    }
    getViewport(view) {
      if (!view.frame.active || view.frame.session !== this.session) fail('InvalidStateError', 'the view is not of a frame under way');
      return {x: view.k * WIDTH, y: 0, width: WIDTH, height: HEIGHT};
    }
  };
  WebGL2RenderingContext.prototype.makeXRCompatible = async function () { this.compatible = true; };

  class System extends EventTarget {
    async isSessionSupported(mode) { return headset.modes.includes(mode); }
    async requestSession(mode, {requiredFeatures = [], optionalFeatures = []} = {}) {
      if (headset.session) fail('InvalidStateError', 'there is a session already');
      if (!navigator.userActivation.isActive) fail('SecurityError', 'nobody pressed anything');
      if (headset.refuse) fail(...headset.refuse);
      if (!headset.modes.includes(mode)) fail('NotSupportedError', `${mode} is not supported`);
      return new Session(mode, [...requiredFeatures, ...optionalFeatures]);
    }
  }
  Object.defineProperty(navigator, 'xr', {value: new System(), configurable: true});

  // A controller; `kind` 'hand' has no gamepad, 'screen' no grip.
  headset.add = (handedness, kind = 'controller') => {
    const {session} = headset, source = {handedness, at: [[0, 1, -.3], [0, 0, 0, 1]], targetRayMode: kind === 'screen' ? 'screen' : 'tracked-pointer', profiles: []};
    const space = () => Object.assign(new Space(session, () => source.at), {source});
    source.targetRaySpace = space();
    source.gripSpace = kind === 'screen' ? null : space();
    if (kind === 'controller') source.gamepad = {
      mapping: 'xr-standard', connected: true, axes: [0, 0, 0, 0], buttons: Array.from({length: 6}, () => ({pressed: false, touched: false, value: 0})),
      hapticActuators: [{pulse: async (value, ms) => { if (!(value >= 0 && value <= 1 && ms > 0)) throw new TypeError('no pulse'); headset.pulses.push({value, force_n: Math.hypot(...window.dig.state.force_rtz_n)}); return true; }}],
    };
    session.inputSources = [...session.inputSources, source];
    session.tell('inputsourceschange', {added: [source], removed: []});
    return session.inputSources.length - 1;
  };
  headset.remove = k => {
    const {session} = headset, [gone] = session.inputSources.splice(k, 1);
    session.tell('inputsourceschange', {added: [], removed: [gone]});
  };
  headset.act = (kind, k) => headset.session.tell(kind, {inputSource: headset.session.inputSources[k]});
  headset.see = state => { headset.session.visibilityState = state; headset.session.tell('visibilitychange'); };
  headset.recentre = () => headset.session.space.dispatchEvent(new Event('reset'));
  // The picture of both eyes, the left one first, rows from below: as base64.
  headset.picture = () => new Promise(done => { headset.wanted = pixels => {
    let text = '';
    for (let k = 0; k < pixels.length; k += 8192) text += String.fromCharCode(...pixels.subarray(k, k + 8192));
    done(btoa(text));
  }; });
})();
