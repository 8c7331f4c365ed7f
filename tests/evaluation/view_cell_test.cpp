#include "oc_core/evaluation/view_cell.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <set>
#include <tuple>

namespace ocelli {
namespace {

TEST(ViewCell, eightInchesAreTheDefaultSide) {
  EXPECT_NEAR(ViewCell{}.sideRadii, 8 * kInchMetres / kReferenceDisplayRadiusMetres, 1e-6);
}

// The default view looks along -z: right, up and backward are x, y and z.
TEST(ViewCell, edgeViewsAreTwelveMidpointsThenEightCorners) {
  const std::vector<View> views = ViewCell{}.edgeViews(View{});
  ASSERT_EQ(views.size(), 20u);
  std::set<std::tuple<int, int, int>> places;
  for (size_t i = 0; i < views.size(); ++i) {
    const glm::vec3 offset = (views[i].eye - View{}.eye) / 0.8f;
    int zeros = 0;
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_NEAR(std::abs(offset[axis]), std::abs(std::round(offset[axis])), 2e-6f);
      EXPECT_LE(std::abs(offset[axis]), 1 + 2e-6f);
      zeros += std::round(offset[axis]) == 0;
    }
    EXPECT_EQ(zeros, i < 12 ? 1 : 0) << i;
    places.emplace(std::lround(offset.x), std::lround(offset.y), std::lround(offset.z));
    EXPECT_EQ(views[i].target, View{}.target);
    EXPECT_EQ(views[i].fovVerticalDegrees, View{}.resolvedFovVerticalDegrees()) << "the field of view stays";
  }
  EXPECT_EQ(places.size(), 20u) << "all different";
}

TEST(ViewCell, interiorViewsAreSeededAndFillTheCell) {
  const ViewCell cell{1.0f};
  const std::vector<View> views = cell.interiorViews(View{}, 400, 7);
  ASSERT_EQ(views.size(), 400u);
  EXPECT_EQ(views, cell.interiorViews(View{}, 400, 7));
  EXPECT_NE(views, cell.interiorViews(View{}, 400, 8));
  glm::vec3 least(1);
  glm::vec3 most(-1);
  for (const View& view : views) {
    const glm::vec3 offset = view.eye - View{}.eye;
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_LE(std::abs(offset[axis]), 0.5f + 1e-6f);
    }
    least = glm::min(least, offset);
    most = glm::max(most, offset);
  }
  // The chance that 400 uniform points leave a tenth of the range free at one of six sides is 6 * 0.9^400 < 1e-17.
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_LT(least[axis], -0.4f);
    EXPECT_GT(most[axis], 0.4f);
  }
}

}  // namespace
}  // namespace ocelli
