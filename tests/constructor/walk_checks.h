// What tests of cameras of walk maps measure alike.
#pragma once

#include <cstdio>
#include <cstdlib>
#include <string>

#include "oc_core/camera/graph_overlap.h"
#include "oc_core/image/png_file.h"
#include "oc_core/render/rasterize_graph.h"
#include "oc_core/render/raycast.h"

namespace ocelli::test {

/// OCELLI_TEST_IMAGES=FOLDER keeps the image, to be looked at.
inline void keepImage(const GraphCamera& camera, const Mesh& mesh, const std::string& name) {
  if (const char* folder = std::getenv("OCELLI_TEST_IMAGES")) {
    writePng(std::string(folder) + "/" + name + ".png",
             srgbFromLinear(colorImage(rasterize(camera, mesh), mesh, glm::vec3(0.1f))));
  }
}

/// Prints them.
inline size_t overlapCount(const GraphCamera& camera, const Mesh& mesh) {
  const Box world = boundsOf(mesh);
  const auto overlaps = overlapsOf(camera, glm::dvec3(world.lower), glm::dvec3(world.upper));
  for (const FrustumOverlap& each : overlaps) {
    std::printf("%s (%d) and %s (%d) overlap at (%g, %g, %g)\n",
                camera.frusta()[static_cast<size_t>(each.first)].name.c_str(), each.first,
                camera.frusta()[static_cast<size_t>(each.second)].name.c_str(), each.second, each.point.x, each.point.y,
                each.point.z);
  }
  return overlaps.size();
}

/// Of pixels, those in which rasteriser and ray caster differ.
inline double differingShare(const GraphCamera& camera, const Mesh& mesh) {
  const FragmentImage drawn = rasterize(camera, mesh);
  const FragmentImage cast = raycast(camera, mesh, RayScene(mesh));
  size_t differing = 0;
  for (size_t i = 0; i < drawn.size(); ++i) {
    differing += drawn[i].covered() != cast[i].covered() || std::abs(drawn[i].t - cast[i].t) > 1e-3f * cast[i].t;
  }
  return static_cast<double>(differing) / static_cast<double>(drawn.size());
}

}  // namespace ocelli::test
