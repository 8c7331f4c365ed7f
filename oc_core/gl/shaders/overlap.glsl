// How far beyond a plane samples still belong to a piece of rays: what surfaces that run through both pieces may be
// apart in the image, and what coordinates are rounded by. As oc_core/render/straight_segment.cpp has it.
const float kOverlapPixels = 1.0 / 64.0;
const float kRounding = 1e-6;

// For a height with these derivatives over the image.
float overlapOf(float across, float down, float size) {
  return length(vec2(across, down)) * kOverlapPixels + kRounding * (1.0 + size);
}
