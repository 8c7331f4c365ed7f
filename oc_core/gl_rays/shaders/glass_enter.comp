// The ray inside of an object of glass at each pixel that shows it, refracted where it enters, as
// oc_core/shade/secondary_rays.h has it.
layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = 0) uniform usampler2D glass;  // what a picture of the object alone shows
layout(binding = 0, rgba32f) writeonly uniform image2D innerOrigins;
layout(binding = 1, rgba32f) writeonly uniform image2D innerSteps;  // 0 where no ray is inside
layout(binding = 2, rgba32f) writeonly uniform image2D places;      // where it began
layout(binding = 3, r32f) uniform image2D nearest;                  // z of what is seen before
layout(location = 0) uniform float index;       // of refraction
layout(location = 1) uniform float stepInside;  // what rays begin before the surface that they come from
layout(location = 2) uniform float innerReach;  // of rays inside

void main() {
  ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(pixel, imageSize(nearest)))) {
    return;
  }
  uvec4 seen = texelFetch(glass, pixel, 0);
  vec4 origin = vec4(0);
  vec4 step = vec4(0);
  vec4 place = vec4(0);
  if (seen.y != kNoTriangle && zOf(seen) < imageLoad(nearest, pixel).x) {
    vec3 incoming = viewDirection(pixel);
    vec3 direction = refract(incoming, normalAt(seen, incoming), 1.0 / index);
    place = vec4(placeOf(seen), 1);
    origin = vec4(place.xyz + direction * stepInside, 1);
    step = vec4(direction * innerReach, 0);
    imageStore(nearest, pixel, vec4(zOf(seen), 0, 0, 0));
  }
  imageStore(innerOrigins, pixel, origin);
  imageStore(innerSteps, pixel, step);
  imageStore(places, pixel, place);
}
