// What tests of cameras of walk maps measure alike.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <set>
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

/// Of the surface that an image shows, in squares of a metre over 4, the share that pixels of two frusta show: rays of
/// parts that cross. What stands behind walls is no part of it.
inline double shownTwiceShare(const GraphCamera& camera, const Mesh& mesh) {
  constexpr float kSquares = 4;
  const FragmentImage image = rasterize(camera, mesh);
  std::map<std::array<long, 4>, std::set<int>> frusta;
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      if (!image(x, y).covered()) {
        continue;
      }
      int frustum = GraphCamera::kRoot;
      for (int child = frustum; child >= 0; child = camera.childAt(frustum, {x + 0.5, y + 0.5})) {
        frustum = child;
      }
      const glm::vec3 at = positionOf(image(x, y), mesh) * kSquares;
      frusta[{image(x, y).triangle, std::lround(at.x), std::lround(at.y), std::lround(at.z)}].insert(frustum);
    }
  }
  const auto twice =
      std::count_if(frusta.begin(), frusta.end(), [](const auto& each) { return each.second.size() > 1; });
  std::printf("%.1f %% of what is seen is shown twice\n",
              100.0 * static_cast<double>(twice) / static_cast<double>(frusta.size()));
  return static_cast<double>(twice) / static_cast<double>(frusta.size());
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
