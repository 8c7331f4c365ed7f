layout(location = 0) in vec3 surfacePoint;
layout(location = 1) in vec3 surfaceColor;
layout(location = 0) out vec4 shownColor;
layout(location = 1) out vec4 shownPoint;  // world, w = 1: what the frame shows there

void main() {
  shownColor = vec4(srgbFromLinear(surfaceColor), 1);
  shownPoint = vec4(surfacePoint, 1);
}
