// Linear light as sRGB values (IEC 61966-2-1).
vec3 srgbFromLinear(vec3 linear) {
  vec3 c = clamp(linear, 0, 1);
  return mix(1.055 * pow(c, vec3(1 / 2.4)) - 0.055, 12.92 * c, lessThanEqual(c, vec3(0.0031308)));
}
