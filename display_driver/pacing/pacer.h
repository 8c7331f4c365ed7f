// Presents the volumes of a source at the display's rate, each at the begin of a refresh.
//
//   Pacer pacer(device, source, realClock(), options);
//   const TimeLineSummary summary = pacer.run([] { return interrupted(); }, [](const RefreshRecord& record) { ... });
//
// For each refresh: it foresees when the refresh begins (rotation_clock.h), begins to make its volume as late as it may
// (as early as making, submitting and sending took at their worst lately, so that what is shown is as fresh as can be),
// submits it, says at which refresh it is to be shown, and follows what becomes of it. A refresh that cannot be made
// any more is skipped, and the volume that was late for it is shown at the first one that it can still make. Where the
// link takes longer than a refresh for a frame, only every second or third refresh gets one: nothing ever waits in a
// queue, so that the latency stays what the stages take.
//
// A source that makes volumes beside the pacer (VolumeLine) has two of them under way at a time: where making one takes
// longer than a refresh, but none of its stages does, every refresh still gets its own.
//
// Where the device does not tell its rotation, refreshes are counted from the begin at the rate of the profile, and
// frames are shown as soon as they are there.
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "display_driver/device/device.h"
#include "display_driver/pacing/pace_clock.h"
#include "display_driver/pacing/rotation_clock.h"
#include "display_driver/pacing/stage_times.h"
#include "display_driver/pacing/time_line.h"
#include "display_driver/pacing/volume_source.h"

namespace ocelli {

struct PacerOptions {
  /// nullopt: until the source ends, or is stopped.
  std::optional<double> seconds{};
  bool tearWhenLate = false;
  bool coarseWhenLate = false;
};

class Pacer {
 public:
  /// All outlive the pacer.
  Pacer(Device& device, VolumeSource& source, PaceClock& clock, const PacerOptions& options = {});

  using Stop = std::function<bool()>;
  using OnRecord = std::function<void(const RefreshRecord&)>;
  /// Call it once. `stop` is asked some 100 times a second; `onRecord` gets each refresh in order, once it is known
  /// what became of it. Throws what the source throws, with all of the records before.
  TimeLineSummary run(const Stop& stop = {}, const OnRecord& onRecord = {});

 private:
  struct Pending {
    RefreshRecord record;
    std::shared_ptr<const FrameFence> fence{};  ///< nullptr: all is known
    bool locked = false;                        ///< it was told at which refresh
    bool sourceLate = false;                    ///< it was late before it was submitted
  };
  /// A volume that is being made.
  struct Making {
    RefreshRecord record;
    std::vector<RefreshRecord> skipped;  ///< before it
    uint64_t counting = 0;               ///< of its refreshes
  };

  void waitForRotation();
  void observe();
  void settle(Pending& pending, const FrameState& state);
  void giveUp(Pending& pending, const FrameState& state);
  void learn(const RefreshRecord& record);
  void flush(const OnRecord& onRecord);
  void finish(const OnRecord& onRecord);
  void chooseTarget(HostTime now);
  void skipUpTo(uint64_t refresh, RefreshOutcome why);
  void keepSkipped(std::vector<RefreshRecord>& skipped, bool nothingNew);
  void beginMaking(uint64_t refresh);
  void takeMade();
  void submit(Making making, const SourcedVolume& sourced);
  size_t underWay() const;

  // The rotation, as the device tells it or as it is made up.
  HostTime beginOf(uint64_t refresh) const;
  uint64_t refreshAfter(HostTime time) const;
  double refreshSeconds() const;
  /// From the begin of the making to the arrival.
  std::chrono::nanoseconds usualLead() const;
  std::chrono::nanoseconds safeLead() const;

  Device& device_;
  VolumeSource& source_;
  VolumeLine* line_;
  PaceClock& clock_;
  PacerOptions options_;
  RotationClock ideal_;     ///< of a device that does not tell its rotation
  RotationClock rotation_;  ///< as the device tells it
  uint64_t restarts_ = 0;
  uint64_t counting_ = 0;  ///< how often refreshes were counted anew
  bool locked_ = false;
  bool connected_ = false;
  bool ended_ = false;

  std::optional<uint64_t> last_;    ///< refresh that has been dealt with, or whose volume is being made
  std::optional<uint64_t> target_;  ///< the next one that gets a frame
  std::optional<HostTime> lastFrameDue_;
  StageTimes making_;
  StageTimes transit_;  ///< from the end of the making to the arrival
  StageTimes sending_;  ///< while the link was busy with a frame
  HostTime lastSent_{};
  std::deque<Making> makings_;
  std::deque<Pending> pending_;
  std::vector<Pending> givenUp_;        ///< told as missed, and still on their way to the device: at most two
  std::vector<RefreshRecord> skipped_;  ///< until the source says whether it had anything for them
  TimeLine timeLine_;
};

}  // namespace ocelli
