// A gamepad: the left stick in and out, up and down; the right one swings and tilts. It vibrates with the force.
const DEAD = .15, AXES = [['radius', 1], ['z', -1], ['base', -1], ['tool', -1]];

export class Pad {
  constructor(hand, tell) {
    Object.assign(this, {hand, tell, name: ''});
    setInterval(() => this.look(), 33);
  }
  first() { return [...navigator.getGamepads?.() ?? []].find(pad => pad?.connected && pad.axes.length >= 2) ?? null; }
  look() {
    const pad = this.first(), name = pad?.id ?? '';
    if (name !== this.name) { this.name = name; this.tell(name); }
    AXES.forEach(([axis, sign], k) => {
      const value = pad?.axes[k] ?? 0, amount = Math.abs(value) < DEAD ? 0 : sign * value;
      if (amount || this.hand.moves[`pad${k}`]) this.hand.move(axis, amount, `pad${k}`);
    });
  }
  // Strong: how hard the soil pushes; weak: how much that fluctuates. Both 0 to 1.
  shake(strong, weak) { this.first()?.vibrationActuator?.playEffect?.('dual-rumble', {duration: 120, strongMagnitude: strong, weakMagnitude: weak})?.catch?.(() => {}); }
}
