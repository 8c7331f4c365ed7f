// The window on a (virtual) screen.
#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>

#include "oc_core/sea/sea_build.h"
#include "oc_core/sea_window/sea_window.h"
#include "tests/base/temporary_folder.h"
#include "tests/sea/made_sea.h"

namespace ocelli {
namespace {

TEST(SeaWindowRun, showsUntilItIsClosed) {
  if (std::getenv("DISPLAY") == nullptr) {
    GTEST_SKIP() << "no display: install xvfb";
  }
  const test::TemporaryFolder folder;
  const test::RoomImages images(test::gridPoses(3, 2, 0.15));
  buildSea(images, test::roomProxy(), test::settingsOf(images), folder / "room.sea");
  const SeaFile sea(folder / "room.sea");
  int turns = 0;
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(60);
  runSeaWindow(sea, "Ocelli: a test", [&] { return ++turns < 20 && std::chrono::steady_clock::now() < end; });
  EXPECT_EQ(turns, 20);
}

}  // namespace
}  // namespace ocelli
