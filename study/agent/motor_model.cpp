#include "study/agent/motor_model.h"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "oc_core/base/conventions.h"

namespace ocelli {
namespace {

constexpr int64_t kMouseStep = 8'000'000;  // 125 Hz
/// A key that is held repeats, as systems do it.
constexpr int64_t kRepeatDelay = 500'000'000;
constexpr int64_t kRepeatStep = 40'000'000;
constexpr int64_t kReckonStep = 1'000'000'000 / 120;
constexpr int64_t kHistory = 5'000'000'000;
/// The spread of the places that a pointer ends at is the width of the target over that (Soukoreff, MacKenzie 2004):
/// 4 % miss.
constexpr double kWidthsOfSpread = 4.133;
constexpr double kMinPointSeconds = 0.1;
/// So exactly one must have turned to go on without a correction.
constexpr double kPanDegrees = 20;

/// How far a movement of least jerk is after a share of its time (Flash and Hogan 1985).
double smoothWay(double t) {
  return t * t * t * (10 + t * (6 * t - 15));
}

}  // namespace

MotorModel::MotorModel(const HumanFactors& factors, const Controls& controls, uint64_t seed)
    : factors_(factors),
      controls_(controls),
      random_(seed),
      movement_{controls.forward, controls.backward, controls.turnLeft, controls.turnRight} {}

bool MotorModel::isHeld(Key key, int64_t at) const {
  bool held = false;
  for (const Change& change : changes_) {
    held = change.at <= at && change.key == key ? change.pressed : held;
  }
  return held;
}

void MotorModel::plan(int64_t from, const std::vector<Hold>& holds) {
  from = std::max(from, taken_);
  std::erase_if(changes_, [&](const Change& change) { return change.at >= from; });
  const auto later =
      std::find_if(panSpans_.begin(), panSpans_.end(), [&](const PanSpan& span) { return span.from >= from; });
  if (later != panSpans_.end()) {
    stopMouse(later->from);
  }
  for (const Key key : movement_) {
    bool held = isHeld(key, from);
    int64_t last = from;
    for (const Hold& hold : holds) {
      if (hold.key != key) {
        continue;
      }
      const int64_t begin = std::max(hold.from, last);
      const int64_t end = std::max(hold.to + nanosecondsOf(normal(random_, 0, factors_.keySpread)), begin + kMouseStep);
      if (held && begin > last) {
        changes_.push_back({last, key, false});
        held = false;
      }
      if (!held) {
        changes_.push_back({begin, key, true});
      }
      changes_.push_back({end, key, false});
      held = false;
      last = end;
    }
    if (held) {
      changes_.push_back({last, key, false});
    }
  }
  std::stable_sort(changes_.begin(), changes_.end(), [](const Change& a, const Change& b) { return a.at < b.at; });
}

void MotorModel::add(InputEvent event, int64_t at) {
  const TimedInput input{std::move(event), std::max(at, taken_)};
  queue_.insert(
      std::upper_bound(queue_.begin(), queue_.end(), input,
                       [](const TimedInput& a, const TimedInput& b) { return a.nanoseconds < b.nanoseconds; }),
      input);
}

void MotorModel::tap(Key key, int64_t at) {
  add(KeyEvent{key, true, {}}, at);
  add(KeyEvent{key, false, {}}, at + nanosecondsOf(normalWithin(random_, factors_.holdSeconds, 0.015, 0.04, 0.2)));
}

void MotorModel::type(char32_t character, int64_t at) {
  add(TextEvent{character}, at);
}

void MotorModel::click(int64_t at) {
  add(PointerButtonEvent{PointerButton::kLeft, true, {}}, at);
  add(PointerButtonEvent{PointerButton::kLeft, false, {}},
      at + nanosecondsOf(normalWithin(random_, factors_.holdSeconds, 0.015, 0.04, 0.2)));
}

int64_t MotorModel::point(const glm::dvec2& to, double sizePixels, int64_t from) {
  from = std::max(from, taken_);
  stopMouse(from);
  glm::dvec2 start = pointer_;
  for (const TimedInput& input : queue_) {
    if (const auto* move = std::get_if<PointerMoveEvent>(&input.event)) {
      start = {move->x, move->y};
    }
  }
  const double size = std::max(sizePixels, 1.0);
  const double bits = std::log2(glm::distance(start, to) / size + 1);
  const double seconds =
      std::max(kMinPointSeconds, bits / factors_.bitsPerSecond * normalWithin(random_, 1, 0.1, 0.7, 1.4));
  const double spread = size / kWidthsOfSpread / 2;  // to either side
  const glm::dvec2 end = to + glm::dvec2(normal(random_, 0, spread), normal(random_, 0, spread));
  const int64_t until = from + nanosecondsOf(seconds);
  for (int64_t at = from; at < until + kMouseStep; at += kMouseStep) {
    const double t = std::min(1.0, secondsOf(at - from) / seconds);
    const glm::dvec2 place = glm::round(glm::mix(start, end, smoothWay(t)));
    add(PointerMoveEvent{place.x, place.y}, at);
  }
  pointsUntil_ = until + kMouseStep;
  return pointsUntil_;
}

double MotorModel::panSeconds(double degrees) const {
  // A direction need not be hit to the degree: one walks on and corrects it.
  return std::max(kMinPointSeconds, std::log2(std::abs(degrees) / kPanDegrees + 1) / factors_.bitsPerSecond);
}

double MotorModel::panReach(double degrees) const {
  // As much aside as the way turns: what is walked aside while turning by `degrees`, seen from the end of the turn.
  constexpr int kSteps = 64;
  const double angle = radiansFromDegrees(std::abs(degrees));
  double aside = 0;
  for (int i = 0; i < kSteps; ++i) {
    aside += std::sin(angle * smoothWay((i + 0.5) / kSteps)) / kSteps;
  }
  return controls_.walkMetersPerSecond * panSeconds(degrees) * aside / std::sin(angle);
}

bool MotorModel::isPanning(int64_t at) const {
  return std::any_of(panSpans_.begin(), panSpans_.end(),
                     [&](const PanSpan& span) { return span.from < at && at < span.until; });
}

int64_t MotorModel::pan(double degrees, int64_t from) {
  from = std::max(from, taken_);
  stopMouse(from);
  const double seconds = panSeconds(degrees) * normalWithin(random_, 1, 0.1, 0.7, 1.4);
  const double turned = degrees + normal(random_, 0, std::min(kPanDegrees, std::abs(degrees)) / kWidthsOfSpread);
  add(PointerMoveEvent{pointer_.x, pointer_.y}, from);
  add(PointerButtonEvent{PointerButton::kRight, true, {}}, from);
  double pixelsBefore = 0;
  int64_t at = from;
  for (double t = 0; t < 1;) {
    at += kMouseStep;
    t = std::min(1.0, secondsOf(at - from) / seconds);
    const double pixels = std::round(turned * smoothWay(t) / controls_.mouseDegreesPerPixel);
    add(PointerMoveEvent{pointer_.x + pixels, pointer_.y}, at);
    pans_.push_back({at, (pixels - pixelsBefore) * controls_.mouseDegreesPerPixel});
    pixelsBefore = pixels;
  }
  add(PointerButtonEvent{PointerButton::kRight, false, {}}, at + 1);
  panSpans_.push_back({from, at + 1});
  return at + 1;
}

/// The mouse moves no more, and its right button is let go.
void MotorModel::stopMouse(int64_t at) {
  std::erase_if(queue_, [&](const TimedInput& input) {
    const auto* button = std::get_if<PointerButtonEvent>(&input.event);
    return input.nanoseconds >= at && (std::holds_alternative<PointerMoveEvent>(input.event) ||
                                       (button != nullptr && button->button == PointerButton::kRight));
  });
  std::erase_if(pans_, [&](const Pan& pan) { return pan.at >= at; });
  std::erase_if(panSpans_, [&](const PanSpan& span) { return span.from >= at; });
  if (!panSpans_.empty() && panSpans_.back().until > at) {
    add(PointerButtonEvent{PointerButton::kRight, false, {}}, at);
    panSpans_.back().until = at;
  }
  pointsUntil_ = std::min(pointsUntil_, at);
}

void MotorModel::release(int64_t at) {
  plan(at, {});
  stopMouse(at);
}

std::vector<TimedInput> MotorModel::take(int64_t until) {
  std::vector<TimedInput> events;
  while (!queue_.empty() && queue_.front().nanoseconds < until) {
    events.push_back(std::move(queue_.front()));
    queue_.erase(queue_.begin());
  }
  // The last key that was pressed repeats, until it is let go.
  const auto repeatUntil = [&](int64_t time) {
    for (; repeats_ && repeats_->at < time; repeats_->at += kRepeatStep) {
      events.push_back({KeyEvent{repeats_->key, true, {}}, repeats_->at});
    }
  };
  for (const Change& change : changes_) {
    if (change.at < taken_ || change.at >= until) {
      continue;
    }
    repeatUntil(change.at);
    events.push_back({KeyEvent{change.key, change.pressed, {}}, change.at});
    if (change.pressed) {
      repeats_ = {change.key, change.at + kRepeatDelay};
    } else if (repeats_ && repeats_->key == change.key) {
      repeats_.reset();
    }
  }
  repeatUntil(until);
  std::stable_sort(events.begin(), events.end(),
                   [](const TimedInput& a, const TimedInput& b) { return a.nanoseconds < b.nanoseconds; });
  for (const TimedInput& event : events) {
    if (const auto* move = std::get_if<PointerMoveEvent>(&event.event)) {
      pointer_ = {move->x, move->y};
    }
  }
  taken_ = std::max(taken_, until);
  std::erase_if(pans_, [&](const Pan& pan) { return pan.at < taken_ - kHistory; });
  std::erase_if(panSpans_, [&](const PanSpan& span) { return span.until < taken_ - kHistory; });
  while (!changes_.empty() && changes_.front().at < taken_ - kHistory && !changes_.front().pressed) {
    const Key key = changes_.front().key;  // what it ended is over too
    std::erase_if(changes_, [&](const Change& change) { return change.key == key && change.at < taken_ - kHistory; });
  }
  return events;
}

WalkerPose MotorModel::reckon(const WalkerPose& pose, int64_t from, int64_t to) const {
  WalkerPose reached = pose;
  auto pan = std::find_if(pans_.begin(), pans_.end(), [&](const Pan& each) { return each.at > from; });
  for (int64_t at = from; at < to; at += kReckonStep) {
    const double seconds = secondsOf(std::min(kReckonStep, to - at));
    const auto way = [&](Key positive, Key negative) {
      return (isHeld(positive, at) ? 1.0 : 0.0) - (isHeld(negative, at) ? 1.0 : 0.0);
    };
    reached.headingRadians +=
        radiansFromDegrees(way(controls_.turnRight, controls_.turnLeft) * controls_.turnDegreesPerSecond) * seconds;
    for (; pan != pans_.end() && pan->at <= at + kReckonStep && pan->at <= to; ++pan) {
      reached.headingRadians += radiansFromDegrees(pan->degrees);
    }
    const double stride = way(controls_.forward, controls_.backward) * controls_.walkMetersPerSecond * seconds;
    reached.x += stride * std::sin(reached.headingRadians);
    reached.z -= stride * std::cos(reached.headingRadians);
  }
  return reached;
}

}  // namespace ocelli
