// Light that an observer collects, times a gain.
layout(binding = 0) uniform sampler2D light;
layout(location = 0) uniform float gain;
layout(location = 0) out vec4 shownColor;

void main() {
  shownColor = vec4(srgbFromLinear(texelFetch(light, ivec2(gl_FragCoord.xy), 0).rgb * gain), 1);
}
