// The board beside the sandbox: force, depth, what holds the arm back, and what is wrong, in words.
import {Matrix, Vector} from './painter.js';
import {colours} from '../draw.js';
import {number} from '../words.js';

const WIDTH_PX = 768, HEIGHT_PX = 440, WIDTH_M = .3, FONT = 'system-ui, "DejaVu Sans", sans-serif';
// To the right of the sand as one looks at it, above it, in m.
const ASIDE_M = .4, ABOVE_M = .17;
const VERTEX = `#version 300 es
layout(location = 0) in vec3 point;
layout(location = 1) in vec3 normal;
uniform mat4 place, view;
out vec2 at;
void main() { at = normal.xy; gl_Position = view * place * vec4(point, 1.0); }`;
const FRAGMENT = `#version 300 es
precision highp float;
in vec2 at;
uniform sampler2D words;
out vec4 result;
void main() { result = texture(words, at); }`;

export class Board {
  constructor(painter) {
    const {gl} = painter, canvas = Object.assign(document.createElement('canvas'), {width: WIDTH_PX, height: HEIGHT_PX});
    const half = WIDTH_M / 2, high = half * HEIGHT_PX / WIDTH_PX;
    Object.assign(this, {painter, pen: canvas.getContext('2d'), shown: '', texture: gl.createTexture(), program: painter.program(VERTEX, FRAGMENT)});
    // Texture coordinates stand where other bodies have normals.
    this.mesh = painter.mesh({points: [-half, -high, 0, 0, 1, 0, half, -high, 0, 1, 1, 0, half, high, 0, 1, 0, 0, -half, high, 0, 0, 0, 0], faces: [0, 1, 2, 0, 2, 3]});
    painter.lasting = painter.meshes.length;
  }
  // Writes what is to be read, if it has changed.
  write(says) {
    const text = JSON.stringify(says), {gl} = this.painter;
    if (text === this.shown) return;
    this.shown = text;
    this.draw(says);
    gl.bindTexture(gl.TEXTURE_2D, this.texture);
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA, gl.RGBA, gl.UNSIGNED_BYTE, this.pen.canvas);
    gl.generateMipmap(gl.TEXTURE_2D);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.LINEAR_MIPMAP_LINEAR);
    for (const side of [gl.TEXTURE_WRAP_S, gl.TEXTURE_WRAP_T]) gl.texParameteri(gl.TEXTURE_2D, side, gl.CLAMP_TO_EDGE);
  }
  draw({force_n, load, depth_m, tool_deg, held, warning, soil}) {
    const {pen} = this, colour = colours(), put = (text, x, y, size, name, bold = '') => {
      pen.font = `${bold} ${size}px ${FONT}`;
      pen.fillStyle = colour(name);
      pen.fillText(text, x, y);
    };
    pen.clearRect(0, 0, WIDTH_PX, HEIGHT_PX);
    pen.fillStyle = colour('panel');
    pen.beginPath();
    pen.roundRect(4, 4, WIDTH_PX - 8, HEIGHT_PX - 8, 28);
    pen.fill();
    pen.lineWidth = 4;
    pen.strokeStyle = colour('line');
    pen.stroke();
    put('Force of the soil', 40, 62, 32, 'faint');
    put(number(force_n, 1, 'N'), 40, 158, 100, 'ink', '650');
    put('depth', 480, 62, 32, 'faint');
    put(number(depth_m === null ? null : 1000 * Math.max(0, depth_m), 0, 'mm'), 480, 110, 48, 'ink', '600');
    put(`tool angle ${number(tool_deg, 0, '°')}`, 480, 158, 32, 'faint');
    pen.fillStyle = colour('grid');
    pen.fillRect(40, 188, WIDTH_PX - 80, 22);
    pen.fillStyle = colour(load > .9 ? 'bad' : load > .5 ? 'warn' : 'good');
    pen.fillRect(40, 188, (WIDTH_PX - 80) * Math.min(1, load), 22);
    const [name, said] = warning ? ['bad', warning] : held ? ['warn', held] : ['faint', soil];
    lines(pen, said, WIDTH_PX - 80, 4).forEach((line, k) => put(line, 40, 268 + 42 * k, 34, name, warning || held ? '600' : ''));
  }
  // Upright, towards an eye of the base frame; it keeps its size however the sandbox is scaled.
  hang({middle, scale}, eye) {
    const out = Vector.unit([eye[0] - middle[0], eye[1] - middle[1], 0]), right = [-out[1], out[0], 0];
    this.at = Vector.plus(middle, Vector.plus(Vector.times(right, ASIDE_M), [0, 0, ABOVE_M]));
    const z = Vector.unit(Vector.minus(eye, this.at)), x = Vector.unit(Vector.cross([0, 0, 1], z)), y = Vector.cross(z, x), size = 1 / scale;
    this.place = Matrix.times([...x, 0, ...y, 0, ...z, 0, ...this.at, 1], Matrix.scale([size, size, size]));
  }
  put(view) {
    const {painter, painter: {gl}} = this;
    painter.use(this.program, {view});
    gl.bindTexture(gl.TEXTURE_2D, this.texture);
    painter.put(this.mesh, this.place);
  }
}

// Words in lines that are no wider than this, in the pen's largest type here.
function lines(pen, text, width_px, most) {
  pen.font = `600 34px ${FONT}`;
  const all = [''];
  for (const word of text.split(/\s+/)) {
    const longer = `${all.at(-1)} ${word}`.trim();
    if (pen.measureText(longer).width <= width_px) all[all.length - 1] = longer;
    else all.push(word);
  }
  return all.length > most ? [...all.slice(0, most - 1), `${all[most - 1]} …`] : all;
}
