// A segment: its matrix, for points from its viewpoint, and its first plane.
layout(std140, binding = 1) uniform StraightSegment {
  vec4 rowU;
  vec4 rowV;
  vec4 rowW;
  vec4 viewpoint;
  vec4 begin;        // normal, and the height of the viewpoint
  float margin;      // before the first plane
  float nearWeight;  // least weight
  uint piece;
  uint firstOfLeaves;
};
