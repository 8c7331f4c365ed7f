// Contacts bounce: a switch that closes once may be seen to close several times within some milliseconds. The debouncer
// lets the first change of a key pass at once, with its own time, so that no response is measured late. What changes
// within a time after that is held back: if the key is back where it was when the time is over, it bounced, and
// counts once; if not, the change was real, and passes with the time when it came.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "study/responses/key_change.h"

namespace ocelli {

class Debouncer {
 public:
  /// How long after a change of a key the next ones are held back; 0: all pass.
  explicit Debouncer(int64_t nanoseconds) : window_(nanoseconds) {}

  /// What passes of a change, and of what was held back until it came. Changes of a key come in order. A press of a key
  /// that is down already is a repeat, which passes where nothing is held back.
  std::vector<KeyChange> take(const KeyChange& change);
  /// What was held back, and has proved real by now.
  std::vector<KeyChange> update(int64_t nanoseconds);

  /// Pairs of changes that did not count.
  int64_t bounces() const { return bounces_; }

 private:
  struct State {
    bool passed = false;  ///< whether the key is down, as far as it has passed
    bool now = false;     ///< as the device says
    int64_t settles = 0;  ///< until then changes are held back
    std::optional<KeyChange> held{};
  };
  void settle(State& state, int64_t nanoseconds, std::vector<KeyChange>& passes) const;

  int64_t window_;
  std::map<Key, State> keys_{};
  int64_t bounces_ = 0;
};

}  // namespace ocelli
