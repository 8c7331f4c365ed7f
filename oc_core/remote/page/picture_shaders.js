// The shaders that draw pictures from images of general pinholes. Coordinates: pixels from the top left of the screen
// ("screen"), of the pinhole that it stands for where lenses bend it ("pixel"), of an image's reference pinhole
// ("place") and of the image itself ("sample").
import {gpcGlsl} from './gpc_shader.js';

const kImage = `
uniform sampler2D uColor;
uniform vec2 uImageSize;
`;

/// Samples of an image, filtered: those that fall on a pixel are averaged, of up to 4 x 4 places, in linear light (of
/// coarser levels where there are more); where there are fewer samples than pixels, between the four around.
const kFine = `
${kImage}
const float kMaxTaps = 4.0;

vec4 colorOf(vec2 at) {
  vec2 dx = dFdx(at);
  vec2 dy = dFdy(at);
  vec2 steps = vec2(length(dx), length(dy));
  vec2 taps = clamp(ceil(steps - 1e-3), 1.0, kMaxTaps);
  vec2 each = steps / taps;
  float level = max(0.0, log2(max(max(each.x, each.y), 1e-6)));
  vec3 sum = vec3(0);
  for (float j = 0.0; j < taps.y; ++j) {
    for (float i = 0.0; i < taps.x; ++i) {
      vec2 p = at + dx * ((i + 0.5) / taps.x - 0.5) + dy * ((j + 0.5) / taps.y - 0.5);
      sum += textureLod(uColor, p / uImageSize, level).rgb;
    }
  }
  vec3 linear = sum / (taps.x * taps.y);
  vec3 high = 1.055 * pow(max(linear, 0.0031308), vec3(1.0 / 2.4)) - 0.055;
  return vec4(mix(high, linear * 12.92, vec3(lessThanEqual(linear, vec3(0.0031308)))), 1.0);
}
`;
/// One place of the level of its size, and sRGB by square roots, within a grey level of 255: a fifth of the time where
/// the CPU draws.
const kQuick = `
${kImage}
vec4 colorOf(vec2 at) {
  vec3 linear = texture(uColor, at / uImageSize).rgb;
  vec3 root = sqrt(linear);
  vec3 fourth = sqrt(root);
  return vec4(0.6620027 * root + 0.6841221 * fourth - 0.3235836 * sqrt(fourth) - 0.0225411 * linear, 1.0);
}
`;

/// A triangle over the whole screen.
const kWholeScreen = `
uniform float uDepth;
void main() {
  vec2 corner = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);
  gl_Position = vec4(corner, uDepth, 1.0);
}
`;

/// Where the ray of a pixel meets an image (section 5.2.1.4); beyond its borders where it does not.
const kPlaceOfPixel = `
uniform mat3 uCameraFromPixel;
uniform vec3 uCenterFocal;  // of the reference pinhole
${gpcGlsl('screen')}
${gpcGlsl('image')}
vec2 placeOf(vec2 screen) {
  vec3 ray = uCameraFromPixel * vec3(screenPinholeFromImage(screen), 1.0);
  return ray.z > 1e-4 ? imageImageFromPinhole(uCenterFocal.xy + uCenterFocal.z * ray.xy / ray.z) : vec2(-1e4);
}
`;
/// Pixels beyond the borders of the image are left alone.
const kWithin = `
void leaveBeyond(vec2 at, vec2 size) {
  if (any(lessThan(at, vec2(0))) || any(greaterThan(at, size))) {
    discard;
  }
}
`;
const kRays = `
uniform float uScreenHeight;
out vec4 color;
${kPlaceOfPixel}
${kFine}
${kWithin}
void main() {
  vec2 at = placeOf(vec2(gl_FragCoord.x, uScreenHeight - gl_FragCoord.y));
  color = colorOf(at);
  leaveBeyond(at, uImageSize);
}
`;
/// The same at the corners of squares of the screen, and between these linearly.
const kGridVertex = `
uniform float uDepth;
uniform vec2 uScreenSize;
uniform vec2 uGrid;  // squares in a row, and their side
out vec2 vAt;
${kPlaceOfPixel}
void main() {
  float row = floor((float(gl_VertexID) + 0.5) / (uGrid.x + 1.0));
  vec2 screen = uGrid.y * vec2(float(gl_VertexID) - row * (uGrid.x + 1.0), row);
  vAt = placeOf(screen);
  gl_Position = vec4(vec2(2, -2) * screen / uScreenSize + vec2(-1, 1), uDepth, 1.0);
}
`;
const kGridFragment = `
in vec2 vAt;
out vec4 color;
${kQuick}
${kWithin}
void main() {
  color = colorOf(vAt);
  leaveBeyond(vAt, uImageSize);
}
`;

