// Mouse, finger and keys.
const NEAR_PX = 48;
const KEYS = {ArrowLeft: ['radius', -1], ArrowRight: ['radius', 1], ArrowUp: ['z', 1], ArrowDown: ['z', -1], a: ['base', 1], d: ['base', -1], q: ['tool', -1], e: ['tool', 1]};

// Lets a picture be dragged in. The plate is dragged by where it is touched, if that is near it; else the hand goes where the pointer is.
export function dragIn(canvas, picture, hand, stage, plate) {
  let held = null, offset = [0, 0];
  const at = event => {
    const box = canvas.getBoundingClientRect();
    return [event.clientX - box.left, event.clientY - box.top];
  };
  const drag = event => {
    const [x, y] = at(event);
    hand.drag(picture.place(x + offset[0], y + offset[1]));
  };
  canvas.addEventListener('pointerdown', event => {
    if (held !== null || event.button !== 0 || !picture.to || !plate()) return;
    held = event.pointerId;
    canvas.setPointerCapture(held);
    canvas.dataset.grips = '';
    stage.focus({preventScroll: true});
    const tip = picture.tip(plate()), [x, y] = at(event);
    offset = tip && Math.hypot(tip[0] - x, tip[1] - y) < NEAR_PX ? [tip[0] - x, tip[1] - y] : [0, 0];
    drag(event);
  });
  canvas.addEventListener('pointermove', event => { if (event.pointerId === held) drag(event); });
  for (const kind of ['pointerup', 'pointercancel', 'lostpointercapture']) canvas.addEventListener(kind, event => {
    if (event.pointerId !== held) return;
    held = null;
    delete canvas.dataset.grips;
    hand.drop();
  });
}

// Keys, while the stage has the focus. `other` takes those that do not move the plate; it says whether it did.
export function keysOn(stage, hand, other) {
  const name = event => event.key.length === 1 ? event.key.toLowerCase() : event.key;
  stage.addEventListener('keydown', event => {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    hand.slow = event.shiftKey;
    const key = name(event), move = KEYS[key];
    if (move) hand.move(...move, key);
    else if (!other(key)) return;
    event.preventDefault();
  });
  stage.addEventListener('keyup', event => {
    hand.slow = event.shiftKey;
    const move = KEYS[name(event)];
    if (move) hand.move(move[0], 0, name(event));
  });
  // Keys that are up somewhere else are not heard here.
  const stop = () => { for (const key of Object.keys(KEYS)) hand.move(KEYS[key][0], 0, key); };
  stage.addEventListener('blur', stop);
  addEventListener('blur', stop);
}
