// Labels of feeds in the image: each can be read.
#include "oc_core/feeds_live/feed_labels.h"

#include <gtest/gtest.h>

#include "tests/feeds/made_setup.h"

namespace ocelli {
namespace {

bool areApart(const FeedLabelBox& a, const FeedLabelBox& b) {
  return a.left >= b.left + b.width || b.left >= a.left + a.width || a.top >= b.top + b.height ||
         b.top >= a.top + a.height;
}

TEST(FeedLabelBoxes, coverNoOtherAndStayInTheImage) {
  const FeedLabel moved{FeedState::kLate, true, 12.4, "MOVED 14 px"};
  for (const FeedSetup& setup : {test::tSetup(), test::chainSetup()}) {
    const FeedGraph graph(setup);
    const std::vector<FeedLabelBox> boxes = feedLabelBoxes(graph, std::vector<FeedLabel>(graph.frusta(), moved));
    ASSERT_EQ(boxes.size(), graph.frusta());
    for (size_t i = 0; i < boxes.size(); ++i) {
      EXPECT_GE(boxes[i].left, 0);
      EXPECT_LE(boxes[i].left + boxes[i].width, setup.output.width);
      EXPECT_LE(boxes[i].top + boxes[i].height, setup.output.height);
      for (size_t j = 0; j < i; ++j) {
        EXPECT_TRUE(areApart(boxes[i], boxes[j])) << i << " and " << j;
      }
    }
  }
}

TEST(FeedLabelBoxes, areAtTheirPartsWhereThereIsRoom) {
  const FeedGraph graph(test::tSetup());
  const FeedLabel good{FeedState::kLive, true, 0.033};
  const std::vector<FeedLabelBox> boxes = feedLabelBoxes(graph, {good, good, good});
  for (size_t i = 0; i < boxes.size(); ++i) {
    double left = 1e9;
    for (const glm::dvec2& p : graph.camera().frusta()[i].part) {
      left = std::min(left, static_cast<double>(p.x));
    }
    EXPECT_NEAR(boxes[i].left, left, 1) << i;
  }
  EXPECT_EQ(boxes[1].top, boxes[2].top) << "two short labels stand side by side";
}

}  // namespace
}  // namespace ocelli
