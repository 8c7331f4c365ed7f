// Where a ray inside of an object of glass meets its surface, it leaves, refracted, or is reflected inside. One that
// meets none, or has been reflected often enough, goes on as it is.
layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = 0) uniform usampler2D exits;  // what the rays inside hit
layout(binding = 0, rgba32f) uniform image2D innerOrigins;
layout(binding = 1, rgba32f) uniform image2D innerSteps;
layout(binding = 2, rgba32f) uniform image2D places;
layout(binding = 3, rgba32f) writeonly uniform image2D rayOrigins;
layout(binding = 4, rgba32f) writeonly uniform image2D raySteps;
layout(location = 0) uniform float index;
layout(location = 1) uniform float stepInside;
layout(location = 2) uniform float innerReach;
layout(location = 3) uniform float reach;  // of rays outside, world units
layout(location = 4) uniform bool isLast;

void main() {
  ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(pixel, imageSize(places)))) {
    return;
  }
  vec3 step = imageLoad(innerSteps, pixel).xyz;
  if (step == vec3(0)) {
    return;
  }
  vec3 direction = normalize(step);
  vec3 place = imageLoad(places, pixel).xyz;
  uvec4 exit_ = texelFetch(exits, pixel, 0);
  bool leaves = true;
  if (exit_.y != kNoTriangle) {
    place = placeOf(exit_);
    vec3 normal_ = normalAt(exit_, direction);
    vec3 outside = refract(direction, normal_, index);
    leaves = outside != vec3(0) || isLast;
    direction = normalize(outside != vec3(0) ? outside : reflect(direction, normal_));
  }
  if (leaves) {
    imageStore(rayOrigins, pixel, vec4(place, 1));
    imageStore(raySteps, pixel, vec4(direction * reach, 0));
    imageStore(innerSteps, pixel, vec4(0));
  } else {
    imageStore(places, pixel, vec4(place, 1));
    imageStore(innerOrigins, pixel, vec4(place + direction * stepInside, 1));
    imageStore(innerSteps, pixel, vec4(direction * innerReach, 0));
  }
}
