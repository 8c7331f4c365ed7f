// The cameras of the benchmarks of volumes: a pinhole, and others whose rays are spread or bend in the middle of a
// volume that is fitted.
#pragma once

#include "oc_core/camera/curved_ray_camera.h"
#include "oc_core/camera/gpc_camera.h"
#include "oc_core/camera/graph_camera.h"
#include "oc_core/volume_render/volume_image.h"

namespace ocelli {

/// Calls `visit(name, camera)`, the pinhole first. They look from the default view.
template <class Visit>
void forEachVolumeCamera(int width, int height, const Visit& visit) {
  const PinholeCamera pinhole(View{}, width, height);
  visit("pinhole", pinhole);
  visit("general pinhole", GpcCamera(pinhole, {findGpcSampling("cubic"), {{{0.5f, 0.5f}, {0.5f, 0.5f}, 2, 1}}}));
  GraphCamera graph(pinhole);
  graph.bend(0, {Plane::through({0, 0, 0}, {0, 0, -1}), {-2, 0, 6}}, "bend");
  visit("graph", graph);
  CurvedRayCamera curved(pinhole);
  curved.bend({Plane::through({4, 0, 0}, {-0.25, 0, -1}), Plane::through({4, 0, 0}, {0, 0, -1}),
               Plane::through({4, 0, 0}, {0.25, 0, -1})},
              {-2, 0, 6});
  visit("curved", curved);
}

inline uint64_t samplesOf(const VolumeImage& image) {
  uint64_t sum = 0;
  for (const VolumePixel& pixel : image) {
    sum += pixel.samples;
  }
  return sum;
}

}  // namespace ocelli
