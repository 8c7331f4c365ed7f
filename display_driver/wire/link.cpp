#include "display_driver/wire/link.h"

namespace ocelli::wire {

const char* nameOf(LinkStatus status) {
  switch (status) {
    case LinkStatus::kDone:
      return "done";
    case LinkStatus::kShort:
      return "ended early";
    case LinkStatus::kStalled:
      return "stalled";
    case LinkStatus::kTimedOut:
      return "timed out";
    case LinkStatus::kCancelled:
      return "cancelled";
    case LinkStatus::kGone:
      return "the device is gone";
    case LinkStatus::kFailed:
      return "failed";
  }
  return "unknown";
}

}  // namespace ocelli::wire
