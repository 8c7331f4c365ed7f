// A straight piece of a ray, and where it meets a triangle: oc_core/depth_rays/straight_ray.h, with the same operations
// in the same order. `precise` keeps compilers from fusing and reordering them. Arrays that a variable indexes hold no
// doubles: some drivers (NVIDIA 580) keep them as floats.
struct StraightRay {
  vec3 origin;
  vec3 step;
  float reach;
};

struct Meeting {
  double share;  // of the step
  uint triangle;
  vec2 weights;  // of the second and third vertex
};

const float kMinStep = 1e-15;

// As castable() of oc_core/render/ray_segment.h. By their bits: compilers may take it that no number is NaN.
bool isBelow(vec3 p, float limit) {
  return all(lessThan(floatBitsToUint(p) & uvec3(0x7fffffffu), uvec3(floatBitsToUint(limit))));
}
bool isCastable(StraightRay ray) {
  return isBelow(ray.origin, 1e18) && isBelow(ray.step, 1e18) && !isBelow(ray.step, kMinStep);
}

double dotInOrder(dvec3 a, dvec3 b) {
  precise double sum = a.x * b.x + a.y * b.y + a.z * b.z;
  return sum;
}
dvec3 crossInOrder(dvec3 a, dvec3 b) {
  precise dvec3 product = dvec3(a.y * b.z - b.y * a.z, a.z * b.x - b.z * a.x, a.x * b.y - b.x * a.y);
  return product;
}

Meeting noMeeting() {
  return Meeting(0.0LF, kNoTriangle, vec2(0));
}

bool comesBefore(Meeting a, Meeting b) {
  return b.triangle == kNoTriangle || a.share < b.share || (a.share == b.share && a.triangle < b.triangle);
}

Meeting meetTriangle(StraightRay ray, vec3 p, vec3 q, vec3 r, uint number) {
  dvec3 origin = dvec3(ray.origin);
  dvec3 step = dvec3(ray.step);
  precise dvec3 a = dvec3(p) - origin;
  precise dvec3 b = dvec3(q) - origin;
  precise dvec3 c = dvec3(r) - origin;
  double wa = dotInOrder(step, crossInOrder(b, c));
  double wb = dotInOrder(step, crossInOrder(c, a));
  double wc = dotInOrder(step, crossInOrder(a, b));
  precise double sum = wa + wb + wc;
  bool inside = (wa >= 0.0LF && wb >= 0.0LF && wc >= 0.0LF) || (wa <= 0.0LF && wb <= 0.0LF && wc <= 0.0LF);
  if (!inside || sum == 0.0LF) {
    return noMeeting();
  }
  precise dvec3 place = (a * wa + b * wb + c * wc) / sum;
  precise double share = dotInOrder(place, step) / dotInOrder(step, step);
  if (!(share >= 0.0LF && share <= double(ray.reach))) {
    return noMeeting();
  }
  precise dvec2 weights = dvec2(wb, wc) / sum;
  return Meeting(share, number, vec2(weights));
}
