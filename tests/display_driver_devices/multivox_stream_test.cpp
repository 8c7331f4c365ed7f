// Frames stream while readers copy what is shown as the display's simulator does, and while the display comes and goes.
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <random>
#include <thread>

#include "display_driver/devices/multivox_device.h"
#include "tests/display_driver_devices/acted_display.h"
#include "tests/display_driver_devices/numbered_frames.h"

namespace ocelli {
namespace {

using namespace std::chrono_literals;
using test::ActedDisplay;
using Clock = std::chrono::steady_clock;

/// What a numbered volume is in the grid: cells beyond the screen's reach are dark.
class Frames {
 public:
  Frames() {
    VoxelResampler resampler(profile(), {});
    resampler.update(volume(255), std::nullopt, kMaxShownBits);
    mask_.assign(resampler.cells().begin(), resampler.cells().end());
  }
  static const DisplayProfile& profile() {
    static const DisplayProfile profile = test::numberedProfile();
    return profile;
  }
  static Volume volume(uint8_t number) { return test::numberedVolume(profile(), number); }

  std::vector<uint8_t> cells(uint8_t number) const {
    std::vector<uint8_t> cells = mask_;
    std::ranges::for_each(cells, [&](uint8_t& cell) { cell &= number; });
    return cells;
  }
  /// The number of the frame that these cells are, 0 for darkness; nullopt where they are no single frame.
  std::optional<uint8_t> numberOf(const std::vector<uint8_t>& cells) const {
    const uint8_t number = cells[VoxelGrid().index(70, 70, 30)];
    unsigned wrong = 0;
    for (size_t i = 0; i < cells.size(); ++i) {
      wrong |= static_cast<unsigned>(cells[i] ^ (mask_[i] & number));
    }
    return wrong == 0 ? std::optional(number) : std::nullopt;
  }

 private:
  std::vector<uint8_t> mask_;
};

/// Copies what is shown, over and over, in a thread of its own, and compares it with what was sent.
class Reader {
 public:
  /// With a pause a copy takes a quarter of the time that a page rests, and more where the machine is busy.
  Reader(const ActedDisplay& display, const Frames& frames, std::chrono::microseconds pause = {})
      : display_(display), frames_(frames), pause_(pause), thread_([this] { run(); }) {}
  ~Reader() { end(); }
  void end() {
    if (thread_.joinable()) {
      stop_ = true;
      thread_.join();
    }
  }

  int whole = 0;
  int torn = 0;       ///< copied in no longer than a page rests, and yet of two frames
  int slow = 0;       ///< copied in longer than that: nothing is promised
  int different = 0;  ///< frames seen, one after the other

 private:
  void run() {
    std::optional<uint8_t> before;
    while (!stop_) {
      const auto begin = Clock::now();
      const std::vector<uint8_t> copy = display_.shown(8, pause_);
      const auto took = Clock::now() - begin;
      const std::optional<uint8_t> number = frames_.numberOf(copy);
      if (took >= MultivoxMemory::kMinRest) {
        ++slow;
      } else if (number) {
        ++whole;
        different += before != number ? 1 : 0;
        before = number;
      } else {
        ++torn;
      }
    }
  }

  const ActedDisplay& display_;
  const Frames& frames_;
  std::chrono::microseconds pause_;
  std::atomic<bool> stop_ = false;
  std::thread thread_;
};

class MultivoxStream : public testing::Test {
 protected:
  std::shared_ptr<const FrameFence> send(Device& device) {
    last_ = test::frameNumberOf(sent_++);
    const auto fence = device.submit(Frames::volume(last_));
    device.present(fence->number(), {});
    return fence;
  }

