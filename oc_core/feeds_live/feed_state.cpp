#include "oc_core/feeds_live/feed_state.h"

namespace ocelli {

const char* wordOf(FeedState state) {
  switch (state) {
    case FeedState::kLive:
      return "live";
    case FeedState::kLate:
      return "late";
    case FeedState::kFrozen:
      return "frozen";
    case FeedState::kCovered:
      return "covered";
    case FeedState::kEnded:
      return "ended";
    case FeedState::kLost:
      return "lost";
  }
  return "";
}

}  // namespace ocelli
