#include "oc_core/pack/open_edges.h"

#include <gtest/gtest.h>

#include <glm/vec3.hpp>
#include <numeric>

#include "oc_core/pack/place_bits.h"
#include "oc_core/pack/rim_error.h"

namespace ocelli {
namespace {

std::vector<uint32_t> numbersTo(uint32_t count) {
  std::vector<uint32_t> numbers(count);
  std::iota(numbers.begin(), numbers.end(), 0U);
  return numbers;
}

TEST(OpenEdges, AreThoseWithoutAPassBack) {
  // A square of two triangles with a diagonal from 0 to 2.
  const std::vector<uint32_t> square{0, 1, 2, 0, 2, 3};
  EXPECT_EQ(openEdges(square, numbersTo(4)), (std::vector<OpenEdge>{{0, 1, 1}, {1, 2, 1}, {2, 3, 1}, {3, 0, 1}}));
  // The same with vertices of their own, at the same places.
  const std::vector<uint32_t> loose{0, 1, 2, 4, 5, 3};
  EXPECT_EQ(openEdges(loose, std::vector<uint32_t>{0, 1, 2, 3, 0, 2}),
            (std::vector<OpenEdge>{{0, 1, 1}, {1, 2, 1}, {2, 3, 1}, {3, 0, 1}}));
}

TEST(OpenEdges, CountPassesInOneDirection) {
  // Three triangles at the edge from 0 to 1, all in the same direction.
  const std::vector<OpenEdge> open = openEdges(std::vector<uint32_t>{0, 1, 2, 0, 1, 3, 0, 1, 4}, numbersTo(5));
  EXPECT_EQ(open.front(), (OpenEdge{0, 1, 3}));
  EXPECT_EQ(open.size(), 7U);
}

/// A strip: 0 1 2 below, 3 4 5 above. What is next to it shares 0, 1, 2.
TEST(OpenEdges, SharedOnesMustStayAndRimsMayChange) {
  const std::vector<uint32_t> strip{0, 1, 4, 0, 4, 3, 1, 2, 5, 1, 5, 4};
  const std::vector<uint32_t> places = numbersTo(6);
  const std::vector<OpenEdge> fine = openEdges(strip, places);
  const std::vector<uint8_t> isShared{1, 1, 1, 0, 0, 0};
  const auto keeps = [&](const std::vector<uint32_t>& coarse) {
    return keepsBorders(fine, openEdges(coarse, places), isShared);
  };
  EXPECT_TRUE(keeps(strip));
  // Without 4: the rim is shorter.
  EXPECT_TRUE(keeps({0, 1, 3, 1, 2, 5, 1, 5, 3}));
  // Without 1, which is shared.
  EXPECT_FALSE(keeps({0, 2, 5, 0, 5, 3}));
  // A triangle lost: a shared edge with it, or an edge opened within.
  EXPECT_FALSE(keeps({0, 4, 3, 1, 2, 5, 1, 5, 4}));
  EXPECT_FALSE(keepsBorders(fine, openEdges(std::vector<uint32_t>{0, 1, 4, 0, 4, 3}, places), isShared));
}

TEST(OpenEdges, AHoleThatWasNotThereIsFound) {
  // Four triangles around 4, closed below by the square 0 1 2 3: no edge is open.
  const std::vector<uint32_t> tent{0, 1, 4, 1, 2, 4, 2, 3, 4, 3, 0, 4, 0, 2, 1, 0, 3, 2};
  const std::vector<uint32_t> places = numbersTo(5);
  EXPECT_TRUE(openEdges(tent, places).empty());
  const std::vector<uint32_t> open(tent.begin() + 3, tent.end());
  EXPECT_FALSE(keepsBorders({}, openEdges(open, places), std::vector<uint8_t>(5, 0)));
  EXPECT_TRUE(keepsBorders({}, openEdges(tent, places), std::vector<uint8_t>(5, 0)));
}

TEST(PlaceNumbers, AreTheFirstVertexOfEachPlace) {
  const std::vector<glm::vec3> positions{{1, 2, 3}, {0, 0, 0}, {1, 2, 3}, {0, 0, 1}, {0, 0, 0}};
  EXPECT_EQ(placeNumbers(positions), (std::vector<uint32_t>{0, 1, 0, 3, 1}));
  EXPECT_TRUE(placeNumbers({}).empty());
}

/// A square hole with a vertex in the middle of each side, pulled out by a half.
TEST(RimErrors, AreMeasuredAgainstTheRimOrTheRadiusOfWhatWasClosed) {
  const std::vector<glm::vec3> positions{{-1, -1, 0}, {0, -1.5f, 0}, {1, -1, 0}, {1.5f, 0, 0},
                                         {1, 1, 0},   {0, 1.5f, 0},  {-1, 1, 0}, {-1.5f, 0, 0}};
  std::vector<OpenEdge> fine;
  for (uint32_t i = 0; i < 8; ++i) {
    fine.push_back({i, (i + 1) % 8, 1});
  }
  std::sort(fine.begin(), fine.end());
  const std::vector<OpenEdge> square{{0, 2, 1}, {2, 4, 1}, {4, 6, 1}, {6, 0, 1}};
  for (const uint32_t middle : {1U, 3U, 5U, 7U}) {
    EXPECT_FLOAT_EQ(RimErrors(positions, fine, square).errorAt(middle), 0.5f);
    EXPECT_NEAR(RimErrors(positions, fine, {}).errorAt(middle), 1.5f, 1e-5f);
  }
  EXPECT_EQ(RimErrors(positions, fine, square).errorAt(0), 0);
  EXPECT_EQ(RimErrors(positions, {}, {}).errorAt(0), 0);
}

}  // namespace
}  // namespace ocelli
