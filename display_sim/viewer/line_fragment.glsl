layout(location = 0) in vec4 lineColor;
layout(location = 1) noperspective in vec2 acrossAndWidth;
layout(location = 0) out vec4 shownColor;

void main() {
  float cover = clamp(acrossAndWidth.y / 2 + 0.5 - abs(acrossAndWidth.x), 0, 1);
  shownColor = vec4(lineColor.rgb, lineColor.a * cover);
}
