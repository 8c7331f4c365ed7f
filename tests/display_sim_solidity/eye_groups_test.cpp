#include "display_sim/solidity/eye_groups.h"

#include <gtest/gtest.h>

namespace ocelli {
namespace {

TEST(EyesOfCell, areTheViewpointsOfTheCell) {
  const View view;
  const ViewCell cell{.sideRadii = 1};
  const std::vector<EyeGroup> groups = eyesOfCell(view, cell, 3, 7);
  ASSERT_EQ(groups.size(), 3u);
  EXPECT_EQ(groups[0].name, "reference");
  EXPECT_EQ(groups[0].eyes, std::vector{view.eye});
  EXPECT_EQ(groups[1].name, "edges");
  ASSERT_EQ(groups[1].eyes.size(), 20u);
  EXPECT_EQ(groups[1].eyes.back(), cell.edgeViews(view).back().eye);
  EXPECT_EQ(groups[2].name, "interior");
  ASSERT_EQ(groups[2].eyes.size(), 3u);
  EXPECT_EQ(groups[2].eyes[1], cell.interiorViews(view, 3, 7)[1].eye);
}

TEST(EyesOfCell, leaveOutWhatHasNoEye) {
  EXPECT_EQ(eyesOfCell({}, {}, 0, 1).size(), 2u);
}

}  // namespace
}  // namespace ocelli
