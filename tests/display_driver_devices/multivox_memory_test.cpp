#include "display_driver/devices/multivox_memory.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/mman.h>
#include <unistd.h>

#include <numeric>
#include <thread>

#include "tests/display_driver_devices/acted_display.h"

namespace ocelli {
namespace {

using test::ActedDisplay;
using Found = MultivoxMemory::Found;

constexpr VoxelGrid kSmall{.x = 8, .y = 8, .z = 4};

std::vector<uint8_t> cellsOf(const VoxelGrid& grid, uint8_t first) {
  std::vector<uint8_t> cells(grid.cells());
  std::iota(cells.begin(), cells.end(), first);
  return cells;
}

bool writeRested(MultivoxMemory& memory, const std::vector<uint8_t>& cells) {
  std::this_thread::sleep_until(memory.rested());
  return memory.write(cells);
}

TEST(MultivoxMemory, hasTheSizeOfTheDisplaysStructure) {
  EXPECT_EQ(multivoxBytes(VoxelGrid()), 2u * 128 * 128 * 64 + 8);
}

TEST(MultivoxMemory, isFoundWhenItAppears) {
  const std::string object = test::uniqueObject();
  MultivoxMemory memory(object, kSmall);
  EXPECT_EQ(memory.look(), Found::kNothing);
  EXPECT_NE(memory.problem().find(object), std::string::npos) << memory.problem();
  EXPECT_FALSE(memory.status());
  const ActedDisplay display(object, kSmall);
  EXPECT_EQ(memory.look(), Found::kNew);
  EXPECT_EQ(memory.problem(), "");
  EXPECT_EQ(memory.look(), Found::kSame);
}

TEST(MultivoxMemory, makesNoObjectOfItsOwn) {
  const std::string object = test::uniqueObject();
  MultivoxMemory memory(object, kSmall);
  memory.look();
  EXPECT_LT(shm_open(object.c_str(), O_RDONLY, 0), 0);
}

TEST(MultivoxMemory, writesThePageThatIsNotShownAndThenShowsIt) {
  const ActedDisplay display(test::uniqueObject(), kSmall);
  MultivoxMemory memory(display.object(), kSmall);
  ASSERT_EQ(memory.look(), Found::kNew);
  for (uint8_t frame = 1; frame < 5; ++frame) {
    const std::vector<uint8_t> before = display.shown();
    const int pageBefore = display.shownPage();
    const std::vector<uint8_t> cells = cellsOf(kSmall, frame);
    ASSERT_TRUE(writeRested(memory, cells));
    EXPECT_EQ(display.shownPage(), pageBefore);
    EXPECT_EQ(display.shown(), before);
    ASSERT_TRUE(memory.show());
    EXPECT_EQ(display.shownPage(), 1 - pageBefore);
    EXPECT_EQ(display.shown(), cells);
  }
}

TEST(MultivoxMemory, leavesWhatTheDriverTellsAsItIs) {
  ActedDisplay display(test::uniqueObject(), kSmall);
  display.setTelemetry(3, 612, 800);
  MultivoxMemory memory(display.object(), kSmall);
  ASSERT_EQ(memory.look(), Found::kNew);
  for (int look = 0; look < 2; ++look) {
    const std::optional<MultivoxStatus> status = memory.status();
    ASSERT_TRUE(status);
    EXPECT_EQ(status->shownPage, look);
    EXPECT_EQ(status->bitsPerChannel, 3);
    EXPECT_EQ(status->revolutionsPerMinute, 612);
    EXPECT_EQ(status->frameTime, std::chrono::microseconds(800));
    ASSERT_TRUE(writeRested(memory, cellsOf(kSmall, 1)) && memory.show());
  }
}

TEST(MultivoxMemory, aPageRestsAfterItWasShown) {
  ActedDisplay display(test::uniqueObject(), kSmall);
  MultivoxMemory memory(display.object(), kSmall);
  const auto opened = MultivoxMemory::Clock::now();
  ASSERT_EQ(memory.look(), Found::kNew);
  EXPECT_GE(memory.rested(), opened + MultivoxMemory::kMinRest) << "another writer may have changed pages just now";
  ASSERT_TRUE(writeRested(memory, cellsOf(kSmall, 1)));
  auto before = MultivoxMemory::Clock::now();
  ASSERT_TRUE(memory.show());
  EXPECT_GE(memory.rested(), before + MultivoxMemory::kMinRest);
  display.setTelemetry(2, 600, 25000);
  ASSERT_TRUE(writeRested(memory, cellsOf(kSmall, 2)));
  before = MultivoxMemory::Clock::now();
  ASSERT_TRUE(memory.show());
  EXPECT_GE(memory.rested(), before + std::chrono::milliseconds(50)) << "slow panels take longer";
}

TEST(MultivoxMemory, whatIsNotShownMayBeWrittenOver) {
  const ActedDisplay display(test::uniqueObject(), kSmall);
  MultivoxMemory memory(display.object(), kSmall);
  ASSERT_EQ(memory.look(), Found::kNew);
  ASSERT_TRUE(writeRested(memory, cellsOf(kSmall, 1)));
  ASSERT_TRUE(memory.write(cellsOf(kSmall, 2)));
  ASSERT_TRUE(memory.show());
  EXPECT_EQ(display.shown(), cellsOf(kSmall, 2));
}

TEST(MultivoxMemory, anyPageNumberButZeroIsPageOne) {
  ActedDisplay display(test::uniqueObject(), kSmall);
  display.setShownPage(7);
  MultivoxMemory memory(display.object(), kSmall);
  ASSERT_EQ(memory.look(), Found::kNew);
  ASSERT_TRUE(writeRested(memory, cellsOf(kSmall, 1)) && memory.show());
  EXPECT_EQ(display.shownPage(), 0);
  EXPECT_EQ(display.shown(), cellsOf(kSmall, 1));
}

TEST(MultivoxMemory, anObjectOfAnotherSizeIsRefusedAndNotTouched) {
  ActedDisplay display(test::uniqueObject(), kSmall);
  MultivoxMemory memory(display.object(), VoxelGrid{});
  EXPECT_EQ(memory.look(), Found::kNothing);
  EXPECT_NE(memory.problem().find("520 bytes instead of 2097160"), std::string::npos) << memory.problem();
  EXPECT_FALSE(memory.write(std::vector<uint8_t>(VoxelGrid().cells(), 1)));
  EXPECT_EQ(test::onlyNumber(display.shown()), 0);
}

TEST(MultivoxMemory, truncationIsNoticedAndDoesNotCrash) {
  ActedDisplay display(test::uniqueObject(), kSmall);
  MultivoxMemory memory(display.object(), kSmall);
  ASSERT_EQ(memory.look(), Found::kNew);
  ASSERT_TRUE(writeRested(memory, cellsOf(kSmall, 1)));
  display.resize(100);
  EXPECT_FALSE(memory.show());
  EXPECT_NE(memory.problem(), "");
  EXPECT_FALSE(memory.write(cellsOf(kSmall, 2)));
  EXPECT_EQ(memory.look(), Found::kNothing);
  display.resize(multivoxBytes(kSmall));
  EXPECT_EQ(memory.look(), Found::kNew);
  ASSERT_TRUE(writeRested(memory, cellsOf(kSmall, 3)) && memory.show());
  EXPECT_EQ(display.shown(), cellsOf(kSmall, 3));
}

TEST(MultivoxMemory, anObjectMadeAnewIsTaken) {
  ActedDisplay display(test::uniqueObject(), kSmall);
  MultivoxMemory memory(display.object(), kSmall);
  ASSERT_EQ(memory.look(), Found::kNew);
  display.restart();
  EXPECT_EQ(memory.look(), Found::kNew);
  ASSERT_TRUE(writeRested(memory, cellsOf(kSmall, 1)) && memory.show());
  EXPECT_EQ(display.shown(), cellsOf(kSmall, 1));
  shm_unlink(display.object().c_str());
  EXPECT_EQ(memory.look(), Found::kNothing);
}

TEST(MultivoxMemory, anotherWriterIsTold) {
  ActedDisplay display(test::uniqueObject(), kSmall);
  MultivoxMemory memory(display.object(), kSmall);
  ASSERT_EQ(memory.look(), Found::kNew);
  ASSERT_TRUE(writeRested(memory, cellsOf(kSmall, 1)) && memory.show());
  EXPECT_EQ(memory.problem(), "");
  display.setShownPage(static_cast<uint8_t>(1 - display.shownPage()));
  ASSERT_TRUE(writeRested(memory, cellsOf(kSmall, 2)) && memory.show());
  EXPECT_NE(memory.problem().find("another program"), std::string::npos) << memory.problem();
  ASSERT_TRUE(writeRested(memory, cellsOf(kSmall, 3)) && memory.show());
  EXPECT_EQ(memory.problem(), "");
}

}  // namespace
}  // namespace ocelli
