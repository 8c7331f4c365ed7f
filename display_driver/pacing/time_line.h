// What became of each refresh while frames were presented, and the sum of it.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "display_driver/device/device.h"

namespace ocelli {

enum class RefreshOutcome {
  kShown,         ///< the frame that was due was shown in time
  kUnchanged,     ///< there was nothing new to show
  kSourceLate,    ///< the volume was not made in time
  kLinkLate,      ///< it was, but did not arrive in time
  kRefused,       ///< it arrived, or was lost on its way, and the device did not show it
  kNotConnected,  ///< the device was not there
};
inline constexpr size_t kRefreshOutcomes = 6;
/// For people and tables: "shown", "source late".
const char* nameOf(RefreshOutcome outcome);
/// Not the first two.
bool isMiss(RefreshOutcome outcome);

/// Times that do not apply, or are not known, are zero.
struct RefreshRecord {
  uint64_t refresh = 0;
  HostTime due{};         ///< when it begins, as it was foreseen last
  FrameNumber frame = 0;  ///< that was due; 0: none was
  RefreshOutcome outcome = RefreshOutcome::kUnchanged;
  HostTime makingBegan{};
  HostTime makingEnded{};
  HostTime submitted{};  ///< when submit() had returned
  HostTime sent{};
  HostTime arrived{};
  HostTime shown{};
  uint64_t shownRefresh = 0;
  bool late = false;     ///< its frame was shown, after this refresh had begun
  float imageScale = 1;  ///< of the images that its frame was made of (volume_source.h)
  std::string problem{};
};

/// Milliseconds.
struct Spread {
  size_t count = 0;
  double median = 0;
  double within95 = 0;  ///< that 95 % do not exceed
  double worst = 0;
};

struct TimeLineSummary {
  uint64_t refreshes = 0;
  std::array<uint64_t, kRefreshOutcomes> outcomes{};
  uint64_t misses = 0;
  uint64_t framesShown = 0;    ///< in time or late
  uint64_t smallerImages = 0;  ///< of these those made of smaller images than asked for, as time ran short
  float leastImageScale = 1;   ///< of these
  float medianImageScale = 1;  ///< of all frames shown
  double seconds = 0;          ///< from the first refresh to the last
  Spread making;  ///< from when its input was taken, such as an eye, to when the volume could be handed over
  Spread submitting;
  Spread sending;  ///< from submit() to the last byte, or to the arrival where that is not known
  Spread latency;  ///< from the begin of its making, when its input was taken, to when it was seen

  uint64_t count(RefreshOutcome outcome) const { return outcomes[static_cast<size_t>(outcome)]; }
};

/// Sums up records in their order; keeps 20 bytes for each.
class TimeLine {
 public:
  void add(const RefreshRecord& record);
  TimeLineSummary summary() const;
  uint64_t refreshes() const { return summary_.refreshes; }
  uint64_t misses() const { return summary_.misses; }

 private:
  TimeLineSummary summary_;
  std::optional<HostTime> first_;
  std::vector<float> making_;
  std::vector<float> submitting_;
  std::vector<float> sending_;
  std::vector<float> latency_;
  std::vector<float> imageScales_;
};

/// A table of comma-separated values: its header, and one line for a record, with times in milliseconds since `start`.
std::string timeLineHeader();
std::string timeLineRow(const RefreshRecord& record, HostTime start);

}  // namespace ocelli
