// Corners of the pieces that are left undivided, pulled from their list.
layout(std430, binding = 4) readonly buffer Leaves { uint leaves[]; };
layout(location = 0) flat out uint triangle;
layout(location = 1) out vec2 weights;

void main() {
  uint at = kPieceWords * (uint(gl_VertexID) / 3u);
  uint corner = uint(gl_VertexID) % 3u;
  triangle = leaves[at];
  weights = uintBitsToFloat(uvec2(leaves[at + 1u + 2u * corner], leaves[at + 2u + 2u * corner]));
  uvec3 vertices = triangleVertices(triangle);
  vec3 corners[3] = vec3[3](cameraFromWorld(position(vertices.x)), cameraFromWorld(position(vertices.y)),
                            cameraFromWorld(position(vertices.z)));
  vec3 p = pointOf(corners, weights);
  gl_Position = clipFromImage(distorted(imageFromCamera(p), p.z), p.z);
  gl_ClipDistance[0] = zFar - p.z;
}
