layout(location = 0) in vec2 vertexTextureCoordinate;
layout(location = 1) in vec4 vertexColor;
layout(binding = 0) uniform sampler2D image;
layout(location = 0) out vec4 fragment;

void main() {
  fragment = vertexColor * texture(image, vertexTextureCoordinate);
}
