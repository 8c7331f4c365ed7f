layout(location = 0) in vec3 worldPoint;

void main() {
  vec3 p = cameraFromWorld(worldPoint);
  gl_Position = clipFromCamera(p);
  gl_ClipDistance[0] = zFar - p.z;
}
