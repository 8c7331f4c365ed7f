// The planar pinhole camera as oc_core/camera/pinhole_camera.h has it: camera coordinates are (right, down, forward)
// from the eye, image coordinates pixels from the top left.
layout(std140, binding = 0) uniform Pinhole {
  vec3 eye;
  float zNear;
  vec3 right;
  float zFar;
  vec3 down;
  float focal;
  vec3 forward;
  float unused;
  vec2 center;
  vec2 pinholeSize;
};

// In this order, so that every driver rounds alike.
float dotInOrder(vec3 a, vec3 b) {
  precise float sum = a.x * b.x + a.y * b.y + a.z * b.z;
  return sum;
}

vec3 cameraFromWorld(vec3 worldPoint) {
  vec3 p = worldPoint - eye;
  return vec3(dotInOrder(p, right), dotInOrder(p, down), dotInOrder(p, forward));
}

vec2 imageFromCamera(vec3 p) {
  precise vec2 q = center + focal * p.xy / p.z;
  return q;
}

// OpenGL's clip coordinates of an image point at depth z. Image row 0 is row 0 of the texture. Depth is zNear / z: 1 at
// zNear, 0 at infinity, and as precise far away as nearby.
vec4 clipFromImage(vec2 q, float z) {
  return vec4((2.0 * q / pinholeSize - 1.0) * z, zNear, z);
}
vec4 clipFromCamera(vec3 p) {
  return vec4(2.0 * (center * p.z + focal * p.xy) / pinholeSize - p.z, zNear, p.z);
}
