#include "oc_core/constructor/walk_camera.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "oc_core/base/conventions.h"
#include "oc_core/base/error.h"
#include "oc_core/constructor/frustum_image.h"
#include "oc_core/constructor/maze_horizon.h"
#include "oc_core/constructor/walk_ways.h"

namespace ocelli {
namespace {

constexpr const char* kWalkCamera = "maze camera";
/// One over how much farther away the viewpoint of parallel rays lies.
constexpr double kWalkParallel = 1.0 / 200;
/// The largest share of the image that the opening ahead takes where it is as wide as the tunnel.
constexpr double kMaxOpening = 0.97;
/// The way deploys along a tunnel; across it it does not. Between these angles from its axis it does less.
constexpr double kAlongDegrees = 15;
constexpr double kAcrossDegrees = 60;
/// Less than this is nothing.
constexpr double kMinDeployed = 1e-6;
/// Near an opening beside it the tunnel's ways are retracted, over so many half widths of the tunnel.
constexpr double kBesideReach = 0.5;

/// The root frustum.
struct RootLens {
  double behind = 0;   ///< the eye, of the user
  double tangent = 1;  ///< of half the horizontal field of view
  double aside = 0;    ///< where the view direction meets the image: to the right of its middle, in image widths
  double down = 0;     ///< and below it, in image heights
};

void checkWalkPose(const WalkPose& pose, const WalkCameraOptions& options) {
  if (!std::isfinite(glm::length(pose.eye)) || !std::isfinite(glm::length(pose.heading)) ||
      !(glm::length(planOf(pose.heading)) > 1e-6 * glm::length(pose.heading))) {
    throw InputError("the eye is not finite, or the heading has no level part", kWalkCamera, "change them");
  }
  const auto& [left, ahead, right] = options.split;
  if (!(left >= 0 && ahead >= 0 && right >= 0) || !(std::abs(left + ahead + right - 1) < 1e-6)) {
    throw InputError(
        fmt::format("the shares of \"split\", {}, {} and {}, are negative or do not add up to 1", left, ahead, right),
        kWalkCamera, "give three numbers from 0 to 1 that add up to 1");
  }
  const auto range = [](double value, double least, double most, const char* name) {
    if (!(value >= least && value <= most)) {
      throw InputError(fmt::format("\"{}\" is {}, and must be from {} to {}", name, value, least, most), kWalkCamera,
                       "change it");
    }
  };
  range(options.fovHorizontalDegrees, 10, 150, "fov_degrees");
  range(options.fovWayDegrees, 1, 150, "corridor_fov_degrees");
  range(options.crossingShare, 0.05, 0.98, "crossing_share");
  range(options.deployWidths, 0.01, 100, "deploy_cells");
  range(options.portalsInRooms, 0, 1, "portals_in_rooms");
  range(options.lowered, 0, 1, "lowered");
  range(options.parallel, 0, 1, "parallel");
  range(options.deployed.value_or(0), 0, 1, "deployed");
  range(options.chosenShare, 0, 1, "chosen share");
  range(options.chosenOpen, 0, 1, "chosen open");
}

View rootView(const WalkSpace& space, const glm::dvec3& eye, const glm::dvec2& direction, const RootLens& lens,
              double aspect, double size) {
  const glm::dvec3 forward = spaceOf(direction, 0);
  View view;
  view.eye = glm::vec3(eye - forward * lens.behind);
  view.target = glm::vec3(eye + forward * size);
  view.fovVerticalDegrees = degreesFromRadians(2 * std::atan(lens.tangent / aspect));
  view.centerShift = {static_cast<float>(lens.aside * aspect), static_cast<float>(lens.down)};
  view.zNear = static_cast<float>(std::max(lens.behind, 0.01 * space.size()));
  view.zFar = static_cast<float>(lens.behind + std::max(8 * space.reach(), space.reachFrom(eye)));
  return view;
}

double tangentOf(double degrees) {
  return std::tan(radiansFromDegrees(degrees) / 2);
}

class WalkCameraBuilder {
 public:
  WalkCameraBuilder(const WalkSpace& space, const WalkPose& pose, const WalkCameraOptions& options, int width,
                    int height)
      : space_(space), options_(options), width_(width), height_(height), eye_(pose.eye) {
    heading_ = glm::normalize(planOf(pose.heading)) * (options.backward ? -1.0 : 1.0);
  }

