// A display that shows volumes, behind one interface: hardware over USB or shared memory, a simulator, a file.
//
//   std::unique_ptr<Device> device = openDevice("usb");
//   const auto fence = device->submit(std::move(volume));
//   device->present(fence->number(), {.at = RotationPhase{.refresh = 1200}});
//   fence->wait(FrameStage::kShown, 1s);
//
// Recipe for a new device:
//   1. display_driver/devices/NAME_device.h and .cpp: a class that implements Device, and a function that opens it. It
//      takes volumes without making the caller wait, and never throws after it was opened except from close(): what
//      goes wrong later ends frames (frame_fence.h) and shows in the telemetry.
//   2. display_driver/devices/device_kinds.cpp: one line with its name, what may follow the name, what it is, the
//      function.
// From outside of the tree: registerDevice() with the same line, as in examples/add_a_device/main.cpp.
// `ocelli present --device NAME`, `ocelli device list` and the tests that run over every device find it there.
#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>

#include "display_driver/device/frame_fence.h"
#include "display_sim/frames/display_profile.h"
#include "display_sim/frames/volume.h"

namespace ocelli {

using HostTime = std::chrono::steady_clock::time_point;

/// A moment of the rotation. Refreshes (half turns, or whole ones where the second half turn has its own slices) are
/// counted by the device, from some start of its own.
struct RotationPhase {
  uint64_t refresh = 0;
  int slice = 0;  ///< the first one that the new frame shows

  auto operator<=>(const RotationPhase&) const = default;
};

/// When a frame takes the place of the one that is shown.
struct Presentation {
  /// nullopt: at the first slice of the next refresh that begins after the whole frame is there.
  std::optional<RotationPhase> at{};
  /// Where the frame comes after its phase: show it from the very next slice on, in the middle of a turn, instead of
  /// waiting until the screen comes to the slice of `at` again. The turn is then torn.
  bool tearWhenLate = false;
  /// Where a part of the frame is there at its phase: show what is there, in a coarser angular resolution.
  bool coarseWhenLate = false;
};

struct DeviceInfo {
  std::string kind;    ///< "usb", "sim", ...
  std::string name;    ///< what the device calls itself
  std::string serial;  ///< empty where it has none
  std::string link;    ///< how it is connected, for people: "USB 2, 480 Mbit/s"
};

/// Where the screen was at a time.
struct RotationReading {
  HostTime time;
  uint64_t refresh = 0;
  double share = 0;           ///< of that refresh that had passed, in [0, 1)
  double refreshSeconds = 0;  ///< how long refreshes take now, as measured
};

/// Counters start at 0 when the device is opened, and go on over reconnections.
struct Telemetry {
  bool connected = false;
  std::optional<RotationReading> rotation;  ///< nullopt for devices that do not tell
  double rotationsPerMinute = 0;            ///< as measured; 0: not known
  double phaseErrorDegrees = 0;             ///< of the screen, against what drives it
  std::optional<double> temperatureCelsius;
  uint64_t framesSubmitted = 0;
  uint64_t framesArrived = 0;  ///< whole, and acknowledged
  uint64_t framesShown = 0;
  uint64_t framesShownCoarse = 0;
  uint64_t framesDropped = 0;  ///< before they were sent, or by the device, because a newer one was there
  uint64_t framesLost = 0;     ///< on the way: damaged, or cut off with the link
  uint64_t underruns = 0;      ///< refreshes that had to show an old frame where a new one was due
  uint64_t reconnections = 0;
  uint64_t bytesSent = 0;
  std::string fault;        ///< what the display says is wrong with itself now; empty where nothing is
  std::string lastProblem;  ///< for people; empty where there was none
};

/// Threads may call any of its functions at any time, except close() and the destructor.
class Device {
 public:
  virtual ~Device() = default;  ///< as close(), without exceptions

  virtual const DeviceInfo& info() const = 0;
  virtual const DisplayProfile& profile() const = 0;

  /// Takes a volume of this profile, and returns at once. Where the device is still busy, the newest volume takes the
  /// place of one that waits, which is dropped. The device keeps the volume as long as it needs it, without a copy:
  /// nobody may change it any more.
  std::shared_ptr<const FrameFence> submit(std::shared_ptr<const Volume> volume) {
    return submitFrame(std::move(volume), std::nullopt);
  }
  /// The same for a volume that differs from the one submitted before in these slices alone: a device may then send
  /// less, and looks at less.
  std::shared_ptr<const FrameFence> submit(std::shared_ptr<const Volume> volume, std::span<const int> changedSlices) {
    return submitFrame(std::move(volume), changedSlices);
  }
  /// The same for a volume that the caller gives away (`std::move(volume)`), or else for a copy of it. A caller that
  /// submits many copies makes them with a VolumePool.
  std::shared_ptr<const FrameFence> submit(Volume volume) {
    return submit(std::make_shared<const Volume>(std::move(volume)));
  }
  std::shared_ptr<const FrameFence> submit(Volume volume, std::span<const int> changedSlices) {
    return submit(std::make_shared<const Volume>(std::move(volume)), changedSlices);
  }

  /// Says when a submitted frame is shown; without it a frame waits in the device until a newer one takes its place.
  /// May come right after submit(), before the frame is there. Does nothing for frames that have ended.
  virtual void present(FrameNumber frame, const Presentation& presentation) = 0;

  virtual Telemetry telemetry() = 0;

  /// Ends what is under way and frees the device. Frames that are not there yet are lost. Throws WorkError where a last
  /// write fails (a full disk). Nothing but the destructor may be called after it.
  virtual void close() = 0;

 protected:
  /// `volume` is not nullptr. nullopt: all slices may have changed.
  virtual std::shared_ptr<const FrameFence> submitFrame(std::shared_ptr<const Volume> volume,
                                                        std::optional<std::span<const int>> changedSlices) = 0;
};

}  // namespace ocelli
