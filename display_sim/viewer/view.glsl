// A pinhole's view (pane_draw.h sets it). Row 0 of what is drawn is the top of the image.
layout(location = 0) uniform vec3 viewEye;
layout(location = 1) uniform vec3 viewRight;
layout(location = 2) uniform vec3 viewDown;
layout(location = 3) uniform vec3 viewForward;
layout(location = 4) uniform vec2 viewScale;   // from tangents to the image, whose borders are at -1 and 1
layout(location = 5) uniform vec2 viewCenter;  // where the view direction meets it
layout(location = 6) uniform vec2 viewRange;   // depths that are drawn

// (right, down, forward) from the eye.
vec3 viewFromWorld(vec3 point) {
  vec3 p = point - viewEye;
  return vec3(dot(p, viewRight), dot(p, viewDown), dot(p, viewForward));
}

vec4 clipFromView(vec3 p) {
  float depth = (p.z * (viewRange.y + viewRange.x) - 2 * viewRange.y * viewRange.x) / (viewRange.y - viewRange.x);
  return vec4(viewScale * p.xy + viewCenter * p.z, depth, p.z);
}
