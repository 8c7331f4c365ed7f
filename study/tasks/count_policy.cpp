#include "study/tasks/count_policy.h"

#include <algorithm>
#include <charconv>

namespace ocelli {
namespace {

/// Regions of a large view are about so far apart: those within one useful field are seen together.
constexpr double kRegionDegrees = 9;
/// What is seen to be in the same place of the screen, and by how much more where time has passed, degrees.
constexpr double kSamePlaceDegrees = 1.2;
constexpr double kDriftDegreesPerSecond = 2.5;
/// By that much a thing must have moved from one fixation to the next for people to see that it moves.
constexpr double kMotionDegrees = 0.03;
/// An object may have gone so far meanwhile, metres; people know how fast things go here.
constexpr double kDriftMetersPerSecond = 1;
/// Places that differ by more than so many times their errors are two places: one is wrong in one of eight such cases.
constexpr double kErrorsApart = 2;
constexpr double kCountAgainSeconds = 4;

}  // namespace

double CountPolicy::think(const Percept& seen, int64_t from, int64_t now, MotorModel& motor) {
  if (seen.views.empty()) {
    answer(seen, now, motor);
    return 0;
  }
  if (regions_.empty()) {
    layOutRegions(seen);
  }
  noteMotion(seen);
  const double seconds = attend(seen, from);
  lookOn(seen, from);
  return seconds;
}

double CountPolicy::regionsLeft() const {
  const auto open = std::count_if(regions_.begin(), regions_.end(), [](const Region& each) { return !each.looked; });
  return sawAll_ ? 0 : static_cast<double>(open);
}

double CountPolicy::effort(double /*seconds*/) const {
  const double share = regions_.empty() ? 1 : regionsLeft() / static_cast<double>(regions_.size());
  return share + static_cast<double>(judgements_) / static_cast<double>(std::max<size_t>(items_.size(), 1));
}

void CountPolicy::layOutRegions(const Percept& seen) {
  singleView_ = seen.views.size() == 1;
  for (const PixelRect& view : seen.views) {
    const double step = kRegionDegrees * vision_.pixelsPerDegree();
    const int columns = std::max(1, static_cast<int>(std::lround(view.width / step)));
    const int rows = std::max(1, static_cast<int>(std::lround(view.height / step)));
    // From left to right, and in each column from top to bottom.
    for (int column = 0; column < columns; ++column) {
      for (int row = 0; row < rows; ++row) {
        regions_.push_back(
            {{view.left + (column + 0.5) * view.width / columns, view.top + (row + 0.5) * view.height / rows}});
      }
    }
  }
  gaze_ = regions_.front().middle;
}

/// Whether it is what was seen in that place of the same view.
bool CountPolicy::isThere(const Item& item, const Sighting& sighting, int64_t from) const {
  return item.view == sighting.view && item.color == sighting.color && item.shape == sighting.shape &&
         vision_.degrees(item.onScreen, sighting.centroid) <=
             kSamePlaceDegrees + (moves_ ? kDriftDegreesPerSecond * secondsOf(from - item.at) : 0);
}

bool CountPolicy::isAttended(const Sighting& sighting, int64_t from) const {
  const auto isThat = [&](const Item& item) { return isThere(item, sighting, from); };
  return std::any_of(items_.begin(), items_.end(), isThat) || std::any_of(passed_.begin(), passed_.end(), isThat);
}

/// Whether it is taken for something that was counted elsewhere: in another view, or before it moved.
bool CountPolicy::seemsSame(const Item& item, const Sighting& sighting, int64_t from, const glm::dvec2& seemsAt) {
  const bool otherView = item.view != sighting.view;
  if (item.shape != sighting.shape || item.color != sighting.color || (!otherView && (!moves_ || item.at == from))) {
    return false;
  }
  judgements_ += otherView ? 1 : 0;
  const HumanFactors& factors = vision_.factors();
  const bool isRemembered = happens(random_, factors.workingMemoryItems / static_cast<double>(items_.size()));
  const double error = std::sqrt(2.0) * (otherView ? factors.crossViewErrorMeters : factors.placeErrorMeters);
  const double drift = moves_ ? kDriftMetersPerSecond * secondsOf(from - item.at) : 0;
  return isRemembered && glm::distance(item.seemsAt, seemsAt) <= kErrorsApart * error + drift;
}

void CountPolicy::count(const Sighting& sighting, int64_t from) {
  const double error = singleView_ ? vision_.factors().placeErrorMeters : vision_.factors().crossViewErrorMeters;
  const Item seen{sighting.shape, sighting.color,
                  sighting.view,  sighting.centroid,
                  from,           sighting.place + glm::dvec2(normal(random_, 0, error), normal(random_, 0, error))};
  const auto goesOnAs = [&](Item& item) {
    item.onScreen = seen.onScreen;
    item.at = from;
    item.seemsAt = seen.seemsAt;
  };
  for (std::vector<Item>* list : {&items_, &passed_}) {
    for (Item& item : *list) {
      // One thing is not two at once.
      if (item.at < from && isThere(item, sighting, from)) {
        goesOnAs(item);
        return;
      }
    }
  }
  for (Item& item : items_) {
    if (item.metAt < from && seemsSame(item, sighting, from, seen.seemsAt)) {
      item.metAt = from;
      if (item.view == sighting.view) {
        goesOnAs(item);
      } else {
        passed_.push_back(seen);
      }
      return;
    }
  }
  items_.push_back(seen);
}

void CountPolicy::noteMotion(const Percept& seen) {
  for (const Sighting& now : seen.objects) {
    for (const Sighting& before : before_) {
      const double moved = vision_.degrees(now.centroid, before.centroid);
      moves_ = moves_ || (now.view == before.view && now.color == before.color && now.shape == before.shape &&
                          moved > kMotionDegrees && moved < kSamePlaceDegrees && vision_.notices(now, *gaze_));
    }
  }
  before_ = seen.objects;
}

double CountPolicy::attend(const Percept& seen, int64_t from) {
  const HumanFactors& factors = vision_.factors();
  int attended = 0;
  for (const Sighting& sighting : seen.objects) {
    const bool isNear = vision_.degrees(sighting.centroid, *gaze_) <= factors.groupRadiusDegrees;
    if (isNear && vision_.notices(sighting, *gaze_)) {
      attended += isAttended(sighting, from) ? 0 : 1;
      count(sighting, from);
    }
  }
  for (Region& region : regions_) {
    region.looked = region.looked || vision_.degrees(region.middle, *gaze_) <= factors.groupRadiusDegrees;
  }
  const double needed = attended <= factors.groupItems ? factors.groupSeconds * attended
                                                       : factors.groupSeconds * factors.groupItems +
                                                             factors.itemSeconds * (attended - factors.groupItems);
  return std::max(0.0, needed - factors.fixationSeconds / 2);
}

void CountPolicy::lookOn(const Percept& seen, int64_t from) {
  // At the next thing that stands out and has not been counted: in this view first, then in the order of views.
  const auto isNew = [&](const Sighting& each) { return vision_.notices(each, *gaze_) && !isAttended(each, from); };
  const auto next = std::find_if(regions_.begin(), regions_.end(), [](const Region& each) { return !each.looked; });
  const double limit = vision_.factors().usefulFieldDegrees;
  const Sighting* best = nullptr;
  for (const Sighting& each : seen.objects) {
    if (isNew(each) && vision_.degrees(each.centroid, *gaze_) <= limit &&
        (best == nullptr || vision_.degrees(each.centroid, *gaze_) < vision_.degrees(best->centroid, *gaze_))) {
      best = &each;
    }
  }
  if (best != nullptr) {
    gaze_ = best->centroid;
  } else if (next != regions_.end()) {
    gaze_ = next->middle;
  } else if (!sawAll_) {
    sawAll_ = true;  // once more, for what was missed
    for (Region& region : regions_) {
      region.looked = false;
    }
  }
}

void CountPolicy::answer(const Percept& seen, int64_t now, MotorModel& motor) {
  if (seen.choices.empty() || now < answersAgainAt_) {
    return;
  }
  const double open = regionsLeft();
  const double looked = static_cast<double>(regions_.size()) - open;
  // As many new ones are to be expected there as elsewhere.
  const auto counted = static_cast<double>(items_.size());
  const double guess = counted + (looked > 0 ? counted / looked * open : 0);
  const SeenChoice* best = nullptr;
  double least = 0;
  for (const SeenChoice& choice : seen.choices) {
    int number = 0;
    std::from_chars(choice.label.data(), choice.label.data() + choice.label.size(), number);
    const double off = std::abs(number - guess);
    if (best == nullptr || off < least) {
      best = &choice;
      least = off;
    }
  }
  const size_t index = static_cast<size_t>(best - seen.choices.data());
  const bool slips = happens(random_, vision_.factors().slip);
  const size_t pressed = slips ? (index + 1) % seen.choices.size() : index;
  motor.tap(seen.choices[pressed].key,
            now + nanosecondsOf(vision_.factors().decideSeconds * normalWithin(random_, 1, 0.25, 0.4, 2.5)));
  answersAgainAt_ = now + nanosecondsOf(kCountAgainSeconds);
}

}  // namespace ocelli
