// The image of an epipolar occlusion camera: straight columns hold what its base sees, where that lies in no disocclusion;
// columns that edges added hold the samples of spans.
layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = 0) uniform usampler2D depths;
layout(binding = 1) uniform usampler2D indices;
layout(binding = 2) uniform usampler2D baseFragments;
layout(binding = 0, rgba32ui) writeonly uniform uimage2D fragments;

void main() {
  ivec2 place = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(place, imageSize(fragments)))) {
    return;
  }
  int row = place.y;
  // The last disocclusion whose columns begin at or before this one.
  int disocclusion = -1;
  int below = rows[row].firstDisocclusion;
  int above = below + rows[row].disocclusionCount;
  while (below < above) {
    int middle = (below + above) / 2;
    if (disocclusions[middle].position + disocclusions[middle].shift - disocclusions[middle].added <= place.x) {
      disocclusion = middle;
      below = middle + 1;
    } else {
      above = middle;
    }
  }
  int position_ = place.x - (disocclusion >= 0 ? disocclusions[disocclusion].shift : 0);
  uvec4 fragment = kNoFragment;
  if (disocclusion >= 0 && position_ < disocclusions[disocclusion].position) {
    uint triangle = texelFetch(indices, place, 0).x;
    if (triangle != kNoTriangle) {
      float z = uintBitsToFloat(texelFetch(depths, place, 0).x);
      // Where L sees the point: on its own ray behind the far depth of the disocclusion, on one of R before that.
      double inverseZ = 1.0LF / double(z);
      double x = xAt(row, position_ + 0.5LF);
      if (inverseZ * inverseZScale(x) > disocclusions[disocclusion].yFar) {
        double xRight = x - disparity * disocclusions[disocclusion].yFar;
        x = isParallel != 0 ? xRight + disparity * inverseZ : xRight / (1.0LF - inverseZ * disparity * advanceSign);
      }
      vec2 at = vec2(linePoint(row, positionAt(row, x)));
      uvec3 vertices = triangleVertices(triangle);
      vec3 weights = weightsAt(cameraFromWorld(position(vertices.x)), cameraFromWorld(position(vertices.y)),
                               cameraFromWorld(position(vertices.z)), at);
      fragment = packFragment(z, triangle, weights.yz);
    }
  } else if (position_ < rows[row].length) {
    uvec4 seen = texelFetch(baseFragments, ivec2(position_, row), 0);
    if (seen.y != kNoTriangle) {
      double x = xAt(row, position_ + 0.5LF);
      double y = inverseZScale(x) / double(zOf(seen));
      if (disocclusionOf(row, position_ + 1, x - disparity * y) < 0) {
        fragment = seen;
      }
    }
  }
  imageStore(fragments, place, fragment);
}
