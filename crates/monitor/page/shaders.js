// One vertex and one fragment program for everything; `kind` tells what is drawn.
const KIND = {body: 0, sand: 1, flat: 2, floor: 3, sign: 4};
const VERTEX = `#version 300 es
layout(location = 0) in vec3 point;
layout(location = 1) in vec3 normal;
uniform mat4 place, view, light;
uniform float dot_px;
out vec3 at, n;
out vec4 in_light;
void main() {
  vec4 world = place * vec4(point, 1.0);
  at = world.xyz;
  n = mat3(place) * normal;
  in_light = light * vec4(at + 0.002 * normalize(n + vec3(0.0, 0.0, 1e-6)), 1.0);
  gl_Position = view * world;
  gl_PointSize = dot_px;
}`;
const FRAGMENT = `#version 300 es
precision highp float;
precision highp sampler2DShadow;
in vec3 at, n;
in vec4 in_light;
uniform int kind;
uniform vec4 colour;
uniform vec3 eye, sun, sky, ground, space;
uniform float level, gloss, sunlight, shadows;
uniform sampler2DShadow shadow;
out vec4 result;
float random(vec2 p) { p = fract(p * vec2(0.1031, 0.1137)); p += dot(p, p.yx + 33.33); return fract((p.x + p.y) * p.x * 7.13); }
float grain(vec2 p) {
  float fine = fwidth(p.x) + fwidth(p.y);
  return (random(floor(p)) - 0.5) * clamp(1.6 - fine, 0.0, 1.0);
}
float lit() {
  if (shadows == 0.0) return 1.0;
  vec3 p = in_light.xyz / in_light.w * 0.5 + 0.5;
  if (p.x < 0.0 || p.x > 1.0 || p.y < 0.0 || p.y > 1.0) return 1.0;
  float sum = 0.0, step = 1.1 / 1024.0;
  for (int i = -1; i <= 1; i += 2) for (int j = -1; j <= 1; j += 2)
    sum += texture(shadow, vec3(p.xy + step * vec2(i, j), p.z - 0.0012));
  return sum * 0.25;
}
vec3 linear(vec3 c) { return pow(c, vec3(2.2)); }
void main() {
  if (kind == 2) {
    if (colour.a < 0.0 && length(gl_PointCoord - 0.5) > 0.5) discard;
    result = vec4(colour.rgb, abs(colour.a)); return;
  }
  if (kind == 4) { result = vec4(colour.rgb * (0.80 + 0.20 * dot(normalize(n), sun)), colour.a); return; }
  vec3 base = linear(colour.rgb), normal = normalize(n), to_eye = normalize(eye - at);
  float alpha = colour.a, shine = gloss;
  if (kind == 3) {
    // Its lower side would shine through where it fades.
    if (normal.z < 0.5) discard;
    vec2 fine = fwidth(at.xy / 0.1) + 1e-4, cell = abs(fract(at.xy / 0.1 - 0.5) - 0.5) / fine;
    base *= 1.0 - 0.10 * (1.0 - min(min(cell.x, cell.y), 1.0)) * (1.0 - smoothstep(0.1, 0.5, max(fine.x, fine.y)));
    alpha = 1.0 - smoothstep(0.9, 1.9, length(at.xy - space.xy) / space.z);
  }
  if (kind == 1) {
    float coarse = grain(at.xy * 900.0 + at.z * 600.0), small = grain(at.xy * 2300.0 + at.zz * 1700.0);
    base *= 1.0 + 0.16 * coarse + 0.14 * small;
    base *= 1.0 + clamp((at.z - level) * 9.0, -0.28, 0.22);
    if (normal.z < 0.1) base *= 0.82 + 0.10 * sin(at.z * 420.0 + 1.5 * sin(at.x * 37.0 + at.y * 31.0)) * 0.5;
  }
  if (kind == 0 && dot(normal, to_eye) < 0.0) normal = -normal;
  float direct = max(dot(normal, sun), 0.0) * lit() * sunlight;
  vec3 light = mix(ground, sky, 0.5 + 0.5 * normal.z) + vec3(1.0, 0.95, 0.86) * direct;
  vec3 c = base * light;
  if (kind != 1) {
    vec3 half_way = normalize(sun + to_eye);
    c += shine * pow(max(dot(normal, half_way), 0.0), 42.0) * (direct > 0.0 ? 1.0 : 0.0);
    c += shine * 0.16 * sky * pow(1.0 - max(dot(normal, to_eye), 0.0), 4.0);
  }
  result = vec4(pow(c, vec3(1.0 / 2.2)), alpha);
}`;
const SHADOW_FRAGMENT = `#version 300 es
precision highp float;
void main() {}`;
