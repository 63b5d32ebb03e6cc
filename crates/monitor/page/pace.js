// Draws coarser while pictures take long, and once more in full when nothing moves.
const SLOW_MS = 45, QUICK_MS = 20, STILL_MS = 350, MOST_LEVEL = 2;
class Pace {
  constructor(redraw) { Object.assign(this, {redraw, now: 0, costs: [], hold_ms: 2000, since: 0}); }
  // How coarse the next picture is.
  level() { return this.still ? 0 : this.now; }
  // A picture is under way: the next turn of the browser tells what it cost.
  drawn(begin) {
    const whole = this.still;
    this.still = false;
    clearTimeout(this.timer);
    if (whole) return;
    if (this.now) this.timer = setTimeout(() => { this.still = true; this.redraw(); }, STILL_MS);
    requestAnimationFrame(end => this.cost(end - begin, end));
  }
  cost(ms, now) {
    this.costs.push(ms);
    if (this.costs.length < 5) return;
    const middle = this.costs.sort((a, b) => a - b)[2];
    this.costs = [];
    if (middle > SLOW_MS && this.now < MOST_LEVEL) {
      this.now += 1;
      this.since = now;
      this.hold_ms = Math.min(60000, this.hold_ms * 2);
    } else if (middle < QUICK_MS && this.now > 0 && now - this.since > this.hold_ms) {
      this.now -= 1;
      this.since = now;
    }
  }
}
