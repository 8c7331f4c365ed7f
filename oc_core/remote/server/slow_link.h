// A link that is slower than the real one, for trying remote visualisation as it is over slow networks.
#pragma once

#include <cstddef>
#include <cstdint>

namespace ocelli {

struct SlowLinkSettings {
  double bytesPerSecond = 0;     ///< 0: as fast as the real link
  double delayMilliseconds = 0;  ///< by which each round trip grows; all of it on the way to the client
};

/// Says when messages leave, if one follows the other on the link and all arrive later by the delay.
class SlowLink {
 public:
  explicit SlowLink(const SlowLinkSettings& settings) : settings_(settings) {}

  bool isSlow() const { return settings_.bytesPerSecond > 0 || settings_.delayMilliseconds > 0; }
  /// When a message of this size, which was ready to be sent at `readyAt`, is to be handed to the real link, in
  /// nanoseconds of the same clock. Call it once a message, in their order.
  int64_t leavesAt(size_t bytes, int64_t readyAt);
  /// When its last message has left the near end: all of them arrive later by the delay. The next one may begin then.
  int64_t freeAt() const { return freeAt_; }

 private:
  SlowLinkSettings settings_;
  int64_t freeAt_ = 0;
};

}  // namespace ocelli
