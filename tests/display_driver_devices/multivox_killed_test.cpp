// A writer that is killed at any instant leaves a whole frame shown, and nothing that would hinder the next writer.
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <random>
#include <thread>

#include "tests/display_driver_devices/acted_display.h"
#include "tests/display_driver_devices/numbered_frames.h"

namespace ocelli {
namespace {

using test::ActedDisplay;

class Writer {
 public:
  Writer(const char* kind, const std::string& object, int first) {
    const std::string number = std::to_string(first);
    process_ = fork();
    if (process_ == 0) {
      execl(OCELLI_WRITER_CHILD, OCELLI_WRITER_CHILD, kind, object.c_str(), number.c_str(), nullptr);
      _exit(127);
    }
  }
  /// Returns whether it still ran.
  bool kill() {
    ::kill(process_, SIGKILL);
    int status = 0;
    EXPECT_EQ(waitpid(process_, &status, 0), process_);
    return WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL;
  }

 private:
  pid_t process_ = -1;
};

/// Cells of the cylinder that the screen sweeps; those outside stay dark where a device writes.
std::vector<uint8_t> within(const ActedDisplay& display, const uint8_t* page) {
  std::vector<uint8_t> cells;
  const VoxelGrid& grid = display.grid();
  for (int x = 0; x < grid.x; ++x) {
    for (int y = 0; y < grid.y; ++y) {
      const glm::dvec3 center = grid.cellCenter(x, y, 0);
      if (center.x * center.x + center.z * center.z < 0.9) {
        cells.insert(cells.end(), page + grid.index(x, y, 0), page + grid.index(x, y, 0) + grid.z);
      }
    }
  }
  return cells;
}

void killMany(const char* kind, int kills) {
  const ActedDisplay display(test::uniqueObject(), {}, 3);
  std::mt19937 engine(11);
  int torn = 0;
  for (int kill = 0; kill < kills; ++kill) {
    const int before = display.shownPage();
    Writer writer(kind, display.object(), kill * 7);
    // Each writer comes to show frames after those that were killed before it.
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(20);
    while (display.shownPage() == before && std::chrono::steady_clock::now() < end) {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    ASSERT_NE(display.shownPage(), before) << kind << " shows nothing after kill " << kill;
    std::this_thread::sleep_for(std::chrono::microseconds(engine() % 60000));
    ASSERT_TRUE(writer.kill()) << "it ended on its own";
    const std::optional<uint8_t> shown = test::onlyNumber(within(display, display.page(display.shownPage())));
    ASSERT_TRUE(shown) << kind << ", kill " << kill << ": parts of two frames are shown";
    EXPECT_NE(*shown, 0);
    torn += test::onlyNumber(within(display, display.page(1 - display.shownPage()))) ? 0 : 1;
  }
  std::printf("%s: %d of %d kills within the write of a page\n", kind, torn, kills);
}

TEST(MultivoxKilled, writersToTheMemoryLeaveWholeFrames) {
  killMany("memory", 50);
}

TEST(MultivoxKilled, devicesLeaveWholeFrames) {
  killMany("device", 20);
}

}  // namespace
}  // namespace ocelli
