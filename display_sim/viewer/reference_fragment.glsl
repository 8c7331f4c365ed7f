// The samples of a reference image: their colours, or their depths or displacements as brightness.
layout(binding = 0) uniform sampler2D colors;  // linear
layout(binding = 1) uniform sampler2D depths;  // 0: no sample
layout(binding = 2) uniform sampler2D displacements;
layout(location = 0) uniform vec2 firstPixel;     // of the image, at the corner of the pane
layout(location = 1) uniform float pixelStep;     // image pixels for a pixel of the pane
layout(location = 2) uniform int quantity;        // as ReferenceShown::Quantity
layout(location = 3) uniform vec2 depthRange;
layout(location = 4) uniform float longestDisplacement;
layout(location = 5) uniform ivec2 pickedPixel;   // (-1, -1): none
layout(location = 6) uniform vec3 background;     // around the image
layout(location = 7) uniform int referenceHeight; // rows below hold tiles
layout(location = 0) out vec4 shownColor;

// From dark blue over grey to light yellow: brightness grows evenly, and no kind of colour vision loses an end.
vec3 ramp(float t) {
  const vec3 dark = vec3(0.00, 0.14, 0.36);
  const vec3 middle = vec3(0.49, 0.48, 0.47);
  const vec3 light = vec3(0.99, 0.91, 0.33);
  t = clamp(t, 0, 1);
  return t < 0.5 ? mix(dark, middle, 2 * t) : mix(middle, light, 2 * t - 1);
}

void main() {
  vec2 place = firstPixel + gl_FragCoord.xy * pixelStep;
  ivec2 size = textureSize(depths, 0);
  ivec2 pixel = ivec2(floor(place));
  if (any(lessThan(pixel, ivec2(0))) || any(greaterThanEqual(pixel, size))) {
    shownColor = vec4(background, 1);
    return;
  }
  float z = texelFetch(depths, pixel, 0).r;
  vec3 color;
  if (z == 0) {  // no sample: a quiet chequer
    color = vec3(((pixel.x >> 3) + (pixel.y >> 3)) % 2 == 0 ? 0.055 : 0.075);
  } else if (quantity == 0) {
    color = srgbFromLinear(texelFetch(colors, pixel, 0).rgb);
  } else if (quantity == 1) {  // near is light; even steps of 1/z, as the image sees them
    float t = (1 / z - 1 / depthRange.y) / max(1 / depthRange.x - 1 / depthRange.y, 1e-9);
    color = ramp(t);
  } else {
    vec2 d = texelFetch(displacements, pixel, 0).rg;
    color = ramp(longestDisplacement > 0 ? length(d) / longestDisplacement : 0);
  }
  // Where the pixels of the reference pinhole end.
  if (referenceHeight < size.y && abs(place.y - float(referenceHeight)) < pixelStep) {
    color = vec3(0.90, 0.62, 0);
  }
  vec2 within = (place - vec2(pixel)) / pixelStep;
  float pixels = 1 / pixelStep;
  if (pixels >= 12 && min(within.x, within.y) < 1) {  // a grid, where there is room for it
    color *= 0.8;
  }
  if (pixel == pickedPixel && pixels >= 4) {
    float border = max(1, pixels / 8);
    if (min(min(within.x, within.y), min(pixels - within.x, pixels - within.y)) < border) {
      color = vec3(0.90, 0.62, 0);
    }
  }
  shownColor = vec4(color, 1);
}
