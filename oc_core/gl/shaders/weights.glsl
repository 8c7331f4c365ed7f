// Where on a triangle a point of the pinhole's image lies: barycentric weights of its corners, in camera coordinates.

// Corners are moved to the grid on which the CPU's rasteriser fills, 1/256 pixel, so that both interpolate alike.
vec2 snapped(vec2 q) {
  return roundEven(q * 256.0) / 256.0;
}
float planarCross(vec2 a, vec2 b) {
  return a.x * b.y - a.y * b.x;
}
float largest(vec2 v) {
  return max(abs(v.x), abs(v.y));
}

// Of a triangle without area on that grid, any point is as good.
vec3 normalized(vec3 weights) {
  float sum = weights.x + weights.y + weights.z;
  return sum > 0.0 ? weights / sum : vec3(1.0 / 3.0);
}

vec3 weightsAt(vec3 a, vec3 b, vec3 c, vec2 at) {
  vec3 weights;  // times 1/z at the corner: linear over the image
  bool inFront = min(a.z, min(b.z, c.z)) >= zNear;
  vec2 qa = vec2(0);
  vec2 qb = vec2(0);
  vec2 qc = vec2(0);
  if (inFront) {
    qa = snapped(imageFromCamera(a)) - at;
    qb = snapped(imageFromCamera(b)) - at;
    qc = snapped(imageFromCamera(c)) - at;
  }
  if (inFront && max(largest(qa), max(largest(qb), largest(qc))) < 8192.0) {
    weights = vec3(planarCross(qb, qc), planarCross(qc, qa), planarCross(qa, qb));
    // What rounding leaves outside of the triangle is on its border.
    float area = weights.x + weights.y + weights.z;
    weights = max(weights / area, 0.0) / vec3(a.z, b.z, c.z);
  } else {
    vec3 ray = vec3((at - center) / focal, 1.0);
    weights = vec3(dot(cross(b, c), ray), dot(cross(c, a), ray), dot(cross(a, b), ray));
    // Their sum has the sign of the side that is seen; a weight of the other sign is rounding.
    weights = max(weights * sign(weights.x + weights.y + weights.z), 0.0);
  }
  return normalized(weights);
}

// The same for corners given as image coordinates times their weights, and the weights, of any projection: weights of
// corners in space.
vec3 weightsOfImages(vec3 a, vec3 b, vec3 c, vec2 at) {
  vec3 weights;
  bool inFront = min(a.z, min(b.z, c.z)) > 0.0;
  vec2 qa = vec2(0);
  vec2 qb = vec2(0);
  vec2 qc = vec2(0);
  if (inFront) {
    qa = snapped(a.xy / a.z) - at;
    qb = snapped(b.xy / b.z) - at;
    qc = snapped(c.xy / c.z) - at;
  }
  if (inFront && max(largest(qa), max(largest(qb), largest(qc))) < 8192.0) {
    weights = vec3(planarCross(qb, qc), planarCross(qc, qa), planarCross(qa, qb));
    float area = weights.x + weights.y + weights.z;
    weights = max(weights / area, 0.0) / vec3(a.z, b.z, c.z);
  } else {
    vec3 ray = vec3(at, 1.0);
    weights = vec3(dot(cross(b, c), ray), dot(cross(c, a), ray), dot(cross(a, b), ray));
    weights = max(weights * sign(weights.x + weights.y + weights.z), 0.0);
  }
  return normalized(weights);
}
