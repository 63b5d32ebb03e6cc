// What is heard and felt of the force: sound as loud as it fluctuates, vibration too. Both are off until somebody switches them on.
const STATES = 10, FULL_N = 1.5, MOST_GAIN = .3, SHAKE_MS = 150;

export class Sense {
  // `felt` hears what is felt also while the vibration is off.
  constructor(pad, felt) { Object.assign(this, {pad, felt, forces: [], shakes: false, last: 0}); }
  // A force in N, and it as a share of what is allowed.
  feel(force_n, share) {
    this.forces.push(force_n);
    if (this.forces.length > STATES) this.forces.shift();
    const level = this.level();
    if (this.gain) this.gain.gain.setTargetAtTime(MOST_GAIN * level, this.audio.currentTime, .04);
    const now = performance.now();
    if (now - this.last < SHAKE_MS) return;
    this.last = now;
    const strong = Math.min(1, share);
    if (strong < .05 && level < .05) return;
    this.felt(strong, level);
    if (!this.shakes) return;
    this.pad.shake(strong, level);
    navigator.vibrate?.(Math.round(SHAKE_MS * Math.max(level, strong > .9 ? .6 : 0)));
  }
  // How much the force fluctuates: the standard deviation of its changes, 1 at 1.5 N.
  level() {
    const steps = this.forces.slice(1).map((force, k) => force - this.forces[k]);
    if (steps.length < 3) return 0;
    const mean = steps.reduce((a, b) => a + b) / steps.length;
    return Math.min(1, Math.sqrt(steps.reduce((sum, step) => sum + (step - mean) ** 2, 0) / steps.length) * 3 / FULL_N);
  }
  // Sound on or off. Browsers allow it only after somebody has pressed something.
  sound(on) {
    if (!on) { this.audio?.close(); this.audio = this.gain = null; return; }
    const audio = this.audio = new AudioContext(), noise = audio.createBufferSource(), filter = audio.createBiquadFilter();
    const buffer = audio.createBuffer(1, 2 * audio.sampleRate, audio.sampleRate), data = buffer.getChannelData(0);
    for (let k = 0; k < data.length; k++) data[k] = 2 * Math.random() - 1;
    Object.assign(noise, {buffer, loop: true});
    Object.assign(filter, {type: 'lowpass'});
    filter.frequency.value = 900;
    this.gain = audio.createGain();
    this.gain.gain.value = 0;
    noise.connect(filter).connect(this.gain).connect(audio.destination);
    noise.start();
  }
}
