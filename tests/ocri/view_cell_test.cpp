#include "oc_core/ocri/view_cell.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <set>
#include <tuple>

#include "oc_core/base/error.h"

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

// Three between corners that are 1.6 radii apart: steps of 0.4 radii. The first edge runs along x at y = z = -0.8.
TEST(ViewCell, moreEdgeViewsDivideEachEdgeIntoEqualSteps) {
  const std::vector<View> views = ViewCell{}.edgeViews(View{}, 3);
  ASSERT_EQ(views.size(), 12u * 3 + 8);
  for (size_t i = 0; i < 3; ++i) {
    const glm::vec3 offset = views[i].eye - View{}.eye;
    EXPECT_LT(glm::distance(offset, glm::vec3(-0.4f + 0.4f * static_cast<float>(i), -0.8f, -0.8f)), 2e-6f) << i;
  }
  EXPECT_LT(glm::distance(views.back().eye, View{}.eye + glm::vec3(0.8f)), 2e-6f) << "the last corner";
  std::set<std::tuple<long, long, long>> places;
  for (const View& view : views) {
    const glm::vec3 offset = (view.eye - View{}.eye) / 0.4f;
    places.emplace(std::lround(offset.x), std::lround(offset.y), std::lround(offset.z));
    int ends = 0;
    for (int axis = 0; axis < 3; ++axis) {
      ends += std::abs(std::lround(offset[axis])) == 2;
    }
    EXPECT_GE(ends, 2) << "on an edge";
  }
  EXPECT_EQ(places.size(), views.size()) << "all different";
}

TEST(ViewCell, oneViewOnEachEdgeIsItsMidpointAndNoneLeavesTheCorners) {
  EXPECT_EQ(ViewCell{}.edgeViews(View{}, 1), ViewCell{}.edgeViews(View{}));
  const std::vector<View> all = ViewCell{}.edgeViews(View{});
  EXPECT_EQ(ViewCell{}.edgeViews(View{}, 0), std::vector<View>(all.begin() + 12, all.end()));
}

TEST(ViewCell, edgeSequencesRunFromCornerToCorner) {
  for (const int between : {0, 1, 4}) {
    const std::vector<View> views = ViewCell{}.edgeViews(View{}, between);
    const std::vector<EdgeSequence> sequences = ViewCell{}.edgeSequences(between);
    ASSERT_EQ(sequences.size(), 12u);
    std::multiset<size_t> seen;
    for (const EdgeSequence& sequence : sequences) {
      ASSERT_EQ(sequence.views.size(), static_cast<size_t>(between) + 2);
      ASSERT_EQ(sequence.places.size(), sequence.views.size());
      for (size_t i = 0; i < sequence.views.size(); ++i) {
        seen.insert(sequence.views[i]);
        ASSERT_LT(sequence.views[i], views.size());
        const glm::vec3 offset = views[sequence.views[i]].eye - View{}.eye;
        EXPECT_LT(glm::distance(offset, 0.8f * sequence.places[i]), 2e-6f);
        if (i > 0) {
          EXPECT_NEAR(glm::distance(sequence.places[i], sequence.places[i - 1]), 2.0f / static_cast<float>(between + 1),
                      1e-6f);
        }
      }
      EXPECT_NEAR(glm::distance(sequence.places.front(), sequence.places.back()), 2, 1e-6f);
    }
    for (size_t i = 0; i < views.size(); ++i) {
      EXPECT_EQ(seen.count(i), i < 12u * static_cast<size_t>(between) ? 1u : 3u) << "three edges meet in a corner";
    }
  }
}

