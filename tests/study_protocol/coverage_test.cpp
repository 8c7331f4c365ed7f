// What the views of the protocols that come with the program show of their mazes. At 1024 x 640 pixels, which have the
// shape of 1920 x 1200: the same cameras, with fewer pixels.
#include "study/protocol/coverage.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "oc_core/camera/view.h"

namespace ocelli::test {
namespace {

constexpr TrialScreen kCoverageScreen{1024, 640, 60};

Protocol shippedProtocol(const std::string& name) {
  return readProtocol(std::filesystem::path(OCELLI_SOURCE_DIR "/protocols") / (name + ".json"));
}

/// Of the blocks whose names say so.
std::vector<BlockCoverage> coverageOfBlocks(const std::string& name, const std::string& part) {
  Protocol protocol = shippedProtocol(name);
  std::erase_if(protocol.blocks,
                [&](const ProtocolBlock& block) { return block.name.find(part) == std::string::npos; });
  return coverageOf(protocol, kCoverageScreen);
}

/// Metres above the floor from which the views of a block look at first.
std::set<double> eyeHeights(const TaskBlock& block, TrialView view) {
  std::set<double> heights;
  TrialPlan plan;
  plan.view = view;
  const std::unique_ptr<TrialRun> run = block.start(plan, kCoverageScreen);
  for (const TrialLayout::View& each : run->layout().views) {
    if (const auto* graph = std::get_if<GraphCamera>(&each.camera)) {
      for (const GraphCamera::Frustum& frustum : graph->frusta()) {
        heights.insert(std::round(frustum.viewpoint.y * 1000) / 1000);
      }
    } else {
      heights.insert(std::round(static_cast<double>(std::get<PinholeCamera>(each.camera).eye().y) * 1000) / 1000);
    }
  }
  return heights;
}

TEST(Coverage, BothViewsOfCountingLookFromTheSameHeightsAtAllPlacesAndShowAnObjectAsLarge) {
  const std::vector<BlockCoverage> blocks = coverageOfBlocks("short", "count");
  ASSERT_EQ(blocks.size(), 1u);
  ASSERT_EQ(blocks[0].views.size(), 2u);
  const ViewCoverage& pinholes = blocks[0].views[0];
  const ViewCoverage& graph = blocks[0].views[1];
  EXPECT_EQ(pinholes.view, TrialView::kReference);
  EXPECT_EQ(pinholes.images, 8);
  EXPECT_EQ(graph.images, 1);
  for (const ViewCoverage* view : {&pinholes, &graph}) {
    EXPECT_EQ(view->places, 50);  // 24 cells beside the entrance, and 26 passages
    EXPECT_EQ(view->seen, 50);
    EXPECT_TRUE(view->unseen.empty());
  }
  EXPECT_EQ(graph.twice, 0);
  EXPECT_LE(pinholes.twice, 10);  // as in the protocol for replication
  // Medians to within 5 %: a quarter of what the least difference is that people see in areas.
  EXPECT_NEAR(medianOf(pinholes.pixels) / medianOf(graph.pixels), 1, 0.05);
  // What stays, as docs/experimenters.md says: the graph camera draws balls out.
  EXPECT_LT(medianOf(pinholes.stretches), 1.3);
  EXPECT_GT(medianOf(graph.stretches), medianOf(pinholes.stretches));
}

TEST(Coverage, DefaultProtocolsHaveTheSameViewsOfCounting) {
  const Protocol small = shippedProtocol("short");
  const Protocol balanced = shippedProtocol("rosen2010-balanced");
  const auto viewsOf = [](const Protocol& protocol, const std::string& name, TrialView view) {
    for (const ProtocolBlock& block : protocol.blocks) {
      if (block.name == name) {
        TrialPlan plan;
        plan.view = view;
        std::string text;
        for (const TrialLayout::View& each : block.task->start(plan, kCoverageScreen)->layout().views) {
          text += fmt::format("{} {} {};", each.place.left, each.place.top, each.place.width);
          if (const auto* graph = std::get_if<GraphCamera>(&each.camera)) {
            for (const GraphCamera::Frustum& frustum : graph->frusta()) {
              text += fmt::format("{} {} {};", frustum.viewpoint.x, frustum.viewpoint.y, frustum.viewpoint.z);
            }
          } else {
            text += jsonText(std::get<PinholeCamera>(each.camera).view());
          }
        }
        EXPECT_EQ(eyeHeights(*block.task, view), (std::set<double>{19.2}));
        return text;
      }
    }
    return std::string();
  };
  for (const TrialView view : kViews) {
    const std::string expected = viewsOf(small, "count", view);
    EXPECT_FALSE(expected.empty());
    EXPECT_EQ(viewsOf(balanced, "count stationary", view), expected);
    EXPECT_EQ(viewsOf(balanced, "count moving", view), expected);
  }
}

TEST(Coverage, ReplicationShowsAllPlacesFromOtherHeights) {
  const Protocol protocol = shippedProtocol("rosen2010");
  const std::vector<BlockCoverage> blocks = coverageOfBlocks("rosen2010", "count stationary");
  ASSERT_EQ(blocks.size(), 1u);
  for (const ViewCoverage& view : blocks[0].views) {
    EXPECT_EQ(view.seen, 50);
  }
  for (const ProtocolBlock& block : protocol.blocks) {
    if (block.name == blocks[0].block) {
      EXPECT_EQ(eyeHeights(*block.task, TrialView::kReference), (std::set<double>{2.2}));
      EXPECT_EQ(eyeHeights(*block.task, TrialView::kOther), (std::set<double>{19.2}));
    }
  }
}

TEST(Coverage, SeesTheThirdLocationOfTheReplicationFromTheStartThroughTheGraphCameraAlone) {
  const BlockCoverage find = coverageOfBlocks("rosen2010", "find stationary").at(0);
  EXPECT_TRUE(find.ofCases);
  const std::vector<std::string>& pinhole = find.views.at(0).unseen;
  const std::vector<std::string>& graph = find.views.at(1).unseen;
  EXPECT_NE(std::find(pinhole.begin(), pinhole.end(), "location 3"), pinhole.end());
  EXPECT_EQ(std::find(graph.begin(), graph.end(), "location 3"), graph.end());
}

TEST(Coverage, DefaultProtocolsHaveNothingToFindInSightAtTheStart) {
  for (const auto& [name, cases] : std::vector<std::pair<std::string, int>>{{"short", 3}, {"rosen2010-balanced", 12}}) {
    const BlockCoverage find = coverageOfBlocks(name, "find").at(0);
    for (const ViewCoverage& view : find.views) {
      EXPECT_EQ(view.places, cases);
      EXPECT_EQ(view.seen, 0) << name;
    }
  }
}

TEST(Coverage, FiveConditionsTakeCameraHeightAndImagesApart) {
  const Protocol protocol = shippedProtocol("counting-heights");
  const std::vector<BlockCoverage> blocks = coverageOf(protocol, kCoverageScreen);
  ASSERT_EQ(blocks.size(), 1u);
  struct Shown {
    const char* condition;
    int images;
    double height;
  };
  const std::vector<Shown> expected{{"pinholes-low", 8, 2.2},
                                    {"pinholes-high", 8, 19.2},
                                    {"graph-low", 1, 12},
                                    {"graph-high", 1, 19.2},
                                    {"top", 1, 19.2}};
  ASSERT_EQ(blocks[0].views.size(), expected.size());
  std::vector<double> medians;
  for (size_t i = 0; i < expected.size(); ++i) {
    const ViewCoverage& view = blocks[0].views[i];
    SCOPED_TRACE(expected[i].condition);
    EXPECT_EQ(protocol.nameOf(view.view), expected[i].condition);
    EXPECT_EQ(view.images, expected[i].images);
    EXPECT_EQ(eyeHeights(*protocol.blocks[0].task, view.view), (std::set<double>{expected[i].height}));
    EXPECT_EQ(view.seen, 50);
    medians.push_back(medianOf(view.pixels));
  }
  // Without a size that goes with the height: of both cameras together, low and high.
  EXPECT_NEAR((medians[0] + medians[2]) / (medians[1] + medians[3]), 1, 0.05);
  EXPECT_LT(*std::max_element(medians.begin(), medians.end()), 1.6 * *std::min_element(medians.begin(), medians.end()));
}

/// A hall of three cells that two pinholes look along.
TEST(Coverage, CountsWhatIsDrawn) {
  const Protocol protocol = protocolFromJsonText(R"({"name": "hall", "title": "Hall",
      "mazes": {"hall": {"plan": ["+-+-+-+", "|     |", "+ +-+-+"]}}, "blocks": [{"name": "count", "title": "Count",
      "task": "count", "maze": "hall", "least_answer": 1, "most_answer": 2, "cases": [{"objects": 1,
      "exposure_seconds": 1}], "pinholes": {"rows": 1, "columns": 2, "views": [
        {"row": 0, "column": 0, "heading": "east", "east": -0.4}, {"row": 0, "column": 2, "heading": "west",
        "east": -0.1}]}}]})",
                                                 "hall");
  const ViewCoverage pinholes = coverageOf(protocol, kCoverageScreen).at(0).views.at(0);
  // Two cells beside the entrance and two passages. The second looks west from the third cell, past its middle.
  EXPECT_EQ(pinholes.places, 4);
  EXPECT_EQ(pinholes.seen, 4);
  EXPECT_EQ(pinholes.twice, 3);
  EXPECT_EQ(pinholes.sightings, 7);
  ASSERT_EQ(pinholes.pixels.size(), 4u);
  EXPECT_TRUE(std::is_sorted(pinholes.pixels.begin(), pinholes.pixels.end()));
  EXPECT_EQ(medianOf(pinholes.pixels), static_cast<double>(pinholes.pixels[1] + pinholes.pixels[2]) / 2);
  // The farthest that the first alone sees: the middle of the last cell, from 7.2 m and 1.21 m above its middle.
  EXPECT_NEAR(pinholes.degreesDown.front(), std::atan2(1.6 - 0.39, 7.2) * 180 / std::acos(-1.0), 0.5);
}

}  // namespace
}  // namespace ocelli::test
