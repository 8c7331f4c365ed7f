// The ray that goes on from a mirror at each pixel that shows it: the view ray reflected about the interpolated normal,
// as oc_core/shade/secondary_rays.h has it.
layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = 0) uniform usampler2D mirror;  // what a picture of the mirror alone shows
layout(binding = 0, rgba32f) writeonly uniform image2D rayOrigins;
layout(binding = 1, rgba32f) writeonly uniform image2D raySteps;
layout(binding = 3, r32f) uniform image2D nearest;  // z of what is seen before
layout(location = 0) uniform float reach;           // of rays, world units

void main() {
  ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(pixel, imageSize(nearest)))) {
    return;
  }
  uvec4 seen = texelFetch(mirror, pixel, 0);
  if (seen.y == kNoTriangle || !(zOf(seen) < imageLoad(nearest, pixel).x)) {
    return;
  }
  vec3 incoming = viewDirection(pixel);
  vec3 outgoing = normalize(reflect(incoming, normalAt(seen, incoming)));
  imageStore(rayOrigins, pixel, vec4(placeOf(seen), 1));
  imageStore(raySteps, pixel, vec4(outgoing * reach, 0));
  imageStore(nearest, pixel, vec4(zOf(seen), 0, 0, 0));
}