TEST(ViewCell, onlyACubeHasEdgeSequences) {
  for (const auto shape : {ViewCell::Shape::kSphere, ViewCell::Shape::kSegment}) {
    const ViewCell cell{1, shape};
    EXPECT_TRUE(cell.edgeSequences(3).empty());
    EXPECT_EQ(cell.edgeViews(View{}, 3), cell.edgeViews(View{}));
  }
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

/// Where the views stand, along right, up and backward of the default view, in display radii.
std::vector<glm::vec3> offsetsOf(const std::vector<View>& views) {
  std::vector<glm::vec3> offsets;
  for (const View& view : views) {
    offsets.push_back(view.eye - View{}.eye);
  }
  return offsets;
}

TEST(ViewCell, sphereHasTwentyPlacesOnItThatAreSpreadEvenly) {
  ViewCell cell{1.6f, ViewCell::Shape::kSphere};
  const std::vector<glm::vec3> offsets = offsetsOf(cell.edgeViews(View{}));
  ASSERT_EQ(offsets.size(), 20u);
  glm::vec3 sum(0);
  for (const glm::vec3& a : offsets) {
    EXPECT_NEAR(glm::length(a), 0.8f, 5e-6f);
    sum += a;
    // Each corner of a dodecahedron has three neighbours, 4 / (sqrt(3) (1 + sqrt(5))) radii away.
    const float edge = 0.8f * 4 / (std::sqrt(3.0f) * (1 + std::sqrt(5.0f)));
    int neighbours = 0;
    for (const glm::vec3& b : offsets) {
      neighbours += std::abs(glm::distance(a, b) - edge) < 1e-5f;
      EXPECT_TRUE(glm::distance(a, b) < 1e-5f || glm::distance(a, b) > edge - 1e-5f);
    }
    EXPECT_EQ(neighbours, 3);
  }
  EXPECT_LT(glm::length(sum), 2e-5f);
}

TEST(ViewCell, insideOfASphereStaysInIt) {
  const ViewCell cell{1.0f, ViewCell::Shape::kSphere};
  const std::vector<glm::vec3> offsets = offsetsOf(cell.interiorViews(View{}, 400, 3));
  ASSERT_EQ(offsets.size(), 400u);
  float mean = 0;
  for (const glm::vec3& offset : offsets) {
    EXPECT_LE(glm::length(offset), 0.5f + 2e-6f);
    mean += glm::length(offset) / 400;
  }
  // The mean radius of uniform points in a ball is 3/4 of its own, with a deviation of 0.194 / 20 of it here.
  EXPECT_NEAR(mean, 0.375f, 0.5f * 5 * 0.194f / 20);
}

TEST(ViewCell, segmentLiesAlongItsDirection) {
  const ViewCell cell{2, ViewCell::Shape::kSegment, {0, 3, 4}};  // 3, 4, 5: a unit vector of 0, 0.6, 0.8
  const std::vector<glm::vec3> ends = offsetsOf(cell.edgeViews(View{}));
  ASSERT_EQ(ends.size(), 2u);
  EXPECT_LT(glm::distance(ends[0], glm::vec3(0, 0.6f, 0.8f)), 2e-6f);
  EXPECT_LT(glm::distance(ends[1], glm::vec3(0, -0.6f, -0.8f)), 2e-6f);
  for (const glm::vec3& offset : offsetsOf(cell.interiorViews(View{}, 50, 3))) {
    EXPECT_LE(glm::length(offset), 1 + 2e-6f);
    EXPECT_LT(glm::length(glm::cross(offset, ends[0])), 2e-6f);
  }
  EXPECT_EQ(cell.directions(7, 1).size(), 2u) << "there are no others";
}

TEST(ViewCell, segmentRunsAlongTheViewsRightUnlessToldOtherwise) {
  const ViewCell cell{1, ViewCell::Shape::kSegment};
  EXPECT_LT(glm::distance(offsetsOf(cell.edgeViews(View{}))[0], glm::vec3(0.5f, 0, 0)), 1e-6f);
}

TEST(ViewCell, directionsAreSeededUnitVectors) {
  const ViewCell cell;
  const std::vector<glm::vec3> directions = cell.directions(200, 5);
  ASSERT_EQ(directions.size(), 200u);
  EXPECT_EQ(directions, cell.directions(200, 5));
  EXPECT_NE(directions, cell.directions(200, 6));
  glm::vec3 sum(0);
  for (const glm::vec3& direction : directions) {
    EXPECT_NEAR(glm::length(direction), 1, 1e-6f);
    sum += direction;
  }
  // Each component has a deviation of sqrt(1/3); five of them for the mean of 200.
  EXPECT_LT(glm::length(sum / 200.0f), 5 * std::sqrt(1.0f / 200));
  EXPECT_TRUE(cell.directions(0, 5).empty());
}

TEST(ViewCell, aCellWithoutExtentIsTheReferenceViewpoint) {
  for (const auto shape : {ViewCell::Shape::kCube, ViewCell::Shape::kSphere, ViewCell::Shape::kSegment}) {
    for (const glm::vec3& offset : offsetsOf(ViewCell{0, shape}.edgeViews(View{}))) {
      EXPECT_EQ(offset, glm::vec3(0));
    }
  }
}

TEST(CellShape, namesAreReadBack) {
  for (const auto shape : {ViewCell::Shape::kCube, ViewCell::Shape::kSphere, ViewCell::Shape::kSegment}) {
    EXPECT_EQ(cellShapeFromName(cellShapeName(shape), "--cell-shape"), shape);
  }
  EXPECT_THROW(cellShapeFromName("ball", "--cell-shape"), InputError);
  EXPECT_THROW(cellShapeFromName("", "--cell-shape"), InputError);
}

}  // namespace
}  // namespace ocelli
