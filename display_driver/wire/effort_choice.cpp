#include "display_driver/wire/effort_choice.h"

#include <algorithm>

namespace ocelli {
namespace {

constexpr int kMinPatience = 48;
/// Two minutes at 24 frames a second.
constexpr int kMaxPatience = 3072;
/// Run lengths that filled the link within so many frames were tried too early.
constexpr int kTooEarly = 24;

}  // namespace

void EffortChoice::frameSent(bool full) {
  ++frames_;
  if (!small_ && full) {
    const bool tooEarly = patience_ > 0 && frames_ <= kTooEarly;
    patience_ = tooEarly ? std::min(2 * patience_, kMaxPatience) : kMinPatience;
    small_ = true;
    frames_ = 0;
  } else if (small_ && full) {
    frames_ = 0;
  } else if (small_ && frames_ >= patience_) {
    small_ = false;
    frames_ = 0;
  }
}

}  // namespace ocelli
