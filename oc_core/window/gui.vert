// Panels: from the coordinates of the window to the framebuffer, whose row 0 is the top.
layout(location = 0) in vec2 position;
layout(location = 1) in vec2 textureCoordinate;
layout(location = 2) in vec4 color;
layout(location = 0) uniform vec2 windowOrigin;
layout(location = 1) uniform vec2 windowSize;
layout(location = 0) out vec2 vertexTextureCoordinate;
layout(location = 1) out vec4 vertexColor;

void main() {
  vertexTextureCoordinate = textureCoordinate;
  vertexColor = color;
  gl_Position = vec4((position - windowOrigin) / windowSize * 2 - 1, 0, 1);
}
