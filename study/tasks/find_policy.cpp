#include "study/tasks/find_policy.h"

#include <algorithm>

#include "oc_core/base/conventions.h"

namespace ocelli {
namespace {

/// One is where one wanted to go when that near to it, metres.
constexpr double kArrived = 0.3;
/// So far from the middle of a corridor one can still go along it, metres.
constexpr double kAside = 0.8;
/// From there on one turns first and then walks, degrees.
constexpr double kTurnFirstDegrees = 40;
constexpr double kStraightDegrees = 4;
/// By more than that one does not turn while walking on, degrees.
constexpr double kMaxRoundedDegrees = 120;
/// Of the time that a turn takes, when most of it is done.
constexpr double kTurnedShare = 0.7;
constexpr int kStuckFixations = 3;
/// Fixations without the object after which one goes on looking for it elsewhere.
constexpr int kLostFixations = 8;
/// What stands nearer may be below the view, metres: it is for tall eyes, from 1.2 m it is half of that.
constexpr double kTooNear = 2.5;
/// Steps back from it, and at most so far back to where it was seen from, metres.
constexpr double kStepBack = 1;
constexpr double kMaxBack = 2;
/// Of two ways one sticks to the one chosen before while it costs less than that times the other.
constexpr double kStickiness = 1.25;
/// Where one has looked before, but is not sure of it any more, one looks again when it is that much nearer.
constexpr double kAgainFactor = 3;
/// What is seen so far from where it was first seen moves: more than the radius of an object, half of which may have
/// been hidden. What is not, after so long, stays.
constexpr double kMovedMeters = 0.5;
constexpr double kStayedSeconds = 1;
/// Of something that moves one knows for so much shorter where it was not.
constexpr double kMovingShare = 0.5;
/// For something to look at in the distance, pixels of floor count with that power: much floor is not much more.
constexpr double kFloorPower = 0.5;

double headingTo(const glm::dvec2& from, const glm::dvec2& to) {
  return std::atan2(to.x - from.x, from.y - to.y);
}
glm::dvec2 placeOf(const WalkerPose& pose) {
  return {pose.x, pose.z};
}

}  // namespace

FindPolicy::FindPolicy(const Vision& vision, const Controls& controls, MazeMemory& memory, uint64_t seed)
    : vision_(vision), controls_(controls), memory_(memory), random_(seed) {
  memory_.beginTrial(vision.factors().forgetPerTrial, random_);
}

double FindPolicy::think(const Percept& seen, int64_t from, int64_t now, MotorModel& motor) {
  if (!gaze_) {
    gaze_ = seen.views.empty() ? glm::dvec2(0) : seen.views.front().center();
  }
  if (seen.pointer && !motor.isPointing(from)) {
    motor.seePointer(*seen.pointer);
  }
  learn(seen, from);
  const auto object = std::find_if(seen.objects.begin(), seen.objects.end(), [&](const Sighting& each) {
    return each.shape == seen.soughtShape && each.color == seen.soughtColor && vision_.notices(each, *gaze_);
  });
  if (object != seen.objects.end()) {
    missed_ = 0;
    inSight_ += secondsOf(now - from);
    gaze_ = object->centroid;
    foundAt_ = object->place;
    noteWhetherItMoves(object->place, from);
    foundFrom_ = seen.standing.value_or(foundFrom_);
    if (!found_ && inSight_ >= vision_.factors().noticeSeconds) {
      stopFor(now, motor);
    }
    if (found_) {
      goFor(*object, from, now, motor);
      return 0;
    }
  } else {
    before_.reset();
    if (!found_ && inSight_ > 0) {
      stopFor(now, motor);  // of what one caught a glimpse
    }
    inSight_ = 0;
    if (found_ && ++missed_ > kLostFixations) {
      found_ = false;
      lead_ = seen.grid.cellAt(foundAt_);
      since_ = from;  // it moves: whatever was seen before may hide it now
    }
  }
  noteWhetherStuck(seen, from, motor);
  if (found_ && now >= stopsAt_) {
    faceAgain(seen, from, now, motor);
  } else if (!found_) {
    walk(seen, from, now, motor);
    if (object == seen.objects.end()) {
      lookOn(seen);
    }
  }
  return 0;
}

void FindPolicy::noteWhetherItMoves(const glm::dvec2& place, int64_t from) {
  if (!first_) {
    first_ = Seen{place, from};
  } else if (glm::distance(place, first_->place) > kMovedMeters) {
    memory_.noteMotion(true);
  } else if (secondsOf(from - first_->at) > kStayedSeconds) {
    memory_.noteMotion(false);
  }
}

void FindPolicy::stopFor(int64_t now, MotorModel& motor) {
  found_ = true;
  missed_ = 0;
  stopsAt_ = now + nanosecondsOf(vision_.factors().reactionSeconds);
  motor.release(stopsAt_);
}

void FindPolicy::faceAgain(const Percept& seen, int64_t from, int64_t now, MotorModel& motor) {
  if (!seen.standing || motor.isPanning(now)) {
    return;
  }
  gaze_ = seen.views.front().center();
  const int64_t at = now + nanosecondsOf(vision_.factors().reactionSeconds);
  const WalkerPose pose = motor.reckon(*seen.standing, from, at);
  // As far back as one has walked on since, or away from what is below the view.
  const double on = std::min(glm::distance(placeOf(pose), placeOf(foundFrom_)), kMaxBack);
  const double back = glm::distance(placeOf(pose), foundAt_) < kTooNear ? std::max(on, kStepBack) : on;
  std::vector<MotorModel::Hold> holds;
  if (back > kArrived) {
    holds.push_back({controls_.backward, at, at + nanosecondsOf(back / controls_.walkMetersPerSecond)});
  }
  const double degrees = degreesFromRadians(std::remainder(foundFrom_.headingRadians - pose.headingRadians, 2 * kPi));
  if (std::abs(degrees) > kStraightDegrees) {
    turn(degrees, at, holds, motor);
  } else {
    motor.plan(at, holds);
  }
}

void FindPolicy::learn(const Percept& seen, int64_t from) {
  for (const FloorPatch& patch : seen.floor) {
    if (vision_.takesIn(patch, *gaze_)) {
      memory_.see(patch, from);
      if (patch.straight && seen.standing) {
        memory_.seeAlong(seen.grid, placeOf(*seen.standing), patch.place);
      }
    }
  }
  if (seen.standing && !stood_) {
    memory_.visit(seen.grid.cellAt(placeOf(*seen.standing)), from);
  }
  sure_ = from - nanosecondsOf(vision_.factors().searchMemorySeconds * (memory_.soughtMoves() ? kMovingShare : 1));
}

void FindPolicy::goFor(const Sighting& object, int64_t from, int64_t now, MotorModel& motor) {
  const HumanFactors& factors = vision_.factors();
  const glm::dvec2 drift =
      before_ && from > before_->at ? (object.aim - before_->place) / secondsOf(from - before_->at) : glm::dvec2(0);
  before_ = Seen{object.aim, from};
  if (now < stopsAt_ || motor.isPointing(now)) {
    return;
  }
  // It is expected to go on as it did, but not by more than its size: one has seen it for two fixations.
  const glm::dvec2 size = object.upper - object.lower;
  const auto after = [&](double seconds) {
    const glm::dvec2 by = drift * seconds;
    const double most = std::max(size.x, size.y);
    return glm::length(by) > most ? by * (most / glm::length(by)) : by;
  };
  const double untilClick = secondsOf(now - from) + factors.clickSeconds;
  const glm::dvec2 under = motor.pointer() - after(untilClick);
  const bool isOver =
      under.x >= object.lower.x && under.y >= object.lower.y && under.x < object.upper.x && under.y < object.upper.y;
  if (isOver) {
    motor.click(now + nanosecondsOf(factors.clickSeconds));
  } else {
    const double longer = factors.reactionSeconds + 2 * factors.fixationSeconds;
    motor.point(object.aim + after(untilClick + longer), std::min(size.x, size.y),
                now + nanosecondsOf(factors.reactionSeconds / 2));
  }
}

void FindPolicy::noteWhetherStuck(const Percept& seen, int64_t from, const MotorModel& motor) {
  if (!seen.standing) {
    return;
  }
  if (stood_) {
    const WalkerPose expected = motor.reckon(*stood_, stoodAt_, from);
    const double wanted = glm::distance(placeOf(expected), placeOf(*stood_));
    const double went = glm::distance(placeOf(*seen.standing), placeOf(*stood_));
    stuck_ = wanted > 0.3 && went < wanted / 4 ? stuck_ + 1 : 0;
  }
  stood_ = seen.standing;
  stoodAt_ = from;
}

std::optional<MazeCell> FindPolicy::chooseGoal(const std::map<MazeCell, MazeMemory::Way>& ways, double cellSeconds) {
  if (lead_ && memory_.hasSearched(*lead_, since_)) {
    lead_.reset();  // it is not there any more
  }
  if (const auto led = lead_ ? ways.find(*lead_) : ways.end(); led != ways.end() && !led->second.cells.empty()) {
    return lead_;
  }
  std::optional<MazeCell> best;
  double least = 0;
  for (const auto& [cell, way] : ways) {
    if (way.cells.empty() || memory_.hasSearched(cell, std::max(since_, sure_))) {
      continue;
    }
    // What a way seems to cost does not change from one fixation to the next.
    const auto [felt, isNew] = feltCosts_.try_emplace(cell, 1.0);
    if (isNew) {
      felt->second = std::exp(normal(random_, 0, vision_.factors().wayNoise));
    }
    const double noise = felt->second;
    const double again = memory_.hasSearched(cell, since_) ? kAgainFactor : 1;
    // What lies ahead is seen from the cell before it.
    const double seconds = way.seconds - cellSeconds;
    const double cost = (seconds + 0.5) * again * noise / (goal_ == cell ? kStickiness : 1);
    if (!best || cost < least) {
      best = cell;
      least = cost;
    }
  }
  return best;
}

void FindPolicy::turn(double degrees, int64_t at, std::vector<MotorModel::Hold> holds, MotorModel& motor) const {
  if (!vision_.factors().turnsByMouse()) {
    holds.push_back({degrees > 0 ? controls_.turnRight : controls_.turnLeft, at, at + turnTime(degrees, motor)});
  }
  motor.plan(at, holds);
  if (vision_.factors().turnsByMouse()) {
    motor.pan(degrees, at);
  }
}

int64_t FindPolicy::turnTime(double degrees, const MotorModel& motor) const {
  return nanosecondsOf(vision_.factors().turnsByMouse() ? motor.panSeconds(degrees)
                                                        : std::abs(degrees) / controls_.turnDegreesPerSecond);
}

void FindPolicy::turnAround(int64_t at, MotorModel& motor) const {
  if (!motor.isPanning(at)) {
    turn(90, at, {}, motor);
  }
}

void FindPolicy::walkTo(const std::vector<glm::dvec2>& corners, bool looksAtLast, const WalkerPose& pose, int64_t at,
                        MotorModel& motor) const {
  const double speed = controls_.walkMetersPerSecond;
  std::vector<MotorModel::Hold> holds;
  std::vector<std::pair<double, int64_t>> pans;
  glm::dvec2 place = placeOf(pose);
  double heading = pose.headingRadians;
  int64_t time = at;
  bool walks = false;
  int64_t since = at;   // one walks
  double straight = 0;  // metres just walked without a turn
  const auto stop = [&] {
    if (walks) {
      holds.push_back({controls_.forward, since, time});
      walks = false;
    }
  };
  for (size_t i = 0; i < corners.size(); ++i) {
    const double degrees = degreesFromRadians(std::remainder(headingTo(place, corners[i]) - heading, 2 * kPi));
    const bool isLarge = std::abs(degrees) > kTurnFirstDegrees;
    const bool looksOnly = isLarge && looksAtLast && i + 1 == corners.size();
    double away = looksOnly ? 0 : glm::distance(corners[i], place);
    const int64_t seconds = turnTime(degrees, motor);
    const double reach = isLarge ? motor.panReach(degrees) : 0;
    if (isLarge && vision_.factors().turnsByMouse() && std::abs(degrees) < kMaxRoundedDegrees && walks &&
        straight > reach - kArrived && away > reach) {
      const int64_t begin = std::max(at, time - nanosecondsOf(reach / speed));
      pans.emplace_back(degrees, begin);
      time = begin + seconds;
      away -= reach;
    } else if (std::abs(degrees) > kStraightDegrees) {
      if (isLarge) {
        stop();
      }
      if (vision_.factors().turnsByMouse()) {
        pans.emplace_back(degrees, time);
      } else {
        holds.push_back({degrees > 0 ? controls_.turnRight : controls_.turnLeft, time, time + seconds});
      }
      // Out of large turns one sets out at their end.
      time += isLarge ? static_cast<int64_t>(static_cast<double>(seconds) * kTurnedShare) : 0;
    }
    if (away > kArrived) {
      since = walks ? since : time;
      walks = true;
      time += nanosecondsOf(away / speed);
    }
    straight = away;
    heading = headingTo(place, corners[i]);
    place = corners[i];
  }
  stop();
  motor.plan(at, holds);
  for (const auto& [degrees, begin] : pans) {
    motor.pan(degrees, begin);
  }
}

void FindPolicy::walk(const Percept& seen, int64_t from, int64_t now, MotorModel& motor) {
  const int64_t at = now + nanosecondsOf(vision_.factors().reactionSeconds);
  if (!seen.standing) {
    turnAround(at, motor);
    return;
  }
  if (motor.isPanning(at)) {
    return;  // a turn under way is brought to its end, and one walks on as one meant to
  }
  const WalkerPose pose = motor.reckon(*seen.standing, from, at);
  const SeenGrid& grid = seen.grid;
  // Reckoned, one may have gone through a wall: then one still is where one was seen.
  MazeCell here = grid.cellAt(placeOf(pose));
  const auto known = memory_.waysFrom(grid.cellAt(placeOf(*seen.standing)), pose.headingRadians, 1, 1);
  if (!known.contains(here)) {
    here = grid.cellAt(placeOf(*seen.standing));
  }
  if (stuck_ >= kStuckFixations) {
    stuck_ = 0;
    for (const Direction direction : kDirections) {
      if (next_ && here.neighbor(direction) == *next_) {
        memory_.feelWall(here, direction);
      }
    }
    goal_.reset();
    next_.reset();
    motor.plan(at, {{controls_.backward, at, at + nanosecondsOf(0.3)}});
    return;
  }
  const double cellSeconds = grid.cellSize / controls_.walkMetersPerSecond;
  const auto ways = memory_.waysFrom(here, pose.headingRadians, cellSeconds, secondsOf(turnTime(90, motor)));
  goal_ = chooseGoal(ways, cellSeconds);
  if (!goal_) {
    since_ = from + 1;  // all of it, again
    turnAround(at, motor);
    return;
  }
  const glm::dvec2 middle = grid.middleOf(here);
  const std::vector<MazeCell>& cells = ways.at(*goal_).cells;
  // As far as the way goes straight on; first to the middle of the cell, where it turns.
  next_ = cells.front();
  const bool alongRow = cells.front().row == here.row;
  const double aside = alongRow ? pose.z - middle.y : pose.x - middle.x;
  // Too far aside of the corridor ahead one goes there first.
  const glm::dvec2 abreast = alongRow ? glm::dvec2(pose.x, middle.y) : glm::dvec2(middle.x, pose.z);
  std::vector<glm::dvec2> corners;
  if (std::abs(aside) > kAside) {
    corners.push_back(abreast);
  }
  // As far ahead as the next corner but one.
  for (size_t i = 0; i < cells.size() && corners.size() < 3; ++i) {
    const MazeCell& before = i == 0 ? here : cells[i - 1];
    const bool goesOn =
        i + 1 < cells.size() && (before.row == cells[i + 1].row || before.column == cells[i + 1].column);
    if (!goesOn) {
      corners.push_back(grid.middleOf(cells[i]));
    }
  }
  walkTo(corners, cells.size() == 1, pose, at, motor);
}

void FindPolicy::lookOn(const Percept& seen) {
  // At the most floor that is new and near together; where nothing is new, ahead.
  double best = 0;
  glm::dvec2 there = seen.views.empty() ? *gaze_ : seen.views.front().center();
  for (const FloorPatch& patch : seen.floor) {
    if (memory_.hasSeen(patch, since_)) {
      continue;
    }
    double worth = 0;
    for (const FloorPatch& other : seen.floor) {
      if (!memory_.hasSeen(other, since_) &&
          vision_.degrees(patch.centroid, other.centroid) <= vision_.factors().usefulFieldDegrees / 2) {
        worth += std::pow(static_cast<double>(other.pixels), kFloorPower);
      }
    }
    worth /= 1 + vision_.degrees(*gaze_, patch.centroid) / vision_.factors().usefulFieldDegrees;
    if (worth > best) {
      best = worth;
      there = patch.centroid;
    }
  }
  gaze_ = there;
}

}  // namespace ocelli
