// A segment: its matrix, for points from its viewpoint, its first plane, and where its rays of one kind end.
const uint kEndPlanes = 4u;
layout(std140, binding = 1) uniform StraightSegment {
  vec4 rowU;
  vec4 rowV;
  vec4 rowW;
  vec4 viewpoint;
  vec4 begin;        // normal, and the height of the viewpoint
  float margin;      // before the first plane
  float nearWeight;  // least weight
  uint piece;
  uint planeCount;
  vec4 endPlanes[kEndPlanes];
};
