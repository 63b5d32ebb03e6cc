// The buttons that enter the view of a headset, where the browser has one.
const WAYS = [['vr', 'immersive-vr', 'VR'], ['ar', 'immersive-ar', 'AR']];
const REFUSED = {
  NotSupportedError: 'it lacks what the view needs', NotAllowedError: 'it was not allowed', SecurityError: 'it was not allowed',
  InvalidStateError: 'another view is open there; close it first',
};

export class Entrance {
  // `button` finds what the page has by its id; `acts` is what the page does for a visit.
  constructor(page, button, acts) {
    Object.assign(this, {page, button, acts});
    if (!navigator.xr) return;
    for (const [id, mode] of WAYS) button(id).addEventListener('click', () => this.press(id, mode));
    navigator.xr.addEventListener('devicechange', () => this.look());
    this.look();
  }
  // What there is now; headsets come and go. What the view is made of is fetched before, so that a press is answered at once.
  async look() {
    for (const [id, mode] of WAYS) {
      const is = await navigator.xr.isSessionSupported(mode).catch(() => false);
      if (is) this.visits ??= await import('./visit.js');
      this.button(id).hidden = !is;
    }
    this.button('headset').hidden = WAYS.every(([id]) => this.button(id).hidden);
  }
  async press(id, mode) {
    const {page, acts} = this;
    if (page.visit) { page.visit.leave(); return; }
    if (this.asking) return;
    this.asking = true;
    try {
      page.visit = await this.visits.visit(mode, page, {...acts, left: why => this.left(why)});
      acts.tell('The sandbox stands before you.');
    } catch (problem) {
      acts.tell(`The headset is not entered: ${REFUSED[problem.name] ?? 'something went wrong'} (${problem.message})`, 'bad');
    }
    this.asking = false;
    this.name(id);
  }
  left(why) {
    this.page.visit = null;
    this.name();
    this.acts.tell(why ?? 'Back on the page.', why ? 'bad' : '');
  }
  // What the buttons do now.
  name(open) { for (const [id, , name] of WAYS) this.button(id).textContent = this.page.visit && id === open ? `Leave ${name}` : `Enter ${name}`; }
}
