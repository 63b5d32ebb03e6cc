// The hands of a session: controllers, hands that the headset sees, or a finger on the screen. One that is pressed leads the plate, two carry
// the sandbox; sticks move it, too.
import {Vector} from './painter.js';
import {Place} from './place.js';

const DEAD = .2, MOVE_M_S = .5, RAISE_M_S = .3, TURN_RAD_S = 1.2, GROW_PER_S = 1.2;
// Buttons of the mapping `xr-standard`: the stick, and the upper one beside it (B or Y).
const STICK = 3, UPPER = 5;
const PULSE_MS = 160;

export class Hands {
  // `may`: whether the plate can be gripped; `refused` hears that it cannot; `stop` and `reset` are what buttons do.
  constructor(session, space, place, grip, acts) {
    Object.assign(this, {session, space, place, grip, acts, pressed: [], squeezed: new Set(), down: new Map(), reach: new Map(), carried: null, seen: []});
    session.addEventListener('selectstart', ({inputSource}) => this.press(inputSource));
    session.addEventListener('selectend', ({inputSource}) => this.release(inputSource));
    session.addEventListener('squeezestart', ({inputSource}) => this.squeezed.add(inputSource));
    session.addEventListener('squeezeend', ({inputSource}) => this.squeezed.delete(inputSource));
    session.addEventListener('inputsourceschange', ({removed}) => removed.forEach(source => {
      this.release(source);
      this.squeezed.delete(source);
      this.down.delete(source);
    }));
    session.addEventListener('visibilitychange', () => { if (session.visibilityState !== 'visible') this.letGo(); });
  }
  press(source) {
    this.pressed = [...this.pressed.filter(other => other !== source), source];
    if (this.pressed.length > 1) this.grip.drop();
    else if (this.acts.may()) this.grip.take(source);
    else this.acts.refused();
  }
  release(source) {
    this.pressed = this.pressed.filter(other => other !== source);
    this.reach.delete(source);
    if (this.grip.source === source) this.grip.drop();
    this.carried = null;
  }
  letGo() {
    this.grip.drop();
    this.pressed = [];
    this.carried = null;
  }
  // Once a picture: where all hands are, and what they do.
  look(frame, head, tip, seconds) {
    const poses = new Map([...this.session.inputSources].map(source => [source, this.pose(frame, source, tip)]).filter(([, pose]) => pose));
    this.seen = [...poses].filter(([source]) => source.gripSpace).map(([source, {matrix}]) => ({matrix, grips: this.grip.source === source || Boolean(this.carried)}));
    this.hold(poses);
    this.carry(poses);
    for (const source of poses.keys()) if (source.gamepad) this.feel(source, head, seconds);
  }
  // Where a source is; what has no place of its own leads a point on its ray, as far away as the plate was when it was pressed.
  pose(frame, source, tip) {
    const pose = frame.getPose(source.gripSpace ?? source.targetRaySpace, this.space);
    if (!pose) return null;
    const {matrix, orientation: {x, y, z, w}} = pose.transform;
    let point = [...matrix.slice(12, 15)];
    if (!source.gripSpace) {
      if (!this.reach.has(source) && tip && this.pressed.includes(source)) this.reach.set(source, Vector.size(Vector.minus(this.place.toRoom(tip), point)));
      point = Vector.minus(point, Vector.times([...matrix.slice(8, 11)], this.reach.get(source) ?? 0));
    }
    return {matrix, room: point, point: this.place.toBase(point), attitude: [...this.place.turnToBase([x, y, z]), w], guessed: pose.emulatedPosition};
  }
  // The plate follows; a hand that the headset does not see any more lets go.
  hold(poses) {
    const {source} = this.grip, pose = poses.get(source);
    if (!source) return;
    if (!this.grip.from) this.guessed = pose?.guessed;
    if (!pose || !this.acts.may() || (pose.guessed && !this.guessed)) this.grip.drop();
    else this.grip.follow(pose, this.squeezed.has(source));
  }
  carry(poses) {
    if (this.pressed.length < 2) return;
    const points = this.pressed.slice(0, 2).map(source => poses.get(source)?.room);
    if (!points.every(Boolean)) { this.carried = null; return; }
    const {at, turned, scale} = this.place;
    this.carried ??= {at, turned, scale, points};
    this.place.carry(this.carried, points);
  }
  // Sticks and buttons. Nothing moves the sandbox below a plate that is held.
  feel(source, head, seconds) {
    const {axes, buttons, mapping} = source.gamepad;
    if (mapping !== 'xr-standard') return;
    const before = this.down.get(source) ?? [], now = buttons.map(({pressed}) => pressed);
    this.down.set(source, now);
    if (now[UPPER] && !before[UPPER]) this.acts.stop();
    if (this.pressed.length) return;
    if (now[STICK] && !before[STICK]) this.acts.reset();
    const [x, y] = (axes.length > 3 ? axes.slice(2, 4) : axes.slice(0, 2)).map(value => Math.abs(value) < DEAD ? 0 : value * seconds);
    if (!x && !y) return;
    const {place} = this, ahead = Place.ahead(head);
    if (this.squeezed.has(source)) place.grow(Math.exp(-GROW_PER_S * y));
    else if (source.handedness === 'left') place.move(Vector.times([-ahead[2] * x - ahead[0] * y, 0, ahead[0] * x - ahead[2] * y], MOVE_M_S));
    else {
      place.turn(TURN_RAD_S * x);
      place.move([0, -RAISE_M_S * y, 0]);
    }
  }
  // What grips the plate vibrates: strong with the force, weak with how it fluctuates, both 0 to 1.
  shake(strong, weak) {
    const pad = this.grip.source?.gamepad;
    if (!pad) return;
    const answer = pad.hapticActuators?.[0]?.pulse?.(Math.min(1, .8 * strong + .3 * weak), PULSE_MS)
      ?? pad.vibrationActuator?.playEffect?.('dual-rumble', {duration: PULSE_MS, strongMagnitude: strong, weakMagnitude: weak});
    answer?.catch?.(() => {});
  }
}
