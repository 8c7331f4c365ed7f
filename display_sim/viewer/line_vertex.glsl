// Segments as quads that face the eye, with soft sides. Six vertices a segment.
struct Line {
  vec4 from;   // w: width in pixels
  vec4 to;     // w: unused
  vec4 color;  // sRGB and opacity
};
layout(std430, binding = 0) readonly buffer Lines { Line lines[]; };
layout(location = 7) uniform vec2 paneSize;  // pixels
layout(location = 8) uniform float opacity;
layout(location = 0) out vec4 lineColor;
layout(location = 1) noperspective out vec2 acrossAndWidth;  // pixels

void main() {
  Line line = lines[gl_VertexID / 6];
  int corner = gl_VertexID % 6;
  bool atEnd = corner == 1 || corner == 2 || corner == 4;
  float side = corner == 2 || corner == 4 || corner == 5 ? 1 : -1;

  // What is behind the eye has no image: cut there.
  vec3 a = viewFromWorld(line.from.xyz);
  vec3 b = viewFromWorld(line.to.xyz);
  float nearest = viewRange.x;
  lineColor = line.color * vec4(1, 1, 1, opacity);
  acrossAndWidth = vec2(0);
  if (a.z < nearest && b.z < nearest) {
    gl_Position = vec4(0, 0, 2, 1);
    return;
  }
  if (a.z < nearest) {
    a = mix(a, b, (nearest - a.z) / (b.z - a.z));
  } else if (b.z < nearest) {
    b = mix(b, a, (nearest - b.z) / (a.z - b.z));
  }
  vec4 clipA = clipFromView(a);
  vec4 clipB = clipFromView(b);
  vec2 along = (clipB.xy / clipB.w - clipA.xy / clipA.w) * paneSize;
  float length = length(along);
  vec2 across = length > 0 ? vec2(-along.y, along.x) / length : vec2(0, 1);
  float halfWidth = line.from.w / 2 + 0.75;
  vec4 clip = atEnd ? clipB : clipA;
  clip.xy += across * side * halfWidth * 2 / paneSize * clip.w;
  gl_Position = clip;
  acrossAndWidth = vec2(side * halfWidth, line.from.w);
}
