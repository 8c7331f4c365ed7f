// Images of cameras, and of the same cameras as ray maps that went through a file.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string>

#include "oc_core/ocri/ray_map_kind.h"
#include "oc_core/ray_map/ray_map_file.h"
#include "oc_core/render/raycast.h"

namespace ocelli::test {

/// What other programs get, and read.
inline std::shared_ptr<const RayMap> throughAFile(const RayMap& map) {
  return std::make_shared<const RayMap>(rayMapFromBytes(rayMapBytes(map), "map.exr"));
}

inline ReferenceImage imageOf(const std::shared_ptr<const RayMap>& map, const Mesh& mesh) {
  const PinholeCamera reference(map->notes().view.value_or(View{}), map->width(), map->height());
  return buildReferenceImages(rayMapChoice(map), reference, mesh).front();
}

/// How many samples differ: covered in one image alone, at another place, or of another colour.
struct Differences {
  size_t covered = 0;
  size_t differing = 0;
};

/// Coordinates of rays are rounded to 32 bits twice more on their way through a file, by 1e-6 each where they are 10.
/// Hits at grazing angles, of edges, and of what lies exactly between two triangles may be others.
inline constexpr float kPlaceRounding = 1e-4f;

inline Differences compare(const ReferenceImage& got, const FragmentImage& want, const Mesh& mesh) {
  Differences differences;
  for (int y = 0; y < want.height(); ++y) {
    for (int x = 0; x < want.width(); ++x) {
      const Fragment& fragment = want(x, y);
      differences.covered += fragment.covered() ? 1 : 0;
      const bool same =
          fragment.covered() == got.holds(x, y) &&
          (!fragment.covered() || (glm::distance(positionOf(fragment, mesh), got.position(x, y)) < kPlaceRounding &&
                                   std::abs(fragment.t - got.t(x, y)) < kPlaceRounding &&
                                   glm::distance(colorOf(fragment, mesh), got.color(x, y)) < 1e-3f));
      differences.differing += same ? 0 : 1;
    }
  }
  return differences;
}

/// Of the pixels of an image: 4 of 9600, at edges, of the path camera are the most that differ; of most cameras none
/// do.
inline constexpr double kMaxDifferingShare = 0.001;

inline void expectSame(const ReferenceImage& got, const FragmentImage& want, const Mesh& mesh,
                       const std::string& name) {
  ASSERT_EQ(got.width(), want.width()) << name;
  ASSERT_EQ(got.height(), want.height()) << name;
  const Differences differences = compare(got, want, mesh);
  EXPECT_GT(differences.covered, 20u) << name;
  EXPECT_LE(static_cast<double>(differences.differing),
            kMaxDifferingShare * static_cast<double>(want.width()) * want.height())
      << name << ": " << differences.differing << " of " << want.width() << "x" << want.height();
}

}  // namespace ocelli::test