/// By depth: samples as points (place, 1/z) of the reference pinhole, 1/z = 0 at infinity. Clip coordinates are linear
/// in these, so places interpolate exactly over a plane.
const kWarpedVertex = `
layout(location = 0) in vec3 aSample;  // place, 1/z
uniform mat3 uCameraFromPlace;  // rotation from the place to the screen's camera
uniform vec3 uMove;             // the reference eye in that camera
uniform vec4 uScreenCenterFocal;  // centre, focal length, nearest distance
uniform vec2 uScreenSize;
uniform vec3 uDepthRange;  // nearest, farthest; of what lies at infinity
${gpcGlsl('screen')}
vec4 warped() {
  vec3 p = uCameraFromPlace * vec3(aSample.xy, 1.0) + aSample.z * uMove;  // times 1/z
  float w = p.z;
  vec2 pixel = uScreenCenterFocal.xy * w + uScreenCenterFocal.z * p.xy;  // times w
  if (w > 1e-7) {
    pixel = screenImageFromPinhole(pixel / w) * w;
  }
  float share = w - uScreenCenterFocal.w * aSample.z;  // times w: 0 at the nearest distance, 1 at infinity
  float inRange = aSample.z == 0.0 ? uDepthRange.z * w : uDepthRange.x * w + (uDepthRange.y - uDepthRange.x) * share;
  return vec4(vec2(2, -2) * pixel / uScreenSize + vec2(-1, 1) * w, inRange, w);
}
`;
const kSurfaceVertex = `
${kWarpedVertex}
layout(location = 1) in vec2 aAt;  // of the image, pixels
out vec2 vAt;
void main() {
  gl_Position = warped();
  vAt = aAt;
}
`;
const surfaceFragment = (filter) => `
in vec2 vAt;
out vec4 color;
${filter}
void main() {
  color = colorOf(vAt);
}
`;
/// Where surfaces tear, the gap takes the colour of the farther side, and lies behind all surfaces.
const kGapVertex = `
${kWarpedVertex}
layout(location = 1) in vec2 aFarSample;  // of the image, pixels
flat out vec2 vFarSample;
void main() {
  gl_Position = warped();
  vFarSample = aFarSample;
}
`;
const kGapFragment = `
flat in vec2 vFarSample;
out vec4 color;
${kQuick}
void main() {
  color = colorOf(vFarSample);
}
`;

/// What no image holds: stripes, so that it is not taken for part of the scene.
const kNothing = `
out vec4 color;
void main() {
  float stripe = step(8.0, mod(gl_FragCoord.x + gl_FragCoord.y, 16.0));
  color = vec4(mix(vec3(0.078, 0.090, 0.102), vec3(0.125, 0.141, 0.157), stripe), 1.0);
}
`;

/// Vertex and fragment shader of each program.
export const pictureShaders = {
  rays: [kWholeScreen, kRays],
  grid: [kGridVertex, kGridFragment],
  surface: [kSurfaceVertex, surfaceFragment(kFine)],
  quickSurface: [kSurfaceVertex, surfaceFragment(kQuick)],
  gap: [kGapVertex, kGapFragment],
  nothing: [kWholeScreen, kNothing],
};