  WalkCamera build() const {
    WalkCamera result{pinhole()};
    if (space_.regions().empty()) {
      result.note = "the scene has no floor to walk on";
      return result;
    }
    const std::optional<uint32_t> region = space_.regionAt(eye_);
    if (!region) {
      result.note = "there is no walkable floor below, or no ceiling above";
      return result;
    }
    result.cell = space_.regions()[*region].cell;
    if (space_.map().cells[*result.cell].kind == WalkCellKind::kTunnel) {
      inTunnel(result, *region);
    } else {
      inRoom(result, *region);
    }
    if (result.note.empty() &&
        std::none_of(result.ways.begin(), result.ways.end(), [](const WalkWay& way) { return way.frustum >= 0; })) {
      result.note = result.deployed > 0 ? "no way out can be seen from here" : "ways are retracted here";
    }
    return result;
  }

 private:
  GraphCamera pinhole() const {
    RootLens lens{0, tangentOf(options_.fovHorizontalDegrees), 0};
    lens.down = options_.lowered * horizonShift(0, 0);
    return GraphCamera(PinholeCamera(rootView(space_, eye_, heading_, lens, aspect(), space_.size()), width_, height_));
  }
  double aspect() const { return static_cast<double>(width_) / height_; }
  double eyeHeight(uint32_t region) const { return eye_.y - space_.regions()[region].floorAt(planOf(eye_)); }

  double horizonIn(const RootLens& lens, double eyeHeight) const {
    return horizonShift(eyeHeight, 2 * lens.tangent * lens.behind / aspect());
  }

  /// Level rays move evenly from where they are in the pinhole to where they are in full, and show nothing below the
  /// floor on the way.
  RootLens lowered(const WalkAhead& ahead, double deployed, double eyeHeight) const {
    RootLens lens = lensIn(ahead, deployed);
    const double between = glm::mix(horizonShift(0, 0), horizonIn(lensIn(ahead, 1), eyeHeight), deployed);
    lens.down = options_.lowered * std::max(between, horizonIn(lens, eyeHeight));
    return lens;
  }

  WaysView viewOfWays(uint32_t region, double deployed) const {
    return {options_.split,        options_.fovWayDegrees, deployed,           eye_, eyeHeight(region),
            options_.chosenPortal, options_.chosenShare,   options_.chosenOpen};
  }

  /// How much less of the ways is deployed near an opening of a room, or beside a tunnel. It grows with the square of
  /// small distances: from next to an opening, little makes a large part of the image.
  static double awayFrom(const WalkMouth& mouth, const glm::dvec2& eye, double reach) {
    return glm::smoothstep(0.0, reach, distanceTo(mouth, eye));
  }

  static double retractedIfLittle(double deployed) { return deployed > kMinDeployed ? deployed : 0; }

  double deployedIn(uint32_t region, const WalkAhead& ahead) const {
    if (options_.deployed) {
      return *options_.deployed;
    }
    const double reach = options_.deployWidths * (ahead.left + ahead.right);
    double deployed =
        glm::smoothstep(0.0, reach, ahead.distance) * glm::smoothstep(0.0, reach, ahead.behind.value_or(reach));
    for (const WalkExit& exit : space_.regions()[region].exits) {
      if (std::abs(glm::dot(exit.mouth.ahead(), ahead.direction)) < 0.7) {
        deployed *= awayFrom(exit.door, planOf(eye_), kBesideReach * (ahead.left + ahead.right) / 2);
      }
    }
    const double cosine = std::clamp(glm::dot(heading_, ahead.direction), -1.0, 1.0);
    return deployed * (1 - glm::smoothstep(kAlongDegrees, kAcrossDegrees, degreesFromRadians(std::acos(cosine))));
  }

  void inTunnel(WalkCamera& result, uint32_t region) const {
    const WalkAhead ahead = lookAhead(space_, region, planOf(eye_), heading_);
    if (!ahead.opening) {
      result.note = "the way ahead ends here";
      return;
    }
    result.crossing = ahead.opening->cell;
    result.deployed = retractedIfLittle(deployedIn(region, ahead));
    if (!(result.deployed > 0)) {
      return;
    }
    result.camera =
        GraphCamera(PinholeCamera(rootView(space_, eye_, directionIn(ahead, result.deployed),
                                           lowered(ahead, result.deployed, eyeHeight(region)), aspect(), space_.size()),
                                  width_, height_));
    result.ways = addCrossingWays(result.camera, space_, *ahead.opening, viewOfWays(region, result.deployed));
    for (const Plane& side : closedSides(space_.regions()[region], result.deployed)) {
      if (std::abs(glm::dot(side.normal, spaceOf(ahead.direction, 0))) < 0.5 && side.height(eye_) < 0) {
        limitWhereOneCan(result.camera, GraphCamera::kRoot, side);  // a tall image begins above the ceiling
      }
    }
  }

