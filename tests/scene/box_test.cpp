#include "oc_core/scene/box.h"

#include <gtest/gtest.h>

#include <array>
#include <optional>

#include "oc_core/base/random.h"

namespace ocelli {
namespace {

const Box kBox{{-1, -1, -1}, {1, 2, 3}};

void expectPart(const std::optional<SegmentPart>& part, double first, double last) {
  ASSERT_TRUE(part.has_value());
  EXPECT_NEAR(part->first, first, 1e-12);
  EXPECT_NEAR(part->last, last, 1e-12);
}

TEST(Box, cornersInTheOrderOfTheirBits) {
  const std::array<glm::vec3, 8> corners = cornersOf(kBox);
  EXPECT_EQ(corners[0], kBox.lower);
  EXPECT_EQ(corners[1], glm::vec3(1, -1, -1));
  EXPECT_EQ(corners[2], glm::vec3(-1, 2, -1));
  EXPECT_EQ(corners[4], glm::vec3(-1, -1, 3));
  EXPECT_EQ(corners[7], kBox.upper);
  Box around;
  for (const glm::vec3& corner : corners) {
    around.add(corner);
    EXPECT_TRUE(contains(kBox, corner));
  }
  EXPECT_EQ(around.lower, kBox.lower);
  EXPECT_EQ(around.upper, kBox.upper);
}

TEST(Box, segmentsArePartlyWithin) {
  expectPart(partWithin(kBox, {-3, 0, 0}, {5, 0, 0}), 0.25, 0.5);
  expectPart(partWithin(kBox, {5, 0, 0}, {-3, 0, 0}), 0.5, 0.75);
  expectPart(partWithin(kBox, {0, 0, 0}, {0, 4, 0}), 0, 0.5);
  expectPart(partWithin(kBox, {0, 0, 0}, {0.5, 1, 2}), 0, 1);
  expectPart(partWithin(kBox, {-2, -3, 0}, {2, 5, 0}), 0.25, 0.625);
  EXPECT_FALSE(partWithin(kBox, {-3, 0, 0}, {-2, 0, 0})) << "ends before it";
  EXPECT_FALSE(partWithin(kBox, {2, 0, 0}, {3, 0, 0})) << "begins behind it";
  EXPECT_FALSE(partWithin(kBox, {-3, 2.5, 0}, {3, 2.5, 0})) << "passes beside it";
  EXPECT_FALSE(partWithin(kBox, {-3, 0, 0}, {0, 5, 0})) << "passes an edge";
}

TEST(Box, segmentsMayTouchIt) {
  expectPart(partWithin(kBox, {-3, 2, 0}, {5, 2, 0}), 0.25, 0.5);  // along a face
  expectPart(partWithin(kBox, {-3, 2, 3}, {5, 2, 3}), 0.25, 0.5);  // along an edge
  expectPart(partWithin(kBox, {-3, 0, 0}, {-1, 0, 0}), 1, 1);      // with an end
  expectPart(partWithin(kBox, {-2, 0, 0}, {0, -2, 0}), 0.5, 0.5);  // an edge
  expectPart(partWithin(kBox, {0, 3, 4}, {2, 1, 2}), 0.5, 0.5);    // a corner
}

TEST(Box, segmentsMayBePoints) {
  expectPart(partWithin(kBox, {0, 0, 0}, {0, 0, 0}), 0, 1);
  expectPart(partWithin(kBox, {1, 2, 3}, {1, 2, 3}), 0, 1);
  EXPECT_FALSE(partWithin(kBox, {0, 0, 4}, {0, 0, 4}));
}

TEST(Box, boxesMayBeFlatOrEmpty) {
  const Box flat{{-1, 0, -1}, {1, 0, 1}};
  expectPart(partWithin(flat, {0, 1, 0}, {0, -3, 0}), 0.25, 0.25);
  expectPart(partWithin(flat, {-2, 0, 0}, {2, 0, 0}), 0.25, 0.75);
  EXPECT_FALSE(partWithin(flat, {-2, 0.1, 0}, {2, 0.1, 0}));
  EXPECT_FALSE(partWithin(Box(), {-2, 0, 0}, {2, 0, 0}));
  EXPECT_FALSE(partWithin(Box(), {0, 0, 0}, {0, 0, 0}));
  EXPECT_FALSE(contains(Box(), {0, 0, 0}));
}

TEST(Box, segmentsMeetWhatTheyPass) {
  const Box box{{-1, -1, -1}, {1, 1, 1}};
  EXPECT_TRUE(meets(box, {-3, 0, 0}, {3, 0, 0}));
  EXPECT_TRUE(meets(box, {0, 0, 0}, {0.1f, 0, 0}));  // within
  EXPECT_FALSE(meets(box, {-3, 0, 0}, {-2, 0, 0}));  // ends before it
  EXPECT_FALSE(meets(box, {-3, 1.5f, 0}, {3, 1.5f, 0}));
  EXPECT_FALSE(meets(box, {-3, 0, 0}, {0, 3, 0}));  // past the edge
  EXPECT_TRUE(contains(box, {1, 1, -1}));
  EXPECT_FALSE(contains(box, {1, 1.1f, 0}));
}

TEST(Box, segmentsMeetAsTheirPointsDo) {
  Random random(6);
  const Box box{{-0.5f, -0.3f, -0.4f}, {0.2f, 0.4f, 0.6f}};
  size_t met = 0;
  for (int i = 0; i < 3000; ++i) {
    const auto point = [&] {
      const float x = random.inRange(-1, 1);
      const float y = random.inRange(-1, 1);
      return glm::vec3(x, y, random.inRange(-1, 1));
    };
    const glm::vec3 from = point();
    const glm::vec3 to = point();
    bool passes = false;
    for (int k = 0; k <= 400 && !passes; ++k) {
      passes = contains(box, from + (to - from) * (static_cast<float>(k) / 400));
    }
    met += passes;
    if (passes) {
      EXPECT_TRUE(meets(box, from, to));
    } else if (meets(box, from, to)) {
      // Between two of the points: only near the surface.
      const Box smaller{box.lower + 0.01f, box.upper - 0.01f};
      EXPECT_FALSE(meets(smaller, from, to));
    }
  }
  EXPECT_GT(met, 300u);
}

}  // namespace
}  // namespace ocelli
