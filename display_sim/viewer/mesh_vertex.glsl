layout(location = 0) in vec3 position;
layout(location = 1) in vec3 color;
layout(location = 7) uniform float pointPixels;
layout(location = 0) out vec3 surfacePoint;
layout(location = 1) out vec3 surfaceColor;

void main() {
  surfacePoint = position;
  surfaceColor = color;
  gl_Position = clipFromView(viewFromWorld(position));
  gl_PointSize = pointPixels;
}
