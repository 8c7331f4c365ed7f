#include "display_driver/demo/walk_demo.h"

#include <gtest/gtest.h>

#include <set>

#include "tests/base/temporary_folder.h"

namespace ocelli {
namespace {

TEST(WalkDemo, showsAPlaceByThreeCameras) {
  const test::TemporaryFolder folder;
  DemoOptions options;
  options.width = 90;
  options.height = 60;
  const DemoScene scene =
      runWalkDemo("A maze", "builtin:maze,columns=3,rows=3", folder.path(), "maze", options, Progress());
  ASSERT_EQ(scene.rows.size(), 1U);
  const std::vector<DemoImage>& images = scene.rows.front().images;
  ASSERT_EQ(images.size(), 3U);
  std::set<std::string> different;
  for (const DemoImage& image : images) {
    EXPECT_EQ(image.width, 90);
    EXPECT_EQ(image.height, 60);
    EXPECT_FALSE(image.caption.empty());
    EXPECT_TRUE(different.insert(test::fileBytes(folder.path() / image.file)).second) << image.file;
  }
  EXPECT_TRUE(scene.figures.empty());
}

}  // namespace
}  // namespace ocelli
