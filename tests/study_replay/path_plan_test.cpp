#include "study/replay/path_plan.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>

#include "oc_core/base/error.h"
#include "tests/base/temporary_folder.h"
#include "tests/study_replay/made_log.h"

namespace ocelli {
namespace {

using testing::HasSubstr;
using testing::SizeIs;

PathPlan planOfExample(size_t example, uint64_t seed) {
  const test::TaskExample& of = test::taskExamples()[example];
  const auto block = test::readBlock(of.task, of.json);
  return pathPlanOf(*block, test::madeLog(*block, of, seed), "a title");
}

TEST(PathPlan, hasThePathTheObjectAndItsWay) {
  const PathPlan still = planOfExample(0, 2);
  ASSERT_TRUE(still.maze.has_value());
  ASSERT_THAT(still.objects, SizeIs(1));
  EXPECT_THAT(still.objects[0].places, SizeIs(1));
  EXPECT_FALSE(still.path.empty());
  const glm::vec3 place = still.maze->centerOf({2, 3});
  EXPECT_NEAR(still.objects[0].places[0].x, static_cast<double>(place.x), 1e-4);
  EXPECT_NEAR(still.objects[0].places[0].y, static_cast<double>(place.z), 1e-4);
  const PathPlan moving = planOfExample(1, 2);
  EXPECT_EQ(moving.objects[0].places.size(), moving.path.size());
}

TEST(PathPlan, hasNoPathWhereNobodyWalked) {
  const PathPlan count = planOfExample(2, 2);
  EXPECT_THAT(count.objects, SizeIs(4));
}

TEST(PathPlan, isDrawnFromItsStartToItsLastClick) {
  const PathPlan plan = planOfExample(0, 2);
  std::map<std::string, int> parts;
  const Figure figure = pathPlanFigure(plan);
  for (const Shape& shape : figure.drawing.shapes()) {
    ++parts[shape.part];
  }
  EXPECT_EQ(parts["object"], 1);
  EXPECT_EQ(parts["object's way"], 0) << "it stands still";
  EXPECT_EQ(parts["start"], 4) << "in the maze and in the legend, each a box and a letter";
  EXPECT_GT(parts["walk"], 10);
  EXPECT_GT(parts["arrow"], 0);
  EXPECT_GE(parts["click"], static_cast<int>(plan.clicks.size()));
}

/// Whether tags close in the order in which they opened.
bool isWellFormed(const std::string& xml) {
  std::vector<std::string> open;
  for (size_t at = xml.find('<'); at != std::string::npos; at = xml.find('<', at + 1)) {
    const size_t end = xml.find('>', at);
    if (end == std::string::npos) {
      return false;
    }
    const std::string tag = xml.substr(at + 1, end - at - 1);
    const std::string name = tag.substr(0, tag.find_first_of(" \n/"));
    if (tag.starts_with("?") || tag.starts_with("!")) {
      continue;
    }
    if (tag.starts_with("/")) {
      if (open.empty() || open.back() != tag.substr(1)) {
        return false;
      }
      open.pop_back();
    } else if (!tag.ends_with("/")) {
      open.push_back(name);
    }
  }
  return open.empty();
}

TEST(PathPlan, isAWellFormedSvg) {
  const test::TemporaryFolder folder;
  for (size_t example = 0; example < test::taskExamples().size(); ++example) {
    writePathPlan(folder / "plan.svg", planOfExample(example, 3));
    const std::string svg = test::fileBytes(folder / "plan.svg");
    EXPECT_THAT(svg, HasSubstr("<svg"));
    EXPECT_TRUE(isWellFormed(svg)) << test::taskExamples()[example].name;
  }
  EXPECT_FALSE(isWellFormed("<a><b></a>"));
}

TEST(PathPlan, isAPngWhereTheNameSaysSo) {
  const test::TemporaryFolder folder;
  writePathPlan(folder / "plan.png", planOfExample(0, 3));
  EXPECT_GT(readPng(folder / "plan.png").width(), 900);
  EXPECT_THROW(writePathPlan(folder / "plan.pdf", planOfExample(0, 3)), InputError);
  EXPECT_THROW(writePathPlan(folder / "plan.svg", PathPlan{}), InputError);
}

}  // namespace
}  // namespace ocelli
