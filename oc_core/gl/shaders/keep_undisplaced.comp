// A sample of the pinhole's that is not displaced stays where it is, behind nothing but what was drawn nearer.
layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = 0) uniform usampler2D seen;
layout(binding = 0, rgba32ui) uniform uimage2D drawn;

void main() {
  ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(pixel, ivec2(pinholeSize)))) {
    return;
  }
  uvec4 sample_ = texelFetch(seen, pixel, 0);
  uvec4 held = imageLoad(drawn, pixel);
  if (sample_.y != kNoTriangle && (held.y == kNoTriangle || zOf(sample_) < zOf(held))) {
    vec2 at = vec2(pixel) + 0.5;
    if (distorted(at, zOf(sample_)) == at) {
      imageStore(drawn, pixel, sample_);
    }
  }
}
