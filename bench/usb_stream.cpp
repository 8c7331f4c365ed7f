// usb_stream: a scene that turns, streamed to an emulated display on an emulated USB. The driver is a process of its
// own, whose processor time is measured; the emulator compares what arrives with what was sent.
#include <fmt/format.h>
#include <sys/resource.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <glm/gtc/matrix_transform.hpp>
#include <map>
#include <mutex>
#include <thread>

#include "display_driver/emulator/client_process.h"
#include "display_driver/emulator/usb_emulator.h"
#include "display_driver/usb/usb_port.h"
#include "display_driver/wire/bandwidth_plan.h"
#include "display_driver/wire/stream_device.h"
#include "display_driver/wire/wire_format.h"
#include "display_sim/slicing/slicer.h"
#include "oc_core/base/conventions.h"
#include "oc_core/base/error.h"
#include "oc_core/worlds/scene_source.h"

namespace ocelli {
namespace {

using Clock = std::chrono::steady_clock;

struct Choice {
  std::string scene;
  std::string link = "usb2";
  double seconds = 10;
  double rate = 24;  ///< frames a second; 0: the next one when the last has arrived
  int volumes = 48;
  bool bare = false;
  std::string driver;  ///< the file with the checksums, in the process of the driver
};

uint32_t checksumOf(const Volume& volume) {
  uint32_t checksum = 0;
  for (int i = 0; i < volume.slices(); ++i) {
    checksum = wire::crc32c(volume.slice(i), checksum);
  }
  return checksum;
}

double processSeconds() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  const auto seconds = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

double secondsSince(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

std::vector<std::shared_ptr<const Volume>> slicedScene(const Choice& choice, const DisplayProfile& profile) {
  const Mesh mesh = orderedForSlicing(loadScene(choice.scene, {}, {}));
  Slicer slicer(profile, {});
  SliceMesh turned(mesh);
  std::vector<std::shared_ptr<const Volume>> volumes;
  for (int i = 0; i < choice.volumes; ++i) {
    const auto radians = static_cast<float>(radiansFromDegrees(i * 360.0 / choice.volumes));
    const glm::mat3 turn(glm::rotate(glm::mat4(1), radians, glm::vec3(0, 1, 0)));
    std::vector<glm::vec3> positions = mesh.positions;
    for (glm::vec3& position : positions) {
      position = turn * position;
    }
    turned.setPositions(positions);
    slicer.slice(turned);
    volumes.push_back(slicer.takeShared());
  }
  return volumes;
}

/// Transfers of 256 KiB, eight under way, of bytes that the display does not understand.
void streamBare(const Choice& choice) {
  UsbPort port({});
  const auto link = port.open();
  const std::vector<uint8_t> bytes(size_t{1} << 18, 0x55);
  std::atomic<size_t> sent = 0;
  std::atomic<bool> over = false;
  wire::LinkListener listener;
  listener.sent = [&](size_t tag, wire::LinkStatus, size_t count) {
    sent += count;
    if (!over) {
      link->send(tag, bytes);
    }
  };
  link->start(listener);
  const Clock::time_point start = Clock::now();
  const double before = processSeconds();
  for (size_t tag = 0; tag < 8; ++tag) {
    link->send(tag, bytes);
  }
  std::this_thread::sleep_for(std::chrono::duration<double>(choice.seconds));
  over = true;
  const double wall = secondsSince(start);
  link->close();
  fmt::print("bare link: {:.1f} MB/s, {:.0f} % of a core\n", static_cast<double>(sent) / wall / 1e6,
             100 * (processSeconds() - before) / wall);
}

void drive(const Choice& choice) {
  if (choice.bare) {
    streamBare(choice);
    return;
  }
  const auto device = openStreamDevice(std::make_unique<UsbPort>(UsbPortOptions()), {.kind = "usb"});
  const std::vector<std::shared_ptr<const Volume>> volumes = slicedScene(choice, device->profile());
  std::vector<uint32_t> checksums;
  for (const auto& volume : volumes) {
    checksums.push_back(checksumOf(*volume));
  }
  const double idleBefore = processSeconds();
  std::this_thread::sleep_for(std::chrono::seconds(2));
  const double idle = (processSeconds() - idleBefore) / 2;

  std::vector<std::shared_ptr<const FrameFence>> fences;
  std::vector<Clock::time_point> times;
  const Clock::time_point start = Clock::now();
  const double before = processSeconds();
  while (secondsSince(start) < choice.seconds) {
    times.push_back(Clock::now());
    fences.push_back(device->submit(volumes[fences.size() % volumes.size()]));
    device->present(fences.back()->number(), {});
    if (choice.rate > 0) {
      std::this_thread::sleep_until(start +
                                    std::chrono::duration<double>(static_cast<double>(fences.size()) / choice.rate));
    } else if (fences.size() > 1) {
      fences[fences.size() - 2]->wait(FrameStage::kArrived, std::chrono::seconds(5));
    }
  }
  fences.back()->wait(FrameStage::kArrived, std::chrono::seconds(5));
  const double wall = secondsSince(start);
  const double busy = (processSeconds() - before) / wall;
  const Telemetry telemetry = device->telemetry();
  device->close();

  std::ofstream file(choice.driver);
  std::vector<double> latencies;
  double bytes = 0;
  for (size_t i = 0; i < fences.size(); ++i) {
    const FrameState state = fences[i]->state();
    file << fences[i]->number() << ' ' << checksums[i % volumes.size()] << '\n';
    bytes += static_cast<double>(state.bytes);
    if (state.arrived != Clock::time_point()) {
      latencies.push_back(std::chrono::duration<double, std::milli>(state.arrived - times[i]).count());
    }
  }
  std::ranges::sort(latencies);
  const auto at = [&](double share) {
    return latencies.empty() ? 0 : latencies[static_cast<size_t>(share * static_cast<double>(latencies.size() - 1))];
  };
  fmt::print(
      "{} frames of {:.1f} MB in {:.2f} s: {:.1f} frames/s, {} arrived, {} dropped, {} lost, {} underruns\n"
      "{:.2f} MB a frame on the link, {:.1f} MB/s; from submission to arrival {:.1f} ms (median), {:.1f} ms (99 %)\n"
      "the driver's process takes {:.0f} % of a core, of which {:.0f} % to ask an emulated USB, idle\n",
      fences.size(), static_cast<double>(volumes[0]->slices() * volumes[0]->slice(0).size()) / 1e6, wall,
      static_cast<double>(telemetry.framesArrived) / wall, telemetry.framesArrived, telemetry.framesDropped,
      telemetry.framesLost, telemetry.underruns,
      bytes / static_cast<double>(std::max<size_t>(1, telemetry.framesArrived)) / 1e6,
      static_cast<double>(telemetry.bytesSent) / wall / 1e6, at(0.5), at(0.99), 100 * busy, 100 * idle);
}

class Checksums : public ArrivalSink {
 public:
  void frameArrived(uint32_t /*session*/, uint32_t frame, const Volume& volume) override {
    const std::lock_guard lock(mutex_);
    arrived_.emplace_back(frame, checksumOf(volume));
  }
  std::vector<std::pair<uint32_t, uint32_t>> arrived() const {
    const std::lock_guard lock(mutex_);
    return arrived_;
  }

 private:
  mutable std::mutex mutex_;
  std::vector<std::pair<uint32_t, uint32_t>> arrived_;
};

int emulate(const Choice& choice, std::vector<std::string> arguments) {
  UsbEmulator::requirePreloaded();
  EmulatedUsbDisplay display;
  display.device.firmware.profile = loadProfile("perspecta");
  display.device.bytesPerSecond = choice.link == "unlimited" ? 0 : wire::plannedLink(choice.link).bytesPerSecond;
  Checksums checksums;
  UsbEmulator emulator({display});
  emulator.use(0, [&](EmulatedDevice& device, DeviceMicroseconds) { device.firmware().setArrivalSink(&checksums); });
  const std::filesystem::path sums =
      std::filesystem::temp_directory_path() / fmt::format("usb_stream_{}.txt", ::getpid());
  arguments.insert(arguments.end(), {"--driver", sums.string()});
  const int code = runClient(arguments, emulator.environment());
  emulator.use(0, [](EmulatedDevice& device, DeviceMicroseconds) { device.firmware().setArrivalSink(nullptr); });
  std::ifstream file(sums);
  std::map<uint32_t, uint32_t> sent;
  for (uint32_t frame = 0, sum = 0; file >> frame >> sum;) {
    sent[frame] = sum;
  }
  std::filesystem::remove(sums);
  size_t right = 0;
  const auto arrived = checksums.arrived();
  for (const auto& [frame, sum] : arrived) {
    const auto found = sent.find(frame);
    right += found != sent.end() && found->second == sum ? 1 : 0;
  }
  if (!choice.bare) {
    fmt::print("{} of {} frames that arrived are bit-exact\n", right, arrived.size());
  }
  return code != 0 ? code : right == arrived.size() ? 0 : 1;
}

}  // namespace
}  // namespace ocelli

int main(int argumentCount, char** arguments) {
  using namespace ocelli;
  Choice choice;
  const char* const folder = std::getenv("OCELLI_DATA_DIR");
  choice.scene = folder == nullptr ? "builtin:teapot" : std::string(folder) + "/bunny.obj";
  CLI::App program("Streams a scene that turns to an emulated display on an emulated USB");
  program.add_option("--scene", choice.scene, "What is shown");
  program.add_option("--link", choice.link, "usb2, usb3, unlimited, or bytes a second");
  program.add_option("--seconds", choice.seconds, "How long");
  program.add_option("--rate", choice.rate, "Frames a second; 0: as fast as they arrive");
  program.add_option("--volumes", choice.volumes, "Different ones, in a turn");
  program.add_flag("--bare", choice.bare, "Transfers alone, without frames");
  program.add_option("--driver", choice.driver, "For the program itself");
  CLI11_PARSE(program, argumentCount, arguments);
  try {
    if (!choice.driver.empty()) {
      drive(choice);
      return 0;
    }
    std::vector<std::string> own(arguments, arguments + argumentCount);
    own.front() = std::filesystem::read_symlink("/proc/self/exe").string();
    return emulate(choice, own);
  } catch (const std::exception& error) {
    fmt::print(stderr, "usb_stream: {}\n", error.what());
    return 1;
  }
}
