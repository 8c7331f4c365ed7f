// What a picture shows at once, and no rays yet.
layout(local_size_x = 8, local_size_y = 8) in;
layout(std430, binding = 2) readonly buffer Colors { float colors[]; };
layout(binding = 0) uniform usampler2D direct;
layout(binding = 0, rgba32f) writeonly uniform image2D rayOrigins;
layout(binding = 1, rgba32f) writeonly uniform image2D raySteps;
layout(binding = 2, rgba32f) writeonly uniform image2D picture;
layout(binding = 3, r32f) writeonly uniform image2D nearest;  // z of what is seen; far away for nothing
layout(location = 0) uniform vec3 background;

const float kFar = 3e38;

vec3 vertexColor(uint vertex) {
  return vec3(colors[3u * vertex], colors[3u * vertex + 1u], colors[3u * vertex + 2u]);
}

void main() {
  ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(pixel, imageSize(picture)))) {
    return;
  }
  uvec4 seen = texelFetch(direct, pixel, 0);
  vec3 color = background;
  float z = kFar;
  if (seen.y != kNoTriangle) {
    uvec3 v = triangleVertices(seen.y);
    vec2 weights = weightsOf(seen);
    color = vertexColor(v.x) * (1.0 - weights.x - weights.y) + vertexColor(v.y) * weights.x +
            vertexColor(v.z) * weights.y;
    z = zOf(seen);
  }
  imageStore(rayOrigins, pixel, vec4(0));
  imageStore(raySteps, pixel, vec4(0));
  imageStore(picture, pixel, vec4(color, 1));
  imageStore(nearest, pixel, vec4(z, 0, 0, 0));
}
