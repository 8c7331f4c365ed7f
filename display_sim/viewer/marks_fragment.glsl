// What the reconstruction pane shows of a pixel, and how many samples are missing.
layout(binding = 0) uniform usampler2D states;
layout(binding = 1) uniform sampler2D frameColors;
layout(location = 0) uniform vec3 missingColor;
layout(location = 1) uniform vec3 missingThickColor;
layout(std430, binding = 0) buffer Counts { uint truth; uint strict; uint thick; };
layout(location = 0) out vec4 shownColor;

void main() {
  ivec2 size = textureSize(states, 0);
  ivec2 at = ivec2(gl_FragCoord.xy);
  uint state = texelFetch(states, at, 0).r;
  // Greyish and dim, so that the false colours stand out from any scene.
  vec3 color = texelFetch(frameColors, at, 0).rgb;
  float grey = dot(color, vec3(0.299, 0.587, 0.114));
  shownColor = vec4(0.6 * mix(color, vec3(grey), 0.8), 1);
  if (state == 0) {
    return;
  }
  atomicAdd(truth, 1);
  if (state == 1) {
    return;
  }
  atomicAdd(strict, 1);
  // Thick: so are its eight neighbours, all inside of the image.
  bool isThick = at.x > 0 && at.y > 0 && at.x < size.x - 1 && at.y < size.y - 1;
  for (int y = -1; y <= 1 && isThick; ++y) {
    for (int x = -1; x <= 1; ++x) {
      isThick = isThick && texelFetch(states, at + ivec2(x, y), 0).r == 2;
    }
  }
  if (isThick) {
    atomicAdd(thick, 1);
  }
  shownColor = vec4(isThick ? missingThickColor : missingColor, 1);
}
