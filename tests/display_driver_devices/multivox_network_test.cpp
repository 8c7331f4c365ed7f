#include "display_driver/devices/multivox_network.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "display_driver/devices/multivox_device.h"
#include "oc_core/base/error.h"
#include "oc_core/base/random.h"
#include "tests/display_driver_devices/acted_receiver.h"

namespace ocelli {
namespace {

using namespace std::chrono_literals;
using test::ActedReceiver;
using testing::HasSubstr;

constexpr auto kLongNetworkWait = 20s;  // for what must happen; no test waits for it

/// Every frame differs from the others, and compresses badly.
Volume noiseOf(const DisplayProfile& profile, uint64_t number, int voxels = 3000) {
  Random random(number);
  Volume volume(profile);
  for (int i = 0; i < voxels; ++i) {
    volume.light(static_cast<int>(random.below(static_cast<size_t>(volume.slices()))),
                 static_cast<int>(random.below(static_cast<size_t>(volume.width()))),
                 static_cast<int>(random.below(static_cast<size_t>(volume.height()))),
                 1 + static_cast<unsigned>(random.below(7)));
  }
  return volume;
}

std::vector<uint8_t> gridOf(const Volume& volume, int shownBits = 2) {
  VoxelResampler resampler(volume.profile(), {});
  resampler.update(volume, std::nullopt, shownBits);
  return {resampler.cells().begin(), resampler.cells().end()};
}

template <class Condition>
bool happens(Condition&& condition) {
  const auto end = std::chrono::steady_clock::now() + kLongNetworkWait;
  while (!condition()) {
    if (std::chrono::steady_clock::now() > end) {
      return false;
    }
    std::this_thread::sleep_for(1ms);
  }
  return true;
}

std::shared_ptr<const FrameFence> ask(Device& device, const Volume& volume) {
  auto fence = device.submit(volume);
  device.present(fence->number(), {});
  return fence;
}

std::string refusalOf(const std::string& name) {
  try {
    openMultivox(name);
  } catch (const InputError& error) {
    return std::string("input: ") + error.what();
  } catch (const WorkError& error) {
    return std::string("work: ") + error.what();
  }
  return "";
}

TEST(MultivoxPlace, hostsAreToldFromSharedMemory) {
  for (const char* memory : {"", "vortex", "rotovox", "/any.thing:else"}) {
    EXPECT_FALSE(multivoxPlace(memory)) << memory;
  }
  const auto expect = [](const char* text, const char* host, int port, int bits) {
    const auto place = multivoxPlace(text);
    ASSERT_TRUE(place) << text;
    EXPECT_EQ(place->host.host, host);
    EXPECT_EQ(place->host.port, port);
    EXPECT_EQ(place->bitsPerChannel, bits);
  };
  expect("vortex.local", "vortex.local", 22104, 2);
  expect("vortex:", "vortex", 22104, 2);
  expect("vortex:99", "vortex", 99, 2);
  expect("192.168.0.7:22104,bits=3", "192.168.0.7", 22104, 3);
  expect("[::1]", "::1", 22104, 2);
  expect("[fe80::1]:7,bits=1", "fe80::1", 7, 1);
  for (const char* wrong : {"a:b", "a:0", "a:65536", "::1", "[::1", "[::1]7", ":7", "[]:7", "a.b,bits=4",
                            "a.b,bits=", "a.b,7", "a.b,", "a:1:2"}) {
    EXPECT_THROW(multivoxPlace(wrong), InputError) << wrong;
  }
}

TEST(MultivoxMessage, isALengthAndAGzipFileOfCells) {
  const VoxelGrid grid{.x = 4, .y = 3, .z = 5};
  std::vector<uint8_t> cells(grid.cells(), 0);
  const std::vector<uint8_t> dark = multivoxMessage(cells, grid);
  cells[grid.index(3, 1, 4)] = 0xe3;
  const std::vector<uint8_t> message = multivoxMessage(cells, grid);
  EXPECT_NE(message, dark);
  for (const std::vector<uint8_t>& each : {dark, message}) {
    ASSERT_GT(each.size(), 18u);
    EXPECT_EQ(std::vector<uint8_t>(each.begin(), each.begin() + 4), std::vector<uint8_t>(4, 0xff));
    EXPECT_EQ(each[4] << 24 | each[5] << 16 | each[6] << 8 | each[7], static_cast<int>(each.size()) - 8);
    EXPECT_EQ(each[8], 0x1f);  // the mark of gzip
    EXPECT_EQ(each[9], 0x8b);
    EXPECT_EQ(each[each.size() - 4], 4);  // bytes of content, at a gzip file's end: one cell
  }
}

TEST(MultivoxNetwork, whatCannotBeReachedIsSaidAtOpening) {
  EXPECT_THAT(
      refusalOf("no-such-host.invalid"),
      testing::AllOf(testing::StartsWith("input: "), HasSubstr("no-such-host.invalid"), HasSubstr("not known")));
  ActedReceiver receiver;
  const std::string place = receiver.place();
  receiver.end();
  EXPECT_THAT(refusalOf(place), testing::AllOf(testing::StartsWith("work: "), HasSubstr("refused"), HasSubstr(place)));
  EXPECT_THAT(refusalOf("vortex.local,bits=9"), HasSubstr("bits=1"));
}

TEST(MultivoxNetwork, theReceiverShowsWhatTheResamplerMakes) {
  const ActedReceiver receiver;
  const std::unique_ptr<Device> device = openMultivox(receiver.place() + ",bits=3");
  EXPECT_EQ(device->info().kind, "multivox");
  EXPECT_EQ(device->info().name, "127.0.0.1");
  EXPECT_THAT(device->info().link, HasSubstr("TCP"));
  for (uint64_t k = 1; k <= 3; ++k) {
    const Volume volume = k == 2 ? Volume(device->profile()) : noiseOf(device->profile(), k);
    const auto fence = ask(*device, volume);
    const FrameState state = fence->wait(FrameStage::kShown, kLongNetworkWait);
    ASSERT_EQ(state.stage, FrameStage::kShown) << state.problem;
    EXPECT_GT(state.bytes, 8u);
    EXPECT_TRUE(happens([&] { return receiver.messages() == k; }));
    EXPECT_EQ(receiver.shown(), gridOf(volume, 3));
  }
  EXPECT_EQ(receiver.complaint(), "");
  EXPECT_EQ(receiver.connections(), 1u);
  const Telemetry telemetry = device->telemetry();
  EXPECT_TRUE(telemetry.connected);
  EXPECT_EQ(telemetry.framesShown, 3u);
  EXPECT_EQ(telemetry.framesArrived, 3u);
  EXPECT_EQ(telemetry.reconnections, 0u);
  EXPECT_EQ(telemetry.lastProblem, "");
}

TEST(MultivoxNetwork, aFrameThatIsNotAskedForIsNotSent) {
  const ActedReceiver receiver;
  const std::unique_ptr<Device> device = openMultivox(receiver.place());
  const auto waits = device->submit(noiseOf(device->profile(), 1));
  EXPECT_EQ(waits->wait(FrameStage::kArrived, kLongNetworkWait).stage, FrameStage::kArrived);
  EXPECT_EQ(device->telemetry().bytesSent, 0u);
  const Volume volume = noiseOf(device->profile(), 2);
  EXPECT_EQ(ask(*device, volume)->wait(FrameStage::kShown, kLongNetworkWait).stage, FrameStage::kShown);
  EXPECT_EQ(waits->state().stage, FrameStage::kDropped);
  EXPECT_TRUE(happens([&] { return receiver.shown() == gridOf(volume); }));
  EXPECT_EQ(receiver.messages(), 1u);
}

TEST(MultivoxNetwork, aLostConnectionComesBackWithWhatWasShown) {
  ActedReceiver receiver;
  const std::unique_ptr<Device> device = openMultivox(receiver.place());
  const Volume volume = noiseOf(device->profile(), 1);
  ASSERT_EQ(ask(*device, volume)->wait(FrameStage::kShown, kLongNetworkWait).stage, FrameStage::kShown);
  receiver.end();
  EXPECT_TRUE(happens([&] { return !device->telemetry().connected; }));
  EXPECT_THAT(device->telemetry().lastProblem, HasSubstr("127.0.0.1"));
  const Volume next = noiseOf(device->profile(), 2);
  const auto waits = ask(*device, next);
  EXPECT_TRUE(happens([&] { return device->telemetry().lastProblem.find("refused") != std::string::npos; }));
  EXPECT_FALSE(hasEnded(waits->state().stage)) << "it waits for the display";
  receiver.start();
  EXPECT_EQ(waits->wait(FrameStage::kShown, kLongNetworkWait).stage, FrameStage::kShown);
  EXPECT_TRUE(happens([&] { return receiver.shown() == gridOf(next); }));
  const Telemetry telemetry = device->telemetry();
  EXPECT_TRUE(telemetry.connected);
  EXPECT_EQ(telemetry.reconnections, 1u);
  EXPECT_EQ(telemetry.framesLost, 0u);
}

TEST(MultivoxNetwork, aConnectionThatEndsWithinAMessageLosesNothing) {
  ActedReceiver receiver;
  const std::unique_ptr<Device> device = openMultivox(receiver.place());
  const Volume still = noiseOf(device->profile(), 1);
  ASSERT_EQ(ask(*device, still)->wait(FrameStage::kShown, kLongNetworkWait).stage, FrameStage::kShown);
  for (uint64_t k = 2; k <= 5; ++k) {
    receiver.dropAfter(1000 * k);
    const Volume volume = noiseOf(device->profile(), k);
    EXPECT_EQ(ask(*device, volume)->wait(FrameStage::kShown, kLongNetworkWait).stage, FrameStage::kShown);
    EXPECT_TRUE(happens([&] { return receiver.shown() == gridOf(volume); })) << k;
  }
  EXPECT_EQ(receiver.complaint(), "");
  EXPECT_GE(receiver.connections(), 5u);
}

TEST(MultivoxNetwork, aReceiverThatReadsNothingHoldsOneFrameBackAndGetsTheNewest) {
  ActedReceiver receiver;
  const std::unique_ptr<Device> device = openMultivox(receiver.place());
  ASSERT_EQ(ask(*device, noiseOf(device->profile(), 1))->wait(FrameStage::kShown, kLongNetworkWait).stage,
            FrameStage::kShown);
  receiver.setDeaf(true);
  // Each has more bytes than both machines buffer, so that it stays under way.
  constexpr int kManyVoxels = 200000;
  std::vector<std::shared_ptr<const FrameFence>> fences;
  for (uint64_t k = 0; k < 12; ++k) {
    fences.push_back(ask(*device, noiseOf(device->profile(), 100 + k, kManyVoxels)));
    std::this_thread::sleep_for(20ms);
  }
  const Volume newest = noiseOf(device->profile(), 7, kManyVoxels);
  fences.push_back(ask(*device, newest));
  EXPECT_TRUE(happens([&] { return device->telemetry().framesDropped >= 9; }));
  size_t kept = 0;
  for (const auto& fence : fences) {
    kept += hasEnded(fence->state().stage) ? 0 : 1;
  }
  EXPECT_LE(kept, 2u) << "one under way, one that waits";
  receiver.setDeaf(false);
  EXPECT_EQ(fences.back()->wait(FrameStage::kShown, kLongNetworkWait).stage, FrameStage::kShown);
  EXPECT_TRUE(happens([&] { return receiver.shown() == gridOf(newest); }));
  EXPECT_EQ(receiver.complaint(), "");
}

TEST(MultivoxNetwork, aConnectionThatTakesNothingCountsAsBroken) {
  ActedReceiver receiver;
  const DisplayProfile profile = loadProfile("vortex");
  MultivoxDevice device(std::make_unique<MultivoxNetwork>(*multivoxPlace(receiver.place()), VoxelGrid{}, 200ms),
                        profile);
  receiver.setDeaf(true);
  const Volume volume = noiseOf(profile, 1, 200000);
  const auto waits = ask(device, volume);
  EXPECT_TRUE(happens([&] { return device.telemetry().lastProblem.find("takes no bytes") != std::string::npos; }));
  receiver.setDeaf(false);
  EXPECT_EQ(waits->wait(FrameStage::kShown, kLongNetworkWait).stage, FrameStage::kShown);
  EXPECT_TRUE(happens([&] { return receiver.shown() == gridOf(volume); }));
  EXPECT_GE(device.telemetry().reconnections, 1u);
}

TEST(MultivoxNetwork, closesWithinASecondWhateverTheReceiverDoes) {
  ActedReceiver receiver;
  const std::unique_ptr<Device> device = openMultivox(receiver.place());
  receiver.setDeaf(true);
  const auto fence = ask(*device, noiseOf(device->profile(), 1, 200000));
  EXPECT_TRUE(
      happens([&] { return device->telemetry().bytesSent > 0 || fence->state().stage != FrameStage::kWaiting; }));
  std::this_thread::sleep_for(100ms);
  const auto begin = std::chrono::steady_clock::now();
  device->close();
  EXPECT_LT(std::chrono::steady_clock::now() - begin, 3s);  // half a second, and what a busy machine adds
  EXPECT_EQ(fence->state().stage, FrameStage::kLost);
}

TEST(MultivoxNetwork, whatAReceiverSaysIsPassedOver) {
  ActedReceiver receiver;
  const std::unique_ptr<Device> device = openMultivox(receiver.place());
  receiver.say(std::string(20000, '\xff'));
  const Volume volume = noiseOf(device->profile(), 1);
  EXPECT_EQ(ask(*device, volume)->wait(FrameStage::kShown, kLongNetworkWait).stage, FrameStage::kShown);
  EXPECT_TRUE(happens([&] { return receiver.shown() == gridOf(volume); }));
  EXPECT_EQ(device->telemetry().reconnections, 0u);
}

}  // namespace
}  // namespace ocelli
