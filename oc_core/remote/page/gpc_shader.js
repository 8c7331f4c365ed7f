// The mapping of gpc_map.js in a shader, in single precision: GLSL for WebGL2, and the uniforms that it takes.
//
// The inverse of a cubic takes kNewtonSteps Newton steps in a bracket. Steps in single precision end about 1e-6 half
// extents from the exact inverse: some 1e-3 pixels of an image 2,000 pixels wide
// (tests/remote_page/page_test.py measures it).
import {GpcMap} from './gpc_map.js';

/// Regions that one image, or the screen, may have here.
export const kMaxZones = 16;
const kNewtonSteps = 12;

/// Functions for a map called `name`, with uniforms `${name}Box` (centre, half extents; pixels), `${name}Shape` (zoom,
/// outer), `${name}C` (coefficients) and `${name}Count`.
export function gpcGlsl(name) {
  return `
uniform int ${name}Count;
uniform highp vec4 ${name}Box[${kMaxZones}];
uniform highp vec2 ${name}Shape[${kMaxZones}];
uniform highp vec4 ${name}C[${kMaxZones}];

highp float ${name}Inverse(highp float f, highp float outer, highp vec4 c) {
  highp float over = f - c.x;
  if (c.w == 0.0) {
    return 1.0 + 2.0 * over / (c.y + sqrt(max(c.y * c.y + 4.0 * c.z * over, 0.0)));
  }
  highp float lower = 0.0;
  highp float upper = outer - 1.0;
  highp float s = upper * over / (outer - c.x);
  for (int i = 0; i < ${kNewtonSteps}; ++i) {
    highp float error = s * (c.y + s * (c.z + s * c.w)) - over;
    if (error > 0.0) {
      upper = s;
    } else {
      lower = s;
    }
    highp float next = s - error / (c.y + s * (2.0 * c.z + s * 3.0 * c.w));
    next = next >= lower && next <= upper ? next : 0.5 * (lower + upper);
    if (abs(next - s) <= 1e-7 * outer) {
      return 1.0 + next;
    }
    s = next;
  }
  return 1.0 + s;
}

highp vec2 ${name}ImageFromPinhole(highp vec2 p) {
  for (int i = 0; i < ${name}Count; ++i) {
    highp vec4 box = ${name}Box[i];
    highp vec2 shape = ${name}Shape[i];
    highp vec2 d = p - box.xy;
    highp vec2 a = abs(d) / box.zw;
    highp float f = max(a.x, a.y);
    if (f < shape.y) {
      return box.xy + d * (f * shape.x <= 1.0 ? shape.x : ${name}Inverse(f, shape.y, ${name}C[i]) / f);
    }
  }
  return p;
}

highp vec2 ${name}PinholeFromImage(highp vec2 p) {
  for (int i = 0; i < ${name}Count; ++i) {
    highp vec4 box = ${name}Box[i];
    highp vec2 shape = ${name}Shape[i];
    highp vec2 d = p - box.xy;
    highp vec2 a = abs(d) / box.zw;
    highp float r = max(a.x, a.y);
    if (r < shape.y) {
      highp vec4 c = ${name}C[i];
      highp float s = r - 1.0;
      return box.xy + d * (r <= 1.0 ? 1.0 / shape.x : (c.x + s * (c.y + s * (c.z + s * c.w))) / r);
    }
  }
  return p;
}
`;
}

/// What the uniforms of a map are. Throws RangeError for more regions than fit.
export function gpcUniforms(map) {
  if (!(map instanceof GpcMap) || map.zones.length > kMaxZones) {
    throw new RangeError(`an image has ${map.zones?.length} regions, and this page draws at most ${kMaxZones}`);
  }
  const box = new Float32Array(4 * kMaxZones);
  const shape = new Float32Array(2 * kMaxZones);
  const c = new Float32Array(4 * kMaxZones);
  map.zones.forEach(({center, half, profile}, i) => {
    box.set([...center, ...half], 4 * i);
    shape.set([profile.zoom, profile.outer], 2 * i);
    c.set(profile.c, 4 * i);
  });
  return {count: map.zones.length, box, shape, c};
}

export function setGpcUniforms(gl, program, name, {count, box, shape, c}) {
  gl.uniform1i(program.at(`${name}Count`), count);
  gl.uniform4fv(program.at(`${name}Box`), box);
  gl.uniform2fv(program.at(`${name}Shape`), shape);
  gl.uniform4fv(program.at(`${name}C`), c);
}
