#include "oc_core/constructor/walk_turn.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "oc_core/base/conventions.h"
#include "oc_core/base/error.h"

namespace ocelli {
namespace {

constexpr const char* kWalkTurn = "turn in a walk map";

double angleBetween(const glm::dvec2& from, const glm::dvec2& to) {
  return std::atan2(planCross(from, to), glm::dot(from, to));
}

glm::dvec2 turnedBy(const glm::dvec2& v, double angle) {
  return {v.x * std::cos(angle) - v.y * std::sin(angle), v.x * std::sin(angle) + v.y * std::cos(angle)};
}

class WalkTurning {
 public:
  WalkTurning(const WalkSpace& space, const WalkTurn& turn, const WalkCameraOptions& options, int width, int height)
      : space_(space), turn_(turn), options_(options), width_(width), height_(height) {
    options_.backward = false;
    const WalkCamera now = makeWalkCamera(space, turn.from, options_, width, height);
    const bool inTunnel =
        now.cell && space.map().cells[*now.cell].kind == WalkCellKind::kTunnel && now.crossing.has_value();
    if (!inTunnel) {
      throw InputError("no crossing lies ahead: " + (now.note.empty() ? "the user is in a room" : now.note), kWalkTurn,
                       "turn where a tunnel leads to a crossing");
    }
    heading_ = glm::normalize(planOf(turn.from.heading));
    ahead_ = lookAhead(space, *space.regionAt(turn.from.eye), planOf(turn.from.eye), heading_);
    deployed_ = now.deployed;
    const WalkCamera back = camera(turn.from, backwards(options_));
    deployedBack_ = back.deployed;
    for (const WalkExit& exit : space.regions()[ahead_.opening->region].exits) {
      if (exit.portal == turn.portal && exit.portal != WalkExit::kWithin && exit.portal != ahead_.opening->portal) {
        way_ = exit;
        return;
      }
    }
    throw InputError(fmt::format("{} is no way out of the crossing ahead, {}", nameOfOpening(turn.portal),
                                 nameOfCell(*now.crossing)),
                     kWalkTurn, "choose one of its other openings");
  }

  WalkPose after() const { return poseAt(way_.mouth.width() / 2); }

  WalkCamera forward() const {
    if (turn_.phase >= 3) {
      return camera(walking(), options_);
    }
    WalkCameraOptions options = options_;
    const double chosen = std::max(0.0, 2 * step(1) - 1);
    options.deployed = glm::mix(deployed_, 1.0, step(1));
    options.parallel = std::min(1.0, 2 * step(1));
    options.chosenPortal = turn_.portal;
    options.chosenShare = chosen;
    options.chosenOpen = step(2);
    options.fovWayDegrees = glm::mix(options_.fovWayDegrees, options_.fovHorizontalDegrees, step(2));
    return camera(turn_.from, options);
  }

  WalkCamera backward() const {
    if (turn_.phase >= 3) {
      return camera(walking(), backwards(options_));
    }
    if (turn_.phase <= 1) {
      WalkCameraOptions options = backwards(options_);
      options.deployed = glm::mix(deployedBack_, 0.0, step(0));
      return camera(turn_.from, options);
    }
    const glm::dvec3 eye = glm::mix(turn_.from.eye, newEye(), step(2));
    const double angle = angleBetween(heading_, way_.mouth.ahead()) * step(2);
    WalkCameraOptions options = backwards(options_);
    return {GraphCamera(walkPinhole(space_, {eye, spaceOf(turnedBy(heading_, angle), 0)}, options, width_, height_))};
  }

 private:
  /// How far the step from `begin` to the next whole number is, 0 to 1.
  double step(int begin) const { return std::clamp(turn_.phase - begin, 0.0, 1.0); }

  static WalkCameraOptions backwards(WalkCameraOptions options) {
    options.backward = true;
    return options;
  }
  WalkCamera camera(const WalkPose& pose, const WalkCameraOptions& options) const {
    return makeWalkCamera(space_, pose, options, width_, height_);
  }
  /// In the middle of the chosen way, so far beyond its mouth.
  WalkPose poseAt(double beyond) const {
    const WalkMouth& mouth = way_.mouth;
    const double eyeHeight = turn_.from.eye.y - ahead_.opening->mouth.floor;
    return {spaceOf(mouth.middle() + mouth.ahead() * beyond, mouth.floor + eyeHeight), spaceOf(mouth.ahead(), 0)};
  }
  /// From where the mouth of the chosen way fills the image.
  glm::dvec3 newEye() const {
    const double half = way_.mouth.width() / 2;
    return poseAt(-half / std::tan(radiansFromDegrees(options_.fovHorizontalDegrees) / 2)).eye;
  }
  WalkPose walking() const { return {glm::mix(newEye(), after().eye, step(3)), after().heading}; }

  const WalkSpace& space_;
  const WalkTurn& turn_;
  WalkCameraOptions options_;
  int width_;
  int height_;
  glm::dvec2 heading_{0};
  WalkAhead ahead_;
  WalkExit way_;  ///< the chosen one
  double deployed_ = 0;
  double deployedBack_ = 0;
};

}  // namespace

WalkPose walkPoseAfter(const WalkSpace& space, const WalkTurn& turn) {
  return WalkTurning(space, turn, {}, 64, 64).after();
}

std::pair<WalkCamera, WalkCamera> walkTurningCameras(const WalkSpace& space, const WalkTurn& turn,
                                                     const WalkCameraOptions& options, int width, int height) {
  if (!(turn.phase >= 0 && turn.phase <= 4)) {
    throw InputError(fmt::format("the phase {} is not from 0 to 4", turn.phase), kWalkTurn, "each step is one unit");
  }
  const WalkTurning turning(space, turn, options, width, height);
  return {turning.forward(), turning.backward()};
}

}  // namespace ocelli
