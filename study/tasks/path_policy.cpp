#include "study/tasks/path_policy.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include "oc_core/base/conventions.h"

namespace ocelli {
namespace {

/// People take an image on a screen for a view about so wide, degrees: half of it lies to either side of its middle.
constexpr double kHalfViewDegrees = 35;
/// Slower than that, degrees from one fixation to the next, it is a sway and no turn.
constexpr double kStillDegrees = 3;
/// A turn is by a right angle here; half of one is none yet.
constexpr double kTurnDegrees = 45;
/// Of what the flow of the image tells, a share: people misjudge how fast a scene turns by about a tenth.
constexpr double kFlowSpread = 0.1;
constexpr size_t kMinSpots = 4;
/// What a turn to the wrong side weighs, and a turn too many or too few, against a time that is off by its spread.
constexpr double kWrongSide = 6;
constexpr double kMissing = 4;
constexpr double kPathAgainSeconds = 6;

double angleOf(const SurfaceSpot& spot, const PixelRect& view) {
  const double share = (spot.centroid.x - view.center().x) / (view.width / 2);
  return degreesFromRadians(std::atan(share * std::tan(radiansFromDegrees(kHalfViewDegrees))));
}

/// The turns of a map and the lengths before them.
std::vector<PathPolicy::Turn> turnsOf(const SeenMap& map) {
  std::vector<PathPolicy::Turn> turns;
  for (size_t i = 1; i + 1 < map.corners.size(); ++i) {
    const glm::dvec2 in = map.corners[i] - map.corners[i - 1];
    const glm::dvec2 out = map.corners[i + 1] - map.corners[i];
    // y runs down: to the right is clockwise.
    turns.push_back({in.x * out.y - in.y * out.x > 0 ? 1 : -1, glm::length(in)});
  }
  return turns;
}

/// As shares of their sum.
void normalize(std::vector<PathPolicy::Turn>& turns) {
  double sum = 0;
  for (const PathPolicy::Turn& turn : turns) {
    sum += turn.secondsBefore;
  }
  for (PathPolicy::Turn& turn : turns) {
    turn.secondsBefore = sum > 0 ? turn.secondsBefore / sum : 0;
  }
}

}  // namespace

double PathPolicy::think(const Percept& seen, int64_t from, int64_t now, MotorModel& motor) {
  if (!seen.maps.empty()) {
    noteTurn(std::exchange(turning_, 0), from);  // the last one may have ended the path
    answer(seen, now, motor);
  } else if (!seen.views.empty()) {
    watch(seen, from);
  }
  return 0;
}

std::optional<double> PathPolicy::turnedDegrees(const Percept& seen) const {
  const auto isBefore = [](const SurfaceSpot& a, const SurfaceSpot& b) {
    return std::tie(a.cube.x, a.cube.y, a.cube.z) < std::tie(b.cube.x, b.cube.y, b.cube.z);
  };
  std::vector<double> moved;
  for (const SurfaceSpot& spot : seen.surfaces) {
    const auto same = std::lower_bound(before_.begin(), before_.end(), spot, isBefore);
    if (same != before_.end() && same->cube == spot.cube) {
      moved.push_back(angleOf(*same, seen.views.front()) - angleOf(spot, seen.views.front()));
    }
  }
  if (moved.size() < kMinSpots) {
    return std::nullopt;
  }
  const auto middle = moved.begin() + static_cast<std::ptrdiff_t>(moved.size() / 2);
  std::nth_element(moved.begin(), middle, moved.end());
  return *middle;
}

void PathPolicy::watch(const Percept& seen, int64_t from) {
  if (began_ < 0) {
    began_ = from;
    lastTurn_ = from;
  } else {
    // Where nothing is left of what was seen before, it still turns as it did.
    const double degrees = turnedDegrees(seen).value_or(turning_ == 0 ? 0 : std::copysign(kStillDegrees + 1, turning_));
    const double felt = degrees * normal(random_, 1, kFlowSpread);
    const bool goesOn = std::abs(felt) >= kStillDegrees && (turning_ == 0 || (felt > 0) == (turning_ > 0));
    if (!goesOn && turning_ != 0) {
      noteTurn(turning_, from);
      turning_ = 0;
    }
    turning_ += std::abs(felt) >= kStillDegrees ? felt : 0;
  }
  before_ = seen.surfaces;
}

void PathPolicy::noteTurn(double degrees, int64_t at) {
  if (std::abs(degrees) < kTurnDegrees) {
    return;
  }
  const HumanFactors& factors = vision_.factors();
  int side = degrees > 0 ? 1 : -1;
  if (happens(random_, factors.turnLapse)) {
    if (happens(random_, 0.5)) {
      return;
    }
    side = -side;
  }
  const double seconds = secondsOf(at - lastTurn_) * std::exp(normal(random_, 0, factors.timeSpread));
  turns_.push_back({side, seconds});
  lastTurn_ = at;
}

double PathPolicy::mismatch(const SeenMap& map) const {
  std::vector<Turn> shown = turnsOf(map);
  std::vector<Turn> felt = turns_;
  normalize(shown);
  normalize(felt);
  // The cheapest way to pair the turns in order, some of either left alone (Levenshtein's distance with weights).
  const size_t rows = felt.size();
  const size_t columns = shown.size();
  std::vector<std::vector<double>> cost(rows + 1, std::vector<double>(columns + 1, 0));
  for (size_t i = 0; i <= rows; ++i) {
    for (size_t j = 0; j <= columns; ++j) {
      if (i == 0 || j == 0) {
        cost[i][j] = kMissing * static_cast<double>(i + j);
        continue;
      }
      const double off = std::log((felt[i - 1].secondsBefore + 0.02) / (shown[j - 1].secondsBefore + 0.02));
      const double time = std::min(std::abs(off) / (2 * vision_.factors().timeSpread), kMissing / 2);
      const double pair = (felt[i - 1].side == shown[j - 1].side ? 0 : kWrongSide) + time;
      cost[i][j] = std::min({cost[i - 1][j - 1] + pair, cost[i - 1][j] + kMissing, cost[i][j - 1] + kMissing});
    }
  }
  return cost[rows][columns];
}

void PathPolicy::answer(const Percept& seen, int64_t now, MotorModel& motor) {
  if (seen.choices.empty() || now < answersAgainAt_) {
    return;
  }
  size_t best = 0;
  double least = 0;
  for (size_t i = 0; i < std::min(seen.maps.size(), seen.choices.size()); ++i) {
    const double off = mismatch(seen.maps[i]) + normal(random_, 0, 0.5);
    if (i == 0 || off < least) {
      best = i;
      least = off;
    }
  }
  effort_ = std::max(least, 0.0);
  const bool slips = happens(random_, vision_.factors().slip);
  const size_t pressed = slips ? (best + 1) % seen.choices.size() : best;
  const double seconds = vision_.factors().decideSeconds * static_cast<double>(1 + seen.maps.size());
  motor.tap(seen.choices[pressed].key, now + nanosecondsOf(seconds * normalWithin(random_, 1, 0.2, 0.5, 2)));
  answersAgainAt_ = now + nanosecondsOf(seconds * 2 + kPathAgainSeconds);
}

}  // namespace ocelli
