// The greatest 1/z of a disocclusion over each cell of each row; 0 for none.
layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = 0, r32f) writeonly uniform image2D tops;

void main() {
  ivec2 place = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(place, imageSize(tops)))) {
    return;
  }
  uvec2 list = listOver(place.y, place.x);
  double top = 0.0LF;
  if (list.x < list.y) {
    double xRight = disocclusions[rows[place.y].firstDisocclusion + int(over[list.y - 1u])].xRight;
    for (int i = 0; i < 2; ++i) {
      double border = cellBegin(place.x + i);
      if (hasPosition(place.y, border)) {
        double x = xAt(place.y, border);
        top = max(top, (x - xRight) / disparity / inverseZScale(x));
      }
    }
  }
  imageStore(tops, place, vec4(float(top * 1.001LF)));
}
