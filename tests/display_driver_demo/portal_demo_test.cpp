#include "display_driver/demo/portal_demo.h"

#include <gtest/gtest.h>

#include "oc_core/image/png_file.h"
#include "tests/base/temporary_folder.h"

namespace ocelli {
namespace {

TEST(PortalDemo, GraphCameraShowsOtherThingsThanThePinholeBesideADoor) {
  const test::TemporaryFolder folder;
  DemoOptions options;
  options.width = 90;
  options.height = 60;
  // In the corridor of the house, beside the door of its kitchen.
  const PortalDemoView view{{-4.8f, 1.6f, -0.4f}, {-7.4f, 1.5f, 0.85f}, "a corridor", "A chair.", "The kitchen."};
  const DemoScene scene = runPortalDemo("A house", "builtin:house", view, folder.path(), "house", options, {});
  ASSERT_EQ(scene.rows.size(), 1u);
  ASSERT_EQ(scene.rows[0].images.size(), 2u);
  EXPECT_TRUE(scene.figures.empty());
  EXPECT_EQ(scene.rows[0].images[1].caption, "The kitchen.");
  const Image<Rgb8> pinhole = readPng(folder.path() / scene.rows[0].images[0].file);
  const Image<Rgb8> graph = readPng(folder.path() / scene.rows[0].images[1].file);
  ASSERT_EQ(pinhole.size(), 90u * 60u);
  ASSERT_EQ(graph.size(), pinhole.size());
  size_t differing = 0;
  for (size_t i = 0; i < pinhole.size(); ++i) {
    differing += pinhole[i] == graph[i] ? 0 : 1;
  }
  // The doorway takes about 7 % of the image, and the rest is the pinhole's.
  EXPECT_GT(differing, pinhole.size() / 50);
  EXPECT_LT(differing, pinhole.size() / 5);
}

}  // namespace
}  // namespace ocelli
