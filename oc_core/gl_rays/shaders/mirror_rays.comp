// The ray that goes on from the mirror at each pixel: the view ray reflected about the interpolated normal, as
// oc_core/shade/secondary_rays.h has it; and the colour of what stands before mirrors, or beside them.
layout(local_size_x = 8, local_size_y = 8) in;
layout(std430, binding = 2) readonly buffer MirrorNormals { float normals[]; };
layout(std430, binding = 3) readonly buffer DirectTriangles { uint directTriangles[]; };
layout(std430, binding = 4) readonly buffer DirectColors { float directColors[]; };
layout(binding = 0) uniform usampler2D direct;   // what a picture without mirrors shows
layout(binding = 1) uniform usampler2D mirrors;  // what a picture of mirrors alone shows
layout(binding = 0, rgba32f) writeonly uniform image2D rayOrigins;
layout(binding = 1, rgba32f) writeonly uniform image2D raySteps;  // 0 where no mirror is seen
layout(binding = 2, rgba32f) writeonly uniform image2D picture;
layout(location = 0) uniform vec3 background;
layout(location = 1) uniform float reach;  // of rays, world units

vec3 normal(uint vertex) {
  return vec3(normals[3u * vertex], normals[3u * vertex + 1u], normals[3u * vertex + 2u]);
}
vec3 directColor(uint corner) {
  uint vertex = 3u * directTriangles[corner];
  return vec3(directColors[vertex], directColors[vertex + 1u], directColors[vertex + 2u]);
}
vec3 between(vec3 a, vec3 b, vec3 c, vec2 weights) {
  return a * (1.0 - weights.x - weights.y) + b * weights.x + c * weights.y;
}

// Turned to the side that `incoming` comes from: by the face, whose side is never in doubt.
vec3 normalAt(uvec3 v, vec2 weights, vec3 incoming) {
  vec3 face = cross(position(v.y) - position(v.x), position(v.z) - position(v.x));
  vec3 smoothed = between(normal(v.x), normal(v.y), normal(v.z), weights);
  smoothed = dot(smoothed, smoothed) > 0.0 ? normalize(smoothed) : normalize(face);
  return dot(face, smoothed) < 0.0 == dot(face, incoming) > 0.0 ? smoothed : -smoothed;
}

void main() {
  ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(pixel, imageSize(picture)))) {
    return;
  }
  uvec4 seen = texelFetch(direct, pixel, 0);
  uvec4 mirror = texelFetch(mirrors, pixel, 0);
  bool isMirror = mirror.y != kNoTriangle && (seen.y == kNoTriangle || zOf(mirror) < zOf(seen));
  vec4 origin = vec4(0);
  vec4 step = vec4(0);
  vec3 color = background;
  if (isMirror) {
    vec2 offset = (vec2(pixel) + 0.5 - center) / focal;
    vec3 incoming = normalize(right * offset.x + down * offset.y + forward);
    uvec3 v = triangleVertices(mirror.y);
    vec3 at = between(position(v.x), position(v.y), position(v.z), weightsOf(mirror));
    vec3 outgoing = normalize(reflect(incoming, normalAt(v, weightsOf(mirror), incoming)));
    origin = vec4(at, 1);
    step = vec4(outgoing * reach, 0);
  } else if (seen.y != kNoTriangle) {
    color = between(directColor(3u * seen.y), directColor(3u * seen.y + 1u), directColor(3u * seen.y + 2u),
                    weightsOf(seen));
  }
  imageStore(rayOrigins, pixel, origin);
  imageStore(raySteps, pixel, step);
  imageStore(picture, pixel, vec4(color, 1));
}
