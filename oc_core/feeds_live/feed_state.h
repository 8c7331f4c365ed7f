// How a feed does.
#pragma once

namespace ocelli {

enum class FeedState {
  kLive,     ///< frames come in
  kLate,     ///< no frame has come for its time, though it was waited for
  kFrozen,   ///< frames come in that are all the same
  kCovered,  ///< frames come in that show hardly anything of the place
  kEnded,    ///< it was read to its end
  kLost,     ///< it broke off, or cannot be read; a live one is tried again
};

/// "live", "late", ...
const char* wordOf(FeedState state);

}  // namespace ocelli
