// Image points of a pinhole, or of a camera that displaces its image (MODEL of shaders/displaced.glsl; 0 for none).
struct Projected {
  vec2 place;
  float t;  // 0 where the point has no image
};

Projected project(vec3 worldPoint) {
  vec3 p = cameraFromWorld(worldPoint);
  if (!(p.z >= zNear && p.z <= zFar)) {
    return Projected(vec2(0), 0.0);
  }
  vec2 q = imageFromCamera(p);
#if MODEL != 0
  vec2 displaced = distorted(q, p.z);
#if MODEL == SPOC
  // The image of a point on the pole is a circle.
  if (q == pole && displaced != q) {
    return Projected(vec2(0), 0.0);
  }
#endif
  q = displaced;
#endif
  return Projected(q, p.z);
}