  /// The heading, turned into the tunnel as far as the ways are deployed.
  glm::dvec2 directionIn(const WalkAhead& ahead, double deployed) const {
    const double angle =
        std::atan2(planCross(heading_, ahead.direction), glm::dot(heading_, ahead.direction)) * deployed;
    return {heading_.x * std::cos(angle) - heading_.y * std::sin(angle),
            heading_.x * std::sin(angle) + heading_.y * std::cos(angle)};
  }

  /// Deployed in full, the tunnel fills the image where the user stands, and the opening its share of it.
  RootLens lensIn(const WalkAhead& ahead, double deployed) const {
    const double tangent = tangentOf(options_.fovHorizontalDegrees);
    const double half = (ahead.left + ahead.right) / 2;
    const double share = std::min(options_.crossingShare * 2 * half / ahead.opening->mouth.width(), kMaxOpening);
    const double hug = std::max(half / tangent, ahead.distance * share / (1 - share)) /
                       glm::mix(1.0, kWalkParallel, options_.parallel);
    // On the way there the share grows geometrically, however much smaller it is in the pinhole: by equal factors. As
    // much of the lens is deployed as that takes.
    const double inPinhole = tangent * ahead.distance;  // half of the width of the image, at the opening
    const double inFull = half * (hug + ahead.distance) / hug;
    const double now = std::pow(inPinhole, 1 - deployed) * std::pow(inFull, deployed);
    const double lensShare =
        std::clamp((now / tangent - ahead.distance) / (hug * (1 - now / half) + now / tangent), 0.0, 1.0);
    RootLens lens;
    lens.behind = lensShare * hug;
    lens.tangent = 1 / glm::mix(1 / tangent, hug / half, lensShare);
    lens.aside = deployed * (ahead.left / (2 * half) - 0.5);
    return lens;
  }

  void inRoom(WalkCamera& result, uint32_t region) const {
    const WalkRegion& room = space_.regions()[region];
    result.crossing = result.cell;
    result.deployed = options_.portalsInRooms;
    for (const WalkExit& exit : room.exits) {
      const double reach = options_.deployWidths * exit.door.width() / 2;
      result.deployed = std::min(result.deployed, options_.portalsInRooms * awayFrom(exit.door, planOf(eye_), reach));
    }
    result.deployed = retractedIfLittle(options_.deployed.value_or(result.deployed));
    if (room.exits.empty()) {
      result.note = "no way leads out of here";
    } else if (result.deployed > 0) {
      result.ways = addRoomWays(result.camera, space_, region, viewOfWays(region, result.deployed));
    }
  }

  const WalkSpace& space_;
  const WalkCameraOptions& options_;
  int width_;
  int height_;
  glm::dvec3 eye_;
  glm::dvec2 heading_{0};
};

}  // namespace

WalkCamera makeWalkCamera(const WalkSpace& space, const WalkPose& pose, const WalkCameraOptions& options, int width,
                          int height) {
  checkWalkPose(pose, options);
  return WalkCameraBuilder(space, pose, options, width, height).build();
}

WalkCamera makeWalkCamera(const WalkMap& map, const WalkPose& pose, const WalkCameraOptions& options, int width,
                          int height) {
  return makeWalkCamera(WalkSpace(map), pose, options, width, height);
}

PinholeCamera walkPinhole(const WalkSpace& space, const WalkPose& pose, const WalkCameraOptions& options, int width,
                          int height) {
  checkWalkPose(pose, options);
  const glm::dvec2 heading = glm::normalize(planOf(pose.heading)) * (options.backward ? -1.0 : 1.0);
  const RootLens lens{0, tangentOf(options.fovHorizontalDegrees), 0, options.lowered * horizonShift(0, 0)};
  return {rootView(space, pose.eye, heading, lens, static_cast<double>(width) / height, space.size()), width, height};
}

}  // namespace ocelli
