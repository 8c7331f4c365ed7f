layout(location = 0) flat in uint triangle;
layout(location = 1) in vec2 weights;
layout(location = 0) out uvec4 fragment;

void main() {
  fragment = packFragment(1.0 / gl_FragCoord.w, triangle, weights);
}
