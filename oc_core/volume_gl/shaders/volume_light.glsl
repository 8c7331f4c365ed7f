// How places of a volume are lit: the rule of oc_core/volume/gradient_light.h, and the gradients of
// oc_core/volume_render/volume_lighting.h.
layout(std140, binding = 2) uniform VolumeLight {
  mat4 sceneFromIndexGradient;  // of texels
  vec3 toLight;
  float litByGradient;          // 1 / the length from which on a gradient has a direction
  float ambient;
  float diffuse;
  float specular;
  float shininess;
};

vec3 indexGradientAt(vec3 index) {
  vec3 last = vec3(textureSize(voxels, 0) - 1);
  vec3 center = clamp(index, vec3(0), last);
  vec3 above = min(center + 1.0, last);
  vec3 below = max(center - 1.0, vec3(0));
  return 0.5 * vec3(texelField(vec3(above.x, center.yz)) - texelField(vec3(below.x, center.yz)),
                    texelField(vec3(center.x, above.y, center.z)) - texelField(vec3(center.x, below.y, center.z)),
                    texelField(vec3(center.xy, above.z)) - texelField(vec3(center.xy, below.z)));
}

// What the colour of a place is multiplied with, and what is added to it.
vec2 lightAt(vec3 index, vec3 direction) {
  vec3 gradient = mat3(sceneFromIndexGradient) * indexGradientAt(index);
  float size = length(gradient);
  if (!(size > 0.0)) {
    return vec2(1, 0);
  }
  float lit = min(size * litByGradient, 1.0);
  vec3 normal = gradient / size;
  vec3 between = toLight - direction;
  float betweenSize = length(between);
  float highlight = betweenSize > 0.0 ? abs(dot(normal, between)) / betweenSize : 0.0;
  float diffused = ambient + diffuse * abs(dot(normal, toLight));
  return vec2(mix(1.0, diffused, lit), lit * specular * pow(highlight, shininess));
}
