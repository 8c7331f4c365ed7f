// When the frames of a feed were taken, in the time of the place.
//
// Recorded feeds have timestamps of clocks whose offsets are known. Live ones count from whenever they began, and anew
// after each reconnection: the frame that came with the least delay says what they count from. In a run with live
// feeds the time of the place is that of steadyNanoseconds(), and a recorded feed begins when it is opened.
#pragma once

#include <optional>

namespace ocelli {

class FeedClock {
 public:
  enum class Kind { kRecorded, kReplayed, kLive };
  explicit FeedClock(Kind kind) : kind_(kind) {}

  /// `stamp` is the timestamp of a frame, `now` when it came in; both in seconds.
  double placeSeconds(double stamp, double now);

 private:
  Kind kind_;
  std::optional<double> offset_;
  double lastStamp_ = 0;
};

}  // namespace ocelli
