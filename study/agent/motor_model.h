// The motor model of a simulated observer: keys that are held and tapped, and a mouse, as the events that a window
// would get of them, with the times when they come.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "study/agent/chance.h"
#include "study/agent/human_factors.h"
#include "study/task/task.h"
#include "study/task/timed_input.h"

namespace ocelli {

class MotorModel {
 public:
  /// A key to hold from one time to another.
  struct Hold {
    Key key = Key::kW;
    int64_t from = 0;
    int64_t to = 0;
  };

  MotorModel(const HumanFactors& factors, const Controls& controls, uint64_t seed);

  /// What is done with the movement keys from `from` on, instead of what was meant to be done with them. Turns by the
  /// mouse that were yet to begin are dropped.
  void plan(int64_t from, const std::vector<Hold>& holds);
  void tap(Key key, int64_t at);
  /// Types a character: what the window system makes of the keys of it.
  void type(char32_t character, int64_t at);
  /// Moves the pointer there, as fast as one can who is to hit something of that size (Fitts' law), from what is done
  /// with it before. Returns when it is there.
  int64_t point(const glm::dvec2& to, double sizePixels, int64_t from);
  void click(int64_t at);
  /// Turns by moving the mouse while its right button is held, from what is done with it before. Returns when it is
  /// done.
  int64_t pan(double degrees, int64_t from);
  /// About how long that takes.
  double panSeconds(double degrees) const;
  /// Who walks on while turning by less than 180 degrees rounds a corner: metres before it where the turn begins, and
  /// after it where it ends.
  double panReach(double degrees) const;
  /// Whether a turn by the mouse is under way at that time.
  bool isPanning(int64_t at) const;
  /// Lets go of all keys and forgets what was meant to be done.
  void release(int64_t at);

  /// The events before `until` that have not been taken, in order.
  std::vector<TimedInput> take(int64_t until);

  /// Where the pointer is, as one sees it.
  void seePointer(const glm::dvec2& place) { pointer_ = place; }
  const glm::dvec2& pointer() const { return pointer_; }
  bool isPointing(int64_t at) const { return at < pointsUntil_; }

  /// Where one who stood at `pose` at one time stands at another, by what the keys do: walls are not felt.
  WalkerPose reckon(const WalkerPose& pose, int64_t from, int64_t to) const;

 private:
  struct Change {
    int64_t at = 0;
    Key key = Key::kW;
    bool pressed = true;
  };
  struct Pan {
    int64_t at = 0;
    double degrees = 0;
  };
  struct PanSpan {
    int64_t from = 0;
    int64_t until = 0;
  };
  void stopMouse(int64_t at);
  struct Repeat {
    Key key = Key::kW;
    int64_t at = 0;  ///< the next
  };
  bool isHeld(Key key, int64_t at) const;
  void add(InputEvent event, int64_t at);

  HumanFactors factors_;
  Controls controls_;
  Random random_;
  std::array<Key, 4> movement_;    ///< forward, backward, turn left, turn right
  std::vector<Change> changes_;    ///< of the movement keys, in order of time
  std::vector<TimedInput> queue_;  ///< likewise
  std::optional<Repeat> repeats_{};
  int64_t taken_ = 0;
  glm::dvec2 pointer_{0};
  int64_t pointsUntil_ = 0;
  std::vector<Pan> pans_{};          ///< in order of time
  std::vector<PanSpan> panSpans_{};  ///< likewise; they do not overlap
};

}  // namespace ocelli
