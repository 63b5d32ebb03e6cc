// The hand: where it is, whether it grips, and what it tells the session.
// Cylindrical coordinates of the base joint: radius and z in m, base in rad; tool in degrees.
const SEND_MS = 33, MOST_ASKED = 3, BLOCKED_MS = 700;
// How far the hand goes ahead of the plate, in m and degrees, so that it never runs away from a plate that is held back.
const NEAR_M = .004, BRING_MS = 12000;
const LEASH_M = .15, KEY_LEASH_M = .05, LEASH_DEG = 12;
// Speeds of a hand that is moved by keys or sticks.
const SPEED_M_S = .06, TILT_DEG_S = 25, SLOW = .25;

export class Hand {
  // `ready` says whether the plate can be led; `take` makes it so; `refused` hears why it was not.
  constructor(link, ready, take, refused) {
    Object.assign(this, {link, ready, take, refused, target: null, dragged: false, held: false, brought: false, until: 0, moves: {}, slow: false, blocked: 0, number: crypto.getRandomValues(new Uint32Array(1))[0] >>> 1});
    this.last = performance.now();
    setInterval(() => this.tick(), SEND_MS);
  }
  // What the plate may do.
  limit(range) { this.range = range; }
  // Where the plate is, from a state.
  seen(state) {
    this.plate = state.plate && {radius: Math.hypot(state.plate.x_m, state.plate.y_m), base: Math.atan2(state.plate.y_m, state.plate.x_m), z: state.plate.z_m, tool: state.plate.tool_angle_deg};
    if (this.brought && this.plate && this.far() < NEAR_M) this.until = this.brought = 0;
    // A plate that is not there in time is brought no longer.
    if (!this.grips()) Object.assign(this, {target: null, brought: false});
  }
  grips() { return this.dragged || this.held || this.moving() || performance.now() < this.until; }
  moving() { return Object.values(this.moves).some(Boolean); }
  // Takes hold of the plate where it is, if the hand does not hold it yet.
  begin() {
    if (!this.plate) return;
    if (!this.ready()) this.take();
    if (this.brought) Object.assign(this, {brought: false, until: 0, target: null});
    this.target ??= {...this.plate, tool: this.wantedTool ?? this.plate.tool};
  }
  drag(place) {
    this.dragged = true;
    this.begin();
    if (this.target) { Object.assign(this.target, place); this.bound(LEASH_M); }
  }
  drop() { this.dragged = false; }
  // Leads the plate to a place, unless somebody takes it on the way.
  bring(place) {
    if (!this.plate || this.grips()) return;
    this.target = {...place};
    this.until = performance.now() + BRING_MS;
    this.brought = true;
  }
  // How far the hand is from the plate, in m.
  far() { return Math.hypot(this.target.radius - this.plate.radius, (this.target.base - this.plate.base) * this.plate.radius, this.target.z - this.plate.z); }
  hold(on) { this.held = on; if (on) this.begin(); }
  letGo() { Object.assign(this, {dragged: false, held: false, brought: false, until: 0, moves: {}}); }
  // A direction of motion by keys or sticks, -1 to 1; 0 ends it, a little later so that a tap is felt.
  move(axis, amount, who = axis) {
    this.moves[who] = amount ? {axis, amount} : null;
    if (amount) { this.begin(); this.until = Math.max(this.until, performance.now() + 150); }
  }
  tilt(tool) {
    this.wantedTool = tool;
    this.begin();
    if (this.target) this.target.tool = tool;
    this.until = Math.max(this.until, performance.now() + 4000);
  }
  // Within what is allowed, and not too far ahead of the plate.
  bound(leash) {
    const {target, plate, range} = this, clamp = (value, [low, high]) => Math.max(low, Math.min(high, value));
    if (range) {
      target.radius = clamp(target.radius, range.radius_m);
      target.z = clamp(target.z, range.height_m);
      target.base = clamp(target.base, range.base_deg.map(deg => deg * Math.PI / 180));
    }
    target.tool = clamp(target.tool, [45, 135]);
    if (!plate) return;
    const way = [target.radius - plate.radius, (target.base - plate.base) * plate.radius, target.z - plate.z], far = Math.hypot(...way);
    if (far > leash) {
      const share = leash / far;
      target.radius = plate.radius + way[0] * share;
      target.base = plate.base + way[1] * share / plate.radius;
      target.z = plate.z + way[2] * share;
    }
  }
  // Timers may rest while a headset shows the page; its pictures tick for them then.
  beat() { if (performance.now() - this.last >= SEND_MS) this.tick(); }
  tick() {
    const now = performance.now(), dt = Math.min(.1, (now - this.last) / 1000);
    this.last = now;
    if (!this.grips() || !this.target) return;
    if (this.moving()) {
      const speed = SPEED_M_S * (this.slow ? SLOW : 1), {target} = this;
      for (const move of Object.values(this.moves)) {
        if (!move) continue;
        const way = move.amount * speed * dt;
        if (move.axis === 'radius') target.radius += way;
        else if (move.axis === 'z') target.z += way;
        else if (move.axis === 'base') target.base += way / Math.max(.1, target.radius);
        else {
          const [low, high] = [this.plate.tool - LEASH_DEG, this.plate.tool + LEASH_DEG];
          target.tool = Math.max(low, Math.min(high, target.tool + move.amount * TILT_DEG_S * (this.slow ? SLOW : 1) * dt));
          this.wantedTool = target.tool;
        }
      }
      this.bound(KEY_LEASH_M);
    }
    if (this.ready() && now >= this.blocked && this.link.asked.size < MOST_ASKED) this.say();
  }
  say() {
    const {radius, base, z, tool} = this.target;
    this.link.command({name: 'follow', hand: this.number, x_m: radius * Math.cos(base), y_m: radius * Math.sin(base), z_m: z, tool_angle_deg: tool}, answer => {
      if (answer.type !== 'error') return;
      this.blocked = performance.now() + BLOCKED_MS;
      this.refused(answer);
    });
  }
}
