#include "study/protocol/coverage.h"

#include <gtest/gtest.h>

namespace ocelli::test {
namespace {

std::vector<BlockCoverage> coverageOfShort() {
  const Protocol protocol = readProtocol(OCELLI_SOURCE_DIR "/protocols/short.json");
  return coverageOf(protocol, {960, 600, 60});
}

TEST(Coverage, ShowsEveryPlaceOnceInTheGraphCameraAndAllInThePinholes) {
  const std::vector<BlockCoverage> blocks = coverageOfShort();
  ASSERT_EQ(blocks.size(), 2u);  // paths show nothing to find or count
  EXPECT_TRUE(blocks[0].ofCases);
  ASSERT_EQ(blocks[1].views.size(), 2u);
  const ViewCoverage& pinholes = blocks[1].views[0];
  const ViewCoverage& graph = blocks[1].views[1];
  EXPECT_EQ(pinholes.view, TrialView::kReference);
  EXPECT_EQ(pinholes.images, 8);
  EXPECT_EQ(graph.images, 1);
  // 24 cells beside the entrance, and 26 passages.
  EXPECT_EQ(pinholes.places, 50);
  EXPECT_EQ(graph.places, 50);
  EXPECT_EQ(pinholes.seen, 50);
  EXPECT_GT(pinholes.twice, 0);
  EXPECT_EQ(graph.twice, 0);
  EXPECT_EQ(pinholes.seen + static_cast<int>(pinholes.unseen.size()), pinholes.places);
  EXPECT_EQ(graph.seen + static_cast<int>(graph.unseen.size()), graph.places);
}

TEST(Coverage, SeesTheThirdLocationFromTheStartThroughTheGraphCameraAlone) {
  const BlockCoverage find = coverageOfShort().at(0);
  const std::vector<std::string>& pinhole = find.views.at(0).unseen;
  const std::vector<std::string>& graph = find.views.at(1).unseen;
  EXPECT_NE(std::find(pinhole.begin(), pinhole.end(), "location 3"), pinhole.end());
  EXPECT_EQ(std::find(graph.begin(), graph.end(), "location 3"), graph.end());
}

}  // namespace
}  // namespace ocelli::test
