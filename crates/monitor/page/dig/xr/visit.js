// A visit to the sandbox with a headset or a phone: a session from its beginning to its end, picture by picture.
import {Grip} from './grip.js';
import {Hands} from './hands.js';
import {Matrix} from './painter.js';
import {Place} from './place.js';
import {Stereo} from './stereo.js';

const NEAR_M = .05, FAR_M = 30, MOST_STEP_S = .1;

// Asks for a session; throws what refuses it. `acts`: what the page does: `says`, `others`, `refused`, `stop`, `dark`, and `left` at the end, which hears
// why if it was not wanted.
export async function visit(mode, page, acts) {
  const session = await navigator.xr.requestSession(mode, {optionalFeatures: ['local-floor', 'hand-tracking']});
  const ended = {yes: false};
  session.addEventListener('end', () => { ended.yes = true; });
  try {
    const painter = new Stereo(document.createElement('canvas'));
    if (!painter.ready) throw new Error('this browser has no WebGL 2');
    await painter.gl.makeXRCompatible();
    const layer = new XRWebGLLayer(session, painter.gl);
    session.updateRenderState({baseLayer: layer, depthNear: NEAR_M, depthFar: FAR_M});
    const floor = await session.requestReferenceSpace('local-floor').catch(() => null), space = floor ?? await session.requestReferenceSpace('local');
    if (ended.yes) throw new Error('the session ended at once');
    return new Visit({session, layer, painter, space, hasFloor: Boolean(floor), page, acts});
  } catch (problem) {
    if (!ended.yes) await session.end().catch(() => {});
    throw problem;
  }
}

class Visit {
  constructor(parts) {
    Object.assign(this, parts, {over: false, placed: false, last: null, scene: null});
    const {session, space, page: {hand}, painter} = this;
    this.grip = new Grip(hand);
    space.addEventListener('reset', () => { this.placed = false; });
    session.addEventListener('end', () => this.end());
    painter.gl.canvas.addEventListener('webglcontextlost', () => {
      if (this.over) return;
      this.why = 'The graphics processor lost the view of the headset; enter again.';
      this.leave();
    });
    session.requestAnimationFrame((time, frame) => this.picture(time, frame));
  }
  leave() { this.session.end().catch(() => {}); }
  end() {
    this.over = true;
    this.hands?.letGo();
    // Frees what it holds; browsers allow only some contexts.
    this.painter.gl.getExtension('WEBGL_lose_context')?.loseContext();
    this.acts.left(this.why);
  }
  // Whether the plate can be led by this page at all.
  may() { return this.page.authorized && this.page.link.connected; }
  patch(message) { this.painter.soil?.patch(message); }
  shake(strong, weak) { this.hands?.shake(strong, weak); }
  // Another session has other soil, but the box stays where it was put.
  describe() {
    const {page, painter, session, space, acts} = this;
    this.scene = page.scene;
    painter.describe(page.scene);
    painter.fill(page.soil);
    if (this.hands) return;
    this.place = new Place(page.scene.sandbox);
    this.hands = new Hands(session, space, this.place, this.grip, {may: () => this.may(), refused: acts.refused, stop: acts.stop, reset: () => { this.placed = false; }});
  }
  picture(time, frame) {
    const {session, page, painter, space} = this;
    if (this.over) return;
    session.requestAnimationFrame((next, later) => this.picture(next, later));
    const seconds = Math.min(MOST_STEP_S, (time - (this.last ?? time)) / 1000), pose = frame.getViewerPose(space);
    this.last = time;
    if (page.scene && page.scene !== this.scene) this.describe();
    // Nobody leads what the headset cannot follow.
    if (!pose || !this.scene) { this.hands?.letGo(); return; }
    const head = pose.transform.matrix;
    if (!this.placed) this.place.before(head);
    this.placed = true;
    this.hands.look(frame, head, painter.tip, seconds);
    page.hand.beat();
    this.show(pose);
  }
  show({views}) {
    const {session, layer, painter, place, hands, page, acts} = this, inBase = place.inverse();
    const eyes = views.map(view => ({viewport: layer.getViewport(view), projection: view.projectionMatrix, inverse: view.transform.inverse.matrix, position: [...view.transform.matrix.slice(12, 15)]})).filter(({viewport}) => viewport);
    if (!eyes.length) return;
    const clear = session.environmentBlendMode !== 'opaque';
    painter.look = acts.dark() ? 'dark' : 'light';
    painter.show({framebuffer: layer.framebuffer, eyes, place, clear, shown: {
      state: page.state, target: page.hand.target ?? acts.others(), says: acts.says(), floor_z_m: this.hasFloor && !clear ? place.toBase([0, 0, 0])[2] : null,
      hands: hands.seen.map(({matrix, grips}) => ({grips, matrix: Matrix.times(inBase, matrix)})),
    }});
  }
}
