// The unit direction of the pinhole's ray through the middle of a pixel.
vec3 viewDirection(ivec2 pixel) {
  vec2 offset = (vec2(pixel) + 0.5 - center) / focal;
  return normalize(right * offset.x + down * offset.y + forward);
}
