// From what each pixel sees, and in which piece of its ray, to the fragment: z as oc_core/camera/graph_camera.h and
// curved_ray_camera.h measure it along the ray.
layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = 0) uniform usampler2D samples;       // piece, triangle
layout(binding = 1) uniform sampler2D weightsInBends;  // of those that lie in bends
layout(binding = 0, rgba32ui) writeonly uniform uimage2D fragments;

// From where it crosses a plane, a ray runs on away from a viewpoint; all is taken from the eye.
struct Bend {
  vec4 plane;
  vec4 viewpoint;
};
layout(std430, binding = 2) readonly buffer Bends { Bend bends[]; };
// Of each piece: its first bend, how many lead to it, and for a bend 1, and where its first and last plane are.
layout(std430, binding = 3) readonly buffer Ways { uvec4 ways[]; };
// Of each piece that is straight: its viewpoint, from the eye, and the rows that project places from there.
struct Straight {
  vec4 viewpoint;
  vec4 rows[3];
};
layout(std430, binding = 4) readonly buffer Straights { Straight straights[]; };

struct Ray {
  vec3 at;
  vec3 direction;
  float z;
  float perLength;
};
float heightOver(vec4 plane, vec3 p) {
  return dot(plane.xyz, p) + plane.w;
}
vec3 crossing(Ray ray, vec4 plane) {
  return ray.at - ray.direction * (heightOver(plane, ray.at) / dot(plane.xyz, ray.direction));
}
float zAt(Ray ray, vec3 p) {
  return ray.z + distance(ray.at, p) * ray.perLength;
}
Ray bent(Ray ray, Bend bend) {
  vec3 p = crossing(ray, bend.plane);
  return Ray(p, p - bend.viewpoint.xyz, zAt(ray, p), ray.perLength);
}

float zInBend(Ray ray, Bend bend, vec4 from, vec4 to, vec3 p) {
  float begin = zAt(ray, crossing(ray, from));
  float passed = max(heightOver(from, p), 0.0) / dot(from.xyz, normalize(ray.direction));
  ray = bent(ray, bend);
  float end = zAt(ray, crossing(ray, to));
  float left = max(-heightOver(to, p), 0.0) / dot(to.xyz, normalize(ray.direction));
  return begin + (end - begin) * (passed > 0.0 ? passed / (passed + left) : 0.0);
}

vec3 imageBy(Straight straight, vec3 p) {
  vec3 q = p - straight.viewpoint.xyz;
  return vec3(dotInOrder(q, straight.rows[0].xyz), dotInOrder(q, straight.rows[1].xyz),
              dotInOrder(q, straight.rows[2].xyz));
}

void main() {
  ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(pixel, ivec2(pinholeSize)))) {
    return;
  }
  uvec4 seen = texelFetch(samples, pixel, 0);
  if (seen.y == kNoTriangle) {
    imageStore(fragments, pixel, kNoFragment);
    return;
  }
  vec2 offset = (vec2(pixel) + 0.5 - center) / focal;
  vec3 direction = right * offset.x + down * offset.y + forward;
  Ray ray = Ray(vec3(0), direction, 0.0, 1.0 / length(direction));
  uvec4 way = ways[seen.x];
  for (uint i = 0u; i < way.y; ++i) {
    ray = bent(ray, bends[way.x + i]);
  }
  uvec3 vertices = triangleVertices(seen.y);
  vec3 corners[3] =
      vec3[3](position(vertices.x) - eye, position(vertices.y) - eye, position(vertices.z) - eye);
  vec2 weights;
  if (way.z == 0u) {
    Straight straight = straights[seen.x];
    weights = weightsOfImages(imageBy(straight, corners[0]), imageBy(straight, corners[1]),
                              imageBy(straight, corners[2]), vec2(pixel) + 0.5).yz;
  } else {
    weights = texelFetch(weightsInBends, pixel, 0).xy;
  }
  vec3 p = pointOf(corners, weights);
  float z = way.z == 0u ? zAt(ray, p)
                        : zInBend(ray, bends[way.x + way.y], bends[way.w].plane, bends[way.w + 1u].plane, p);
  imageStore(fragments, pixel, z <= zFar ? packFragment(z, seen.y, weights) : kNoFragment);
}
