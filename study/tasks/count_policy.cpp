#include "study/tasks/count_policy.h"

#include <algorithm>
#include <charconv>

#include "oc_core/base/conventions.h"

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
/// Places that differ by more than so many times the error of their difference are two places: one is wrong in one of
/// seven such cases (exp(-kErrorsApart^2 / 2)).
constexpr double kErrorsApart = 2;
/// Turns of the picture by that much, or more, are all alike.
constexpr double kFullTurn = kPi / 2;
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
  followWithEyes(seen, from);
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

CountPolicy::Item CountPolicy::itemOf(const Sighting& sighting, int64_t from) {
  Item item{.shape = sighting.shape,
            .color = sighting.color,
            .view = sighting.view,
            .onScreen = sighting.centroid,
            .at = from,
            .place = sighting.place,
            .seemsAt = sighting.place,
            .perspective = sighting.perspective,
            .attendedAt = from};
  if (item.perspective) {
    const double pixels = vision_.factors().placeErrorDegrees * vision_.pixelsPerDegree();
    item.seemsAt += item.perspective->metersFrom({normal(random_, 0, pixels), normal(random_, 0, pixels)});
  }
  return item;
}

/// Whether two things may be at one place, as far as one can tell. Where the picture does not tell places, they may.
bool CountPolicy::placesMatch(const Item& item, const Item& seen) {
  if (!item.perspective || !seen.perspective) {
    return true;
  }
  const HumanFactors& factors = vision_.factors();
  const double pixels = factors.placeErrorDegrees * vision_.pixelsPerDegree();
  // A place is remembered by what is around it in the picture, as far as one takes that in. Carried over to where the
  // picture is turned, it comes to lie aside by the error of the turn, at half of that distance on average.
  const double around = factors.usefulFieldDegrees / 2 * vision_.pixelsPerDegree() / item.perspective->pixelsPerMeter();
  const double turn = std::min(turnBetween(*item.perspective, *seen.perspective) / kFullTurn, 1.0);
  const double aside = around * radiansFromDegrees(factors.turnErrorDegrees) * turn;
  const glm::dmat2 covariance =
      item.perspective->placeCovariance(pixels) + seen.perspective->placeCovariance(pixels) + glm::dmat2(aside * aside);
  glm::dvec2 apart = seen.seemsAt - item.seemsAt + glm::dvec2(normal(random_, 0, aside), normal(random_, 0, aside));
  const double drift = moves_ ? kDriftMetersPerSecond * secondsOf(seen.at - item.at) : 0;
  const double length = glm::length(apart);
  apart *= length > 0 ? std::max(0.0, 1 - drift / length) : 1;
  if (!(glm::determinant(covariance) > 0)) {
    return apart == glm::dvec2(0);  // one that is never wrong
  }
  return glm::dot(apart, glm::inverse(covariance) * apart) <= kErrorsApart * kErrorsApart;
}

/// Whether it is taken for something that was counted elsewhere: in another view, or before it moved.
bool CountPolicy::seemsSame(const Item& item, const Item& seen) {
  const bool otherView = item.view != seen.view;
  if (item.shape != seen.shape || item.color != seen.color || (!otherView && (!moves_ || item.at == seen.at))) {
    return false;
  }
  judgements_ += otherView ? 1 : 0;
  const bool isRemembered = happens(random_, vision_.factors().workingMemoryItems / static_cast<double>(items_.size()));
  return isRemembered && placesMatch(item, seen);
}

void CountPolicy::count(const Sighting& sighting, int64_t from) {
  const Item seen = itemOf(sighting, from);
  const auto goesOnAs = [&](Item& item) {
    item.onScreen = seen.onScreen;
    item.at = from;
    item.attendedAt = from;
    item.followedAt = -1;
    item.place = seen.place;
    item.seemsAt = seen.seemsAt;
    item.perspective = seen.perspective;
  };
  for (std::vector<Item>* list : {&items_, &passed_}) {
    for (Item& item : *list) {
      // One thing is not two at once.
      if ((item.at < from || item.followedAt == from) && isThere(item, sighting, from)) {
        goesOnAs(item);
        return;
      }
    }
  }
  for (Item& item : items_) {
    if (item.metAt < from && seemsSame(item, seen)) {
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

void CountPolicy::followWithEyes(const Percept& seen, int64_t from) {
  // Those looked at last; what was counted and what was taken for it alike.
  std::vector<Item*> moving;
  for (std::vector<Item>* list : {&items_, &passed_}) {
    for (Item& item : *list) {
      if (moves_ && item.at < from) {
        moving.push_back(&item);
      }
    }
  }
  std::stable_sort(moving.begin(), moving.end(), [](const Item* a, const Item* b) {
    return a->moves != b->moves ? a->moves : a->attendedAt > b->attendedAt;
  });
  moving.resize(std::min(moving.size(), static_cast<size_t>(vision_.factors().trackedItems)));
  for (Item* item : moving) {
    const double reach = kSamePlaceDegrees + kDriftDegreesPerSecond * secondsOf(from - item->at);
    const Sighting* nearest = nullptr;
    double least = reach;
    for (const Sighting& each : seen.objects) {
      const double degrees = vision_.degrees(each.centroid, item->onScreen);
      if (each.view == item->view && each.color == item->color && each.shape == item->shape && degrees <= least &&
          vision_.notices(each, *gaze_)) {
        nearest = &each;
        least = degrees;
      }
    }
    if (nearest != nullptr) {
      const bool isLookedAt = vision_.degrees(item->onScreen, *gaze_) < kSamePlaceDegrees;
      item->moves = item->moves || least > kMotionDegrees;
      item->seemsAt += nearest->place - item->place;
      item->place = nearest->place;
      item->onScreen = nearest->centroid;
      item->perspective = nearest->perspective;
      item->at = from;
      item->followedAt = from;
      if (isLookedAt) {
        gaze_ = nearest->centroid;  // the eye goes with it
      }
    }
  }
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
