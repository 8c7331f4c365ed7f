// The surface of what sends rays on, with normals that are smooth between its vertices: oc_core/shade/vertex_normals.h.
layout(std430, binding = 2) readonly buffer Normals { float normals[]; };  // three floats a vertex, unit

vec3 normal(uint vertex) {
  return vec3(normals[3u * vertex], normals[3u * vertex + 1u], normals[3u * vertex + 2u]);
}
vec3 between(vec3 a, vec3 b, vec3 c, vec2 weights) {
  return a * (1.0 - weights.x - weights.y) + b * weights.x + c * weights.y;
}

vec3 placeOf(uvec4 fragment) {
  uvec3 v = triangleVertices(fragment.y);
  return between(position(v.x), position(v.y), position(v.z), weightsOf(fragment));
}
// Turned to the side that `incoming` comes from: by the face, whose side is never in doubt.
vec3 normalAt(uvec4 fragment, vec3 incoming) {
  uvec3 v = triangleVertices(fragment.y);
  vec3 face = cross(position(v.y) - position(v.x), position(v.z) - position(v.x));
  vec3 smoothed = between(normal(v.x), normal(v.y), normal(v.z), weightsOf(fragment));
  smoothed = dot(smoothed, smoothed) > 0.0 ? normalize(smoothed) : normalize(face);
  return (dot(face, smoothed) < 0.0) == (dot(face, incoming) > 0.0) ? smoothed : -smoothed;
}