  const Frames frames_;
  uint32_t sent_ = 0;
  uint8_t last_ = 0;
};

TEST_F(MultivoxStream, framesAreTheirNumbers) {
  VoxelResampler resampler(Frames::profile(), {});
  for (const int number : {1, 2, 3, 37, 128, 200, 255}) {
    resampler.update(Frames::volume(static_cast<uint8_t>(number)), std::nullopt, kMaxShownBits);
    const std::vector<uint8_t> cells(resampler.cells().begin(), resampler.cells().end());
    ASSERT_EQ(cells, frames_.cells(static_cast<uint8_t>(number)));
    EXPECT_EQ(frames_.numberOf(cells), number);
  }
}

TEST_F(MultivoxStream, aReaderTellsMixedFrames) {
  std::vector<uint8_t> cells = frames_.cells(5);
  cells[VoxelGrid().index(64, 20, 0)] = 6;
  EXPECT_EQ(frames_.numberOf(cells), std::nullopt);
}

constexpr auto kPause = 600us;

// The writer takes no time to make frames: only the rest keeps them apart.
TEST_F(MultivoxStream, readersThatTakeTheirTimeSeeWholePages) {
  const ActedDisplay display(test::uniqueObject(), {}, kMaxShownBits);
  MultivoxMemory memory(display.object(), {});
  ASSERT_EQ(memory.look(), MultivoxMemory::Found::kNew);
  Reader reader(display, frames_, kPause);
  for (uint8_t number = 1; number <= 60; ++number) {
    const std::vector<uint8_t> cells = frames_.cells(number);
    std::this_thread::sleep_until(memory.rested());
    ASSERT_TRUE(memory.write(cells) && memory.show());
  }
  reader.end();
  EXPECT_EQ(reader.torn, 0);
  EXPECT_GT(reader.whole, 0);
  std::printf("pages: %d copies whole, %d slower than the rest, %d frames seen\n", reader.whole, reader.slow,
              reader.different);
}

TEST_F(MultivoxStream, readersSeeWholeFramesAt24Hertz) {
  const ActedDisplay display(test::uniqueObject(), {}, kMaxShownBits);
  const std::unique_ptr<Device> device = openMultivox(display.object(), Frames::profile());
  Reader reader(display, frames_);
  auto next = Clock::now();
  for (int frame = 0; frame < 30; ++frame) {
    send(*device);
    next += 41667us;
    std::this_thread::sleep_until(next);
  }
  reader.end();
  EXPECT_EQ(reader.torn, 0);
  EXPECT_GT(reader.whole, 0);
  const Telemetry telemetry = device->telemetry();
  std::printf("24 Hz: %d copies whole, %d slower than the rest, %d frames seen; %d shown, %d dropped\n", reader.whole,
              reader.slow, reader.different, static_cast<int>(telemetry.framesShown),
              static_cast<int>(telemetry.framesDropped));
}

TEST_F(MultivoxStream, readersSeeWholeFramesAtTheFastestRate) {
  const ActedDisplay display(test::uniqueObject(), {}, kMaxShownBits);
  const std::unique_ptr<Device> device = openMultivox(display.object(), Frames::profile());
  Reader reader(display, frames_, kPause);
  const auto begin = Clock::now();
  constexpr int kFrames = 60;
  for (int frame = 0; frame < kFrames; ++frame) {
    ASSERT_EQ(send(*device)->wait(FrameStage::kShown, 20s).stage, FrameStage::kShown);
  }
  const double seconds = std::chrono::duration<double>(Clock::now() - begin).count();
  reader.end();
  EXPECT_EQ(reader.torn, 0);
  EXPECT_GT(reader.whole, 0);
  EXPECT_GE(seconds, (kFrames - 1) * 0.02) << "pages did not rest";
  EXPECT_EQ(frames_.numberOf(display.shown()), last_);
  std::printf("fastest: %.1f frames/s; %d copies whole, %d slower than the rest, %d frames seen\n", kFrames / seconds,
              reader.whole, reader.slow, reader.different);
}

TEST_F(MultivoxStream, moreThanTheFastestRateIsDroppedAndTheNewestShown) {
  const ActedDisplay display(test::uniqueObject(), {}, kMaxShownBits);
  const std::unique_ptr<Device> device = openMultivox(display.object(), Frames::profile());
  Reader reader(display, frames_);
  std::vector<std::shared_ptr<const FrameFence>> fences;
  for (int frame = 0; frame < 300; ++frame) {
    fences.push_back(send(*device));
    std::this_thread::sleep_for(2ms);
  }
  EXPECT_EQ(fences.back()->wait(FrameStage::kShown, 20s).stage, FrameStage::kShown);
  reader.end();
  EXPECT_EQ(reader.torn, 0);
  EXPECT_EQ(frames_.numberOf(display.shown()), last_);
  const Telemetry telemetry = device->telemetry();
  EXPECT_EQ(telemetry.framesShown + telemetry.framesDropped, 300u);
  EXPECT_GT(telemetry.framesDropped, 0u);
  for (const auto& fence : fences) {
    EXPECT_TRUE(hasEnded(fence->state().stage));
  }
}

TEST_F(MultivoxStream, theDisplayIsRestartedWhileFramesStream) {
  ActedDisplay display(test::uniqueObject(), {}, kMaxShownBits);
  const std::unique_ptr<Device> device = openMultivox(display.object(), Frames::profile());
  std::mt19937 engine(5);
  for (int restart = 0; restart < 12; ++restart) {
    for (auto frame = engine() % 30; frame > 0; --frame) {
      send(*device);
      std::this_thread::sleep_for(std::chrono::microseconds(engine() % 4000));
    }
    display.restart();
    const auto fence = send(*device);
    ASSERT_EQ(fence->wait(FrameStage::kShown, 20s).stage, FrameStage::kShown);
    // It may have been shown by the object that is gone; then it is shown again by this one.
    const auto end = Clock::now() + 20s;
    while (frames_.numberOf(display.shown()) != last_) {
      ASSERT_LT(Clock::now(), end) << "nothing is shown after restart " << restart;
      std::this_thread::sleep_for(1ms);
    }
  }
  const Telemetry telemetry = device->telemetry();
  EXPECT_EQ(telemetry.framesShown + telemetry.framesDropped, telemetry.framesSubmitted);
}

TEST_F(MultivoxStream, theMemoryIsTruncatedWhileFramesStream) {
  // Truncation takes the bits shown away; until the display sets them again, they count as the two it begins with.
  constexpr int kBits = 2;
  ActedDisplay display(test::uniqueObject(), {}, kBits);
  const std::unique_ptr<Device> device = openMultivox(display.object(), Frames::profile());
  std::mt19937 engine(6);
  std::atomic<bool> stop = false;
  std::thread truncating([&] {
    while (!stop) {
      display.resize(engine() % 2 == 0 ? 0 : engine() % multivoxBytes({}));
      std::this_thread::sleep_for(std::chrono::microseconds(engine() % 300));
      display.resize(multivoxBytes({}));
      std::this_thread::sleep_for(std::chrono::microseconds(engine() % 60000));
    }
  });
  for (int frame = 0; frame < 250; ++frame) {
    send(*device);
    std::this_thread::sleep_for(3ms);
  }
  stop = true;
  truncating.join();
  const auto fence = send(*device);
  ASSERT_EQ(fence->wait(FrameStage::kShown, 20s).stage, FrameStage::kShown);
  VoxelResampler resampler(Frames::profile(), {});
  resampler.update(Frames::volume(last_), std::nullopt, kBits);
  EXPECT_TRUE(std::ranges::equal(display.shown(), resampler.cells()));
  const Telemetry telemetry = device->telemetry();
  EXPECT_GT(telemetry.framesShown, 0u);
  std::printf("truncated: %d of %d frames shown, %d reconnections\n", static_cast<int>(telemetry.framesShown),
              static_cast<int>(telemetry.framesSubmitted), static_cast<int>(telemetry.reconnections));
}

}  // namespace
}  // namespace ocelli
