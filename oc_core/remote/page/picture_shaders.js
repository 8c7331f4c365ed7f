// The shaders that draw pictures from images of general pinholes. Coordinates: pixels from the top left of the screen
// ("screen"), of the pinhole that it stands for where lenses bend it ("pixel"), of an image's reference pinhole
// ("place") and of the image itself ("sample").
import {gpcGlsl} from './gpc_shader.js';

/// Samples of an image, filtered: those that fall on a pixel are averaged, of up to 4 x 4 places, in linear light (of
/// coarser levels where there are more); where there are fewer samples than pixels, between the four around.
const kSampling = `
uniform sampler2D uColor;
uniform vec2 uImageSize;
const float kMaxTaps = 4.0;

vec3 averaged(vec2 at, vec2 dx, vec2 dy) {
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
  return sum / (taps.x * taps.y);
}

vec4 encoded(vec3 linear) {
  vec3 low = linear * 12.92;
  vec3 high = 1.055 * pow(max(linear, 0.0031308), vec3(1.0 / 2.4)) - 0.055;
  return vec4(mix(high, low, vec3(lessThanEqual(linear, vec3(0.0031308)))), 1.0);
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

/// By rays: where the ray of each pixel meets an image (section 5.2.1.4). Pixels beyond its borders are left alone.
const kRays = `
uniform mat3 uCameraFromPixel;
uniform vec3 uCenterFocal;  // of the reference pinhole
uniform float uScreenHeight;
out vec4 color;
${gpcGlsl('screen')}
${gpcGlsl('image')}
${kSampling}
void main() {
  vec2 pixel = screenPinholeFromImage(vec2(gl_FragCoord.x, uScreenHeight - gl_FragCoord.y));
  vec3 ray = uCameraFromPixel * vec3(pixel, 1.0);
  bool isInFront = ray.z > 0.0;
  vec2 place = uCenterFocal.xy + uCenterFocal.z * ray.xy / max(ray.z, 1e-6);
  vec2 at = imageImageFromPinhole(place);
  vec2 dx = dFdx(at);
  vec2 dy = dFdy(at);
  if (!isInFront || any(lessThan(at, vec2(0))) || any(greaterThan(at, uImageSize))) {
    discard;
  }
  color = encoded(averaged(at, dx, dy));
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
uniform vec2 uDepthRange;
${gpcGlsl('screen')}
vec4 warped() {
  vec3 p = uCameraFromPlace * vec3(aSample.xy, 1.0) + aSample.z * uMove;  // times 1/z
  float w = p.z;
  vec2 pixel = uScreenCenterFocal.xy * w + uScreenCenterFocal.z * p.xy;  // times w
  if (w > 1e-7) {
    pixel = screenImageFromPinhole(pixel / w) * w;
  }
  float depth = w - 2.0 * uScreenCenterFocal.w * aSample.z;
  float inRange = mix(uDepthRange.x, uDepthRange.y, 0.5) * w + 0.5 * (uDepthRange.y - uDepthRange.x) * depth;
  return vec4(vec2(2, -2) * pixel / uScreenSize + vec2(-1, 1) * w, inRange, w);
}
`;
const kSurfaceVertex = `
${kWarpedVertex}
out vec2 vPlace;
void main() {
  gl_Position = warped();
  vPlace = aSample.xy;
}
`;
const kSurfaceFragment = `
in vec2 vPlace;
out vec4 color;
${gpcGlsl('image')}
${kSampling}
void main() {
  vec2 at = imageImageFromPinhole(vPlace);
  color = encoded(averaged(clamp(at, vec2(0), uImageSize), dFdx(at), dFdy(at)));
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
${kSampling}
void main() {
  color = encoded(textureLod(uColor, vFarSample / uImageSize, 0.0).rgb);
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
  surface: [kSurfaceVertex, kSurfaceFragment],
  gap: [kGapVertex, kGapFragment],
  nothing: [kWholeScreen, kNothing],
};
