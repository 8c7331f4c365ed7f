// The projection map PM and the ray map RM, built as section 3.3.1.1 says, against the list of edges that the camera
// holds: on random rows they say the same, where the text's maps say anything.
#include <gtest/gtest.h>

#include <random>

#include "oc_core/camera/epipolar_camera.h"
#include "tests/ocri/test_scenes.h"

namespace ocelli {
namespace {

using test::kHeight;
using test::kWidth;
using test::smallCamera;

const glm::vec3 kMapRight{1.6f, 0, 10};

/// A row of depths: a background at depth 12 with occluders before it, each wide enough that the rays added behind it
/// stay under it, and apart enough that no disocclusion reaches another one.
struct RandomRow {
  std::vector<float> inverseZ;
  std::vector<EpipolarEdge> edges;
};

RandomRow randomRow(std::mt19937& random, double disparity) {
  constexpr float kBackground = 12;
  RandomRow row{std::vector<float>(kWidth, 1 / kBackground), {}};
  int end = 4;
  for (;;) {
    const float z = 9.5f + static_cast<float>(random() % 200) / 100;
    const int added =
        static_cast<int>(std::ceil(disparity * (1 / static_cast<double>(z) - 1 / static_cast<double>(kBackground))));
    const int begin = end + 2 + static_cast<int>(random() % 8);
    end = begin + added + 1 + static_cast<int>(random() % 10);
    if (end >= kWidth - 2) {
      return row;
    }
    std::fill(row.inverseZ.begin() + begin, row.inverseZ.begin() + end, 1 / z);
    row.edges.push_back({end, end - added, added, 1 / z});
  }
}

/// (o_0, o_1, z_0, z_1).
struct ProjectionMapEntry {
  int offset0 = 0;
  int offset1 = 0;
  double z0 = 1e30;
  double z1 = 0;
};

/// A pair (r_L, r_R) by its places in the image of L: where its ray of R begins and where it turns into the ray of L.
struct RayMapEntry {
  double position = 0;  ///< of the ray of L
  bool pair = false;
  double zFar = 0;
};

struct Maps {
  std::vector<ProjectionMapEntry> projection;
  std::vector<RayMapEntry> rays;
};

/// Section 3.3.1.1, word by word, for one row.
Maps textsMaps(const RandomRow& row, double disparity) {
  Maps maps{std::vector<ProjectionMapEntry>(kWidth), {}};
  int shift = 0;
  size_t next = 0;
  for (int u = 0; u < kWidth; ++u) {
    if (next < row.edges.size() && row.edges[next].position == u) {
      const EpipolarEdge& edge = row.edges[next++];
      // P_0, P_1, P_2: with whole columns, z_f is where the ray of R through the edge has moved by as many.
      const double zFar = 1 / (static_cast<double>(edge.inverseNear) - edge.added / disparity);
      for (int i = edge.added; i > 0; --i) {
        maps.rays.push_back({u - i + 0.5, true, zFar});
      }
      for (int k = u - edge.added; k < u; ++k) {
        ProjectionMapEntry& entry = maps.projection[static_cast<size_t>(k)];
        // The ray of L at this location against A_1, the ray of R past the edge.
        entry.z0 = std::min(entry.z0, 1 / (static_cast<double>(edge.inverseNear) - (u - (k + 0.5)) / disparity));
        entry.z1 = std::max(entry.z1, zFar);
        entry.offset1 = std::max(entry.offset1, entry.offset0 + edge.added);
      }
      shift += edge.added;
    }
    maps.projection[static_cast<size_t>(u)].offset0 = shift;
    maps.projection[static_cast<size_t>(u)].offset1 = shift;
    maps.rays.push_back({u + 0.5, false, 0});
  }
  return maps;
}

class EpipolarMaps : public ::testing::Test {
 protected:
  EpipolarMaps() : lines_(smallCamera(), kMapRight) {
    std::mt19937 random(7);
    std::vector<std::vector<EpipolarEdge>> edges;
    for (int row = 0; row < kHeight; ++row) {
      rows_.push_back(randomRow(random, lines_.disparity()));
      edges.push_back(rows_.back().edges);
    }
    camera_.emplace(smallCamera(), kMapRight, edges);
  }

  EpipolarLines lines_;
  std::vector<RandomRow> rows_;
  std::optional<EpipolarCamera> camera_;
};

TEST_F(EpipolarMaps, theTextsProjectionMapBracketsTheProjection) {
  int between = 0;
  for (int row = 0; row < kHeight; ++row) {
    const Maps maps = textsMaps(rows_[static_cast<size_t>(row)], lines_.disparity());
    for (int u = 0; u < kWidth; ++u) {
      const ProjectionMapEntry& entry = maps.projection[static_cast<size_t>(u)];
      for (double z = 8; z < 14; z += 0.05) {
        if (std::abs(z - entry.z0) < 1e-3 || std::abs(z - entry.z1) < 1e-3) {
          continue;  // at the border, rounding says which side
        }
        const std::optional<glm::vec3> point = smallCamera().unproject(
            {static_cast<float>(u) + 0.5f, static_cast<float>(row) + 0.5f, static_cast<float>(z)});
        const auto column = static_cast<double>(camera_->project(*point)->u);
        constexpr double kMapRounding = 1e-3;
        if (z < entry.z0) {
          EXPECT_NEAR(column, u + 0.5 + entry.offset0, kMapRounding);
        } else if (z > entry.z1) {
          EXPECT_NEAR(column, u + 0.5 + entry.offset1, kMapRounding)
              << row << " " << u << " " << z << " " << entry.z0 << " " << entry.z1;
        } else {
          EXPECT_GE(column, u + 0.5 + entry.offset0 - kMapRounding);
          EXPECT_LE(column, u + 0.5 + entry.offset1 + kMapRounding);
          ++between;
        }
      }
    }
  }
  EXPECT_GT(between, 1000) << "the case of an interval came up";
}

TEST_F(EpipolarMaps, theTextsRayMapHoldsTheRaysOfTheCamera) {
  const PinholeCamera base = smallCamera();
  int pairs = 0;
  for (int row = 0; row < kHeight; ++row) {
    const Maps maps = textsMaps(rows_[static_cast<size_t>(row)], lines_.disparity());
    ASSERT_EQ(maps.rays.size(), static_cast<size_t>(camera_->rowWidth(row)));
    for (size_t column = 0; column < maps.rays.size(); ++column) {
      const RayMapEntry& entry = maps.rays[column];
      const RayPath path = camera_->rayPath({static_cast<float>(column) + 0.5f, static_cast<float>(row) + 0.5f});
      ASSERT_EQ(path.size(), entry.pair ? 3u : 2u);
      // Up to 1e-3 pixels: rounding of 10 units and 90 pixels, and the margin that rays keep from disocclusions.
      const glm::vec3 end = base.cameraFromWorld(path.back());
      EXPECT_NEAR(base.imageFromCamera(end).u, entry.position, 1e-3);
      if (entry.pair) {
        ++pairs;
        const glm::vec3 knee = base.cameraFromWorld(path[1]);
        EXPECT_NEAR(base.imageFromCamera(knee).u, entry.position, 1e-3);
        EXPECT_NEAR(knee.z, entry.zFar, 1e-4);
        // r_R passes through R.
        const glm::vec3 a = glm::normalize(path[0] - kMapRight);
        const glm::vec3 b = glm::normalize(path[1] - kMapRight);
        EXPECT_LT(glm::length(glm::cross(a, b)), 1e-6f);
      }
    }
  }
  EXPECT_GT(pairs, 500);
}

}  // namespace
}  // namespace ocelli
