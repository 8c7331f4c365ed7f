// Strictly missing samples (oc_core/ocri/coverage.h): a point of the truth is missing where none of the frame's points at
// the 3x3 pixels around it lies within its reach.
layout(binding = 0) uniform sampler2D truthPoints;
layout(binding = 1) uniform sampler2D framePoints;
layout(location = 0) uniform vec3 viewEye;
layout(location = 3) uniform vec3 viewForward;
layout(location = 7) uniform float reachPerDepth;
layout(location = 0) out uint state;  // as SampleState, but for kMissingThick

void main() {
  ivec2 size = textureSize(framePoints, 0);
  ivec2 at = ivec2(gl_FragCoord.xy);
  vec4 truth = texelFetch(truthPoints, at, 0);
  if (truth.w == 0) {
    state = 0;
    return;
  }
  float reach = reachPerDepth * dot(truth.xyz - viewEye, viewForward);
  state = 2;
  for (int y = max(at.y - 1, 0); y <= min(at.y + 1, size.y - 1); ++y) {
    for (int x = max(at.x - 1, 0); x <= min(at.x + 1, size.x - 1); ++x) {
      vec4 point = texelFetch(framePoints, ivec2(x, y), 0);
      if (point.w > 0 && distance(point.xyz, truth.xyz) <= reach) {
        state = 1;
      }
    }
  }
}
