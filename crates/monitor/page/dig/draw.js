// What the pictures share: a pen on a canvas, colours of the style, arrows.

// A pen in CSS pixels, or none while the canvas has no size.
export function penOf(canvas) {
  const ratio = devicePixelRatio || 1, width = canvas.clientWidth, height = canvas.clientHeight;
  if (!width || !height) return null;
  if (canvas.width !== Math.round(width * ratio) || canvas.height !== Math.round(height * ratio)) [canvas.width, canvas.height] = [Math.round(width * ratio), Math.round(height * ratio)];
  const pen = canvas.getContext('2d');
  pen.setTransform(ratio, 0, 0, ratio, 0, 0);
  pen.clearRect(0, 0, width, height);
  pen.font = '11px system-ui, "DejaVu Sans", sans-serif';
  return Object.assign(pen, {width, height});
}

// Colours by their names, as they are now.
export function colours() {
  const style = getComputedStyle(document.documentElement);
  return name => style.getPropertyValue(`--${name}`).trim();
}

export function line(pen, points, colour, width = 1.5, dash = []) {
  pen.strokeStyle = colour;
  pen.lineWidth = width;
  pen.lineJoin = pen.lineCap = 'round';
  pen.setLineDash(dash);
  pen.beginPath();
  points.forEach(([x, y], k) => k ? pen.lineTo(x, y) : pen.moveTo(x, y));
  pen.stroke();
  pen.setLineDash([]);
}

export function fill(pen, points, colour) {
  pen.fillStyle = colour;
  pen.beginPath();
  points.forEach(([x, y], k) => k ? pen.lineTo(x, y) : pen.moveTo(x, y));
  pen.closePath();
  pen.fill();
}

// An arrow; one that is too short for a head is left out.
export function arrow(pen, [x0, y0], [x1, y1], colour, width = 4) {
  const length = Math.hypot(x1 - x0, y1 - y0);
  if (length < 3) return;
  const [u, v] = [(x1 - x0) / length, (y1 - y0) / length], head = Math.min(length, 4 + 2 * width), neck = [x1 - u * head, y1 - v * head];
  line(pen, [[x0, y0], neck], colour, width);
  fill(pen, [[x1, y1], [neck[0] - v * head * .5, neck[1] + u * head * .5], [neck[0] + v * head * .5, neck[1] - u * head * .5]], colour);
}

// Where the hand is.
export function hand(pen, [x, y], colour, grips) {
  pen.strokeStyle = colour;
  pen.lineWidth = 2;
  pen.beginPath();
  pen.arc(x, y, grips ? 9 : 7, 0, 2 * Math.PI);
  pen.stroke();
  line(pen, [[x - 4, y], [x + 4, y]], colour, 1.5);
  line(pen, [[x, y - 4], [x, y + 4]], colour, 1.5);
}

// Words that can be read on anything.
export function words(pen, text, x, y, colour, behind) {
  pen.strokeStyle = behind;
  pen.lineWidth = 3;
  pen.lineJoin = 'round';
  pen.strokeText(text, x, y);
  pen.fillStyle = colour;
  pen.fillText(text, x, y);
}
