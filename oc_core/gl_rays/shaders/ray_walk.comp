// What each ray of an image of rays hits first: one invocation a ray.
layout(local_size_x = 8, local_size_y = 8) in;
layout(std430, binding = 2) readonly buffer Colors { float colors[]; };
layout(binding = 0) uniform sampler2D rayOrigins;  // and how far it reaches, 1 being the end of the step
layout(binding = 1) uniform sampler2D raySteps;
layout(binding = 0, rgba32ui) writeonly uniform uimage2D hits;
layout(binding = 1, rgba32f) writeonly uniform image2D hitColors;
layout(binding = 2, rgba32ui) writeonly uniform uimage2D costs;

// The distance of a hit that the driver kept from being found (gl_ray_walk.h).
const float kUnanswered = -1.0;

vec3 vertexColor(uint vertex) {
  return vec3(colors[3u * vertex], colors[3u * vertex + 1u], colors[3u * vertex + 2u]);
}

void main() {
  ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(texel, imageSize(hits)))) {
    return;
  }
  vec4 origin = texelFetch(rayOrigins, texel, 0);
  StraightRay ray = StraightRay(origin.xyz, texelFetch(raySteps, texel, 0).xyz, origin.w);
  uvec4 cost = uvec4(0);
  Meeting best = noMeeting();
  bool answered = !isCastable(ray) || walkPyramid(ray, best, cost);
  uvec4 hit = kNoFragment;
  vec4 color = vec4(0);
  if (!answered) {
    hit.x = floatBitsToUint(kUnanswered);
  } else if (best.triangle != kNoTriangle) {
    precise float t = min(float(best.share), 1.0) * sqrt(ray.step.x * ray.step.x + ray.step.y * ray.step.y + ray.step.z * ray.step.z);
    hit = packFragment(t, best.triangle, best.weights);
    uvec3 v = triangleVertices(best.triangle);
    precise vec3 between = vertexColor(v.x) * (1.0 - best.weights.x - best.weights.y) +
                           vertexColor(v.y) * best.weights.x + vertexColor(v.z) * best.weights.y;
    color = vec4(between, 1);
  }
  imageStore(hits, texel, hit);
  imageStore(hitColors, texel, color);
  imageStore(costs, texel, cost);
}
