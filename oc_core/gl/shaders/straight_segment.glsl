// A segment: its matrix, for points from its viewpoint, and its first plane.
const uint kBlockTriangles = 32u;  // oc_core/render/mesh_blocks.h
const int kEndPlanes = 4;
layout(std140, binding = 1) uniform StraightSegment {
  vec4 rowU;
  vec4 rowV;
  vec4 rowW;
  vec4 viewpoint;
  vec4 begin;        // normal, and the height of the viewpoint
  float margin;      // before the first plane
  float nearWeight;  // least weight
  uint piece;
  uint kindCount;    // kinds of rays; where it is 1, they end at the planes that follow
  uint planeCount;
  uint unused0;
  uint unused1;
  uint unused2;
  vec4 endPlanes[kEndPlanes];
};
