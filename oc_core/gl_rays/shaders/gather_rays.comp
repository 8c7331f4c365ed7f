// What the rays of a picture see, pixel by pixel: the nearer of what they hit in depth images and of billboards, else an
// environment map.
layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = 0) uniform sampler2D raySteps;  // 0 where a pixel sends none
layout(binding = 1) uniform usampler2D castHits;
layout(binding = 2) uniform sampler2D castColors;
layout(binding = 3) uniform usampler2D billboardHits;
layout(binding = 4) uniform sampler2D billboardColors;
// Equirectangular and level: the middle looks along -z, the right half to +x, the first row up (+y).
layout(binding = 5) uniform sampler2D environment;
layout(binding = 0, rgba32f) writeonly uniform image2D picture;

const float kPi = 3.14159265358979;

vec3 mapPixel(int x, int y) {
  ivec2 size = textureSize(environment, 0);
  return texelFetch(environment, ivec2((x + size.x) % size.x, clamp(y, 0, size.y - 1)), 0).rgb;
}
// Between the four pixels around a direction.
vec3 environmentColor(vec3 direction) {
  vec3 d = normalize(direction);
  vec2 at = vec2(0.5 + atan(d.x, -d.z) / (2.0 * kPi), 0.5 - asin(clamp(d.y, -1.0, 1.0)) / kPi) *
                vec2(textureSize(environment, 0)) - 0.5;
  ivec2 first = ivec2(floor(at));
  vec2 share = at - vec2(first);
  return mix(mix(mapPixel(first.x, first.y), mapPixel(first.x + 1, first.y), share.x),
             mix(mapPixel(first.x, first.y + 1), mapPixel(first.x + 1, first.y + 1), share.x), share.y);
}

void main() {
  ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(pixel, imageSize(picture)))) {
    return;
  }
  vec3 step = texelFetch(raySteps, pixel, 0).xyz;
  if (step == vec3(0)) {
    return;
  }
  uvec4 hit = texelFetch(castHits, pixel, 0);
  uvec4 billboard = texelFetch(billboardHits, pixel, 0);
  vec3 color;
  if (hit.y != kNoTriangle && (billboard.y == kNoTriangle || zOf(hit) <= zOf(billboard))) {
    color = texelFetch(castColors, pixel, 0).rgb;
  } else if (billboard.y != kNoTriangle) {
    color = texelFetch(billboardColors, pixel, 0).rgb;
  } else {
    color = environmentColor(step);
  }
  imageStore(picture, pixel, vec4(color, 1));
}
