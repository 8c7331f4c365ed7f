// `multivox[:NAME|HOST[:PORT]]`: displays of the multivox project and their simulator, which show a grid of voxels that
// lies in shared memory (multivox_memory.h) or comes over the network (multivox_network.h). Volumes are resampled to
// the grid (voxel_resampler.h) and written by a thread of the device.
//
// What is special about it:
// - There may be no shared memory at opening: the device waits for it, takes volumes meanwhile, and writes the newest
//   when it appears. When the memory is made anew, or a connection that broke comes back, what was shown is shown
//   again. A display on the network must be there at opening.
// - Nothing tells where the screen is. present() shows a frame at once, whatever phase is asked for, which may be in
//   the middle of a turn; frames are never late and never coarse, and the refreshes of fences are 0.
// - At most 50 frames a second are shown; of more, the newest.
// - On the network a frame is sent when it is shown: one that arrived, and is not asked for, waits on this machine. At
//   most one frame is under way at a time.
// - A frame arrived when it is written, and is shown when the page is changed to it. Nobody confirms either: memory
//   outlives the driver that made it, so `connected` says that there is memory, not that somebody reads it.
// - Frames are not lost but wait while there is no display; they end as lost when the device is closed.
// - The last frame stays in the display when the device is closed.
#pragma once

#include <condition_variable>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "display_driver/device/device.h"
#include "display_driver/devices/multivox_target.h"
#include "display_driver/devices/voxel_resampler.h"

namespace ocelli {

class MultivoxDevice final : public Device {
 public:
  MultivoxDevice(std::unique_ptr<MultivoxTarget> target, const DisplayProfile& profile, const VoxelGrid& grid = {});
  ~MultivoxDevice() override;

  const DeviceInfo& info() const override { return info_; }
  const DisplayProfile& profile() const override { return profile_; }
  void present(FrameNumber frame, const Presentation& presentation) override;
  /// What the display tells is at most 100 ms old.
  Telemetry telemetry() override;
  void close() override;

 protected:
  std::shared_ptr<const FrameFence> submitFrame(std::shared_ptr<const Volume> volume,
                                                std::optional<std::span<const int>> changedSlices) override;

 private:
  struct Frame {
    std::shared_ptr<FrameFence> fence;
    std::shared_ptr<const Volume> volume;  ///< until it is resampled
    FrameState state;
    bool asked = false;  ///< present() was called for it
  };

  void run();
  bool lookAtTarget(std::unique_lock<std::mutex>& lock);
  void takeNewest(std::unique_lock<std::mutex>& lock);
  void writeStaged(std::unique_lock<std::mutex>& lock);
  void showStaged(std::unique_lock<std::mutex>& lock);
  void showAgain(std::unique_lock<std::mutex>& lock);
  bool mustShow() const { return staged_ && stagedWritten_ && staged_->asked; }
  void noteTarget();
  static void end(Frame& frame, FrameStage stage, const std::string& problem);

  DeviceInfo info_;
  DisplayProfile profile_;

  std::mutex mutex_;  ///< over what follows, up to the empty line
  std::condition_variable wake_;
  bool stop_ = false;
  FrameNumber lastNumber_ = 0;
  Telemetry telemetry_;
  std::vector<uint8_t> newestDiff_;  ///< 1 for slices in which pending_ may differ from what was resampled last
  std::optional<Frame> pending_;     ///< the frame that was submitted last, until it is resampled
  std::optional<Frame> staged_;      ///< the one that was resampled last, until it is shown

  // Of the thread alone.
  std::unique_ptr<MultivoxTarget> target_;
  VoxelResampler resampler_;
  int shownBits_ = kMaxShownBits;
  bool stagedWritten_ = false;       ///< the target has staged_ as a whole
  std::vector<uint8_t> shownCells_;  ///< of the frame that was shown last; empty before the first
  bool shownMissing_ = false;        ///< the display is new, and does not show them
  bool everConnected_ = false;

  std::thread thread_;
};

/// The shared memory that a name stands for: "vortex", also where the name is empty, for "/vortex_double_buffer", and
/// so on; a name that begins with a slash is the shared memory's own. Throws InputError for what cannot be one.
std::string multivoxObject(const std::string& name);

/// Opens the device for volumes of this profile; `vortex` of the built-in ones is made for it, any other is resampled.
/// `name` as in multivoxObject() or multivoxPlace(). Does not wait for shared memory. Throws InputError for a name that
/// cannot be and for an unknown host, WorkError where no display answers on the network.
std::unique_ptr<Device> openMultivox(const std::string& name, const DisplayProfile& profile = loadProfile("vortex"));

}  // namespace ocelli
