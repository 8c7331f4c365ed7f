// What lies in the bend. The share of it that is passed grows along rays: the depth shrinks with it.
layout(location = 0) flat in uint triangle;
layout(location = 1) in vec2 weights;
layout(location = 2) in vec2 heights;
layout(location = 0) out uvec2 sample_;
layout(location = 1) out vec2 weights_;

void main() {
  vec2 across = dFdx(heights);
  vec2 down = dFdy(heights);
  float size = length(before.xyz);
  if (heights.x < -overlapOf(across.x, down.x, size) || heights.y < -overlapOf(across.y, down.y, size)) {
    discard;
  }
  float first = max(heights.x, 0.0);
  gl_FragDepth = 1.0 - 0.999 * (first > 0.0 ? first / (first + max(heights.y, 0.0)) : 0.0);
  sample_ = uvec2(piece, triangle);
  weights_ = weights;
}
