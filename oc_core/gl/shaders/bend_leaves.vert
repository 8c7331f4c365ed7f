// Corners of the pieces of triangles in a bend, pulled from their list.
layout(std430, binding = 4) readonly buffer Leaves { uint leaves[]; };
layout(location = 0) flat out uint triangle;
layout(location = 1) out vec2 weights;
layout(location = 2) out vec2 heights;  // from the first and the last plane

void main() {
  uint at = kPieceWords * (uint(gl_VertexID) / 3u);
  uint corner = uint(gl_VertexID) % 3u;
  triangle = leaves[at];
  weights = uintBitsToFloat(uvec2(leaves[at + 1u + 2u * corner], leaves[at + 2u + 2u * corner]));
  uvec3 vertices = triangleVertices(triangle);
  vec3 corners[3] = vec3[3](position(vertices.x) - before.xyz, position(vertices.y) - before.xyz,
                            position(vertices.z) - before.xyz);
  BendPoint point = bendPoint(pointOf(corners, weights));
  heights = vec2(point.first, point.last);
  gl_Position = vec4(2.0 * point.image / pinholeSize - 1.0, 0.5, 1.0) * point.weight;
  gl_ClipDistance[0] = 1.0;
}
