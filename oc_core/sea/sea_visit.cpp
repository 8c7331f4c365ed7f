#include "oc_core/sea/sea_visit.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

#include "oc_core/base/conventions.h"
#include "oc_core/sea/sea_summary.h"

namespace ocelli {
namespace {

constexpr double kFirstFov = radiansFromDegrees(60);
constexpr double kMinFov = radiansFromDegrees(15);
constexpr double kMaxFov = radiansFromDegrees(100);
constexpr double kMaxPitch = radiansFromDegrees(85);
constexpr double kZoomPerStep = 1.1;
constexpr double kReach = 3;  ///< spacings from the nearest image

}  // namespace

SeaVisit::SeaVisit(const SeaFile& sea, std::function<void()> woken)
    : sea_(sea),
      decoder_(sea.settings(), sea.proxy()),
      positions_(sea.positions()),
      spacing_(medianSpacing(positions_)),
      fovVertical_(kFirstFov),
      cache_(sea, std::move(woken)) {
  for (uint32_t i = 0; i < sea.count(); ++i) {
    poses_.push_back(sea.pose(i));
  }
  const glm::dvec3 ahead = poses_[0].worldFromCamera * glm::dvec3(0, 0, -1);
  yaw_ = std::atan2(-ahead.x, -ahead.z);
  pitch_ = std::clamp(std::asin(std::clamp(ahead.y, -1.0, 1.0)), -kMaxPitch, kMaxPitch);
  goToImage(0);
}

void SeaVisit::goTo(const glm::dvec3& place) {
  place_ = place;
  neighbors_ = nearestNeighbors(positions_, place_);
  const glm::dvec3& nearest = positions_[neighbors_.front().image];
  const double distance = glm::distance(place_, nearest);
  const double reach = kReach * spacing_;
  if (distance > reach) {
    place_ = nearest + (place_ - nearest) * (reach / distance);
    neighbors_ = nearestNeighbors(positions_, place_);
  }
  std::vector<uint32_t> wanted;
  for (const SeaNeighbor& neighbor : neighbors_) {
    wanted.push_back(neighbor.image);
  }
  cache_.want(wanted);
  isComplete_ = false;
}

void SeaVisit::walk(double ahead, double right) {
  const glm::dvec3 forward(-std::sin(yaw_), 0, -std::cos(yaw_));
  const glm::dvec3 side(-forward.z, 0, forward.x);
  goTo(place_ + forward * ahead + side * right);
}

void SeaVisit::turn(double left, double up) {
  yaw_ = std::remainder(yaw_ + left, 2 * kPi);
  pitch_ = std::clamp(pitch_ + up, -kMaxPitch, kMaxPitch);
  isComplete_ = false;
}

void SeaVisit::zoom(double steps) {
  fovVertical_ = std::clamp(fovVertical_ * std::pow(kZoomPerStep, -steps), kMinFov, kMaxFov);
  isComplete_ = false;
}

SeaCamera SeaVisit::camera(int width, int height) const {
  const double focal = 0.5 * height / std::tan(0.5 * fovVertical_);
  const glm::dquat turn = glm::angleAxis(yaw_, glm::dvec3(0, 1, 0)) * glm::angleAxis(pitch_, glm::dvec3(1, 0, 0));
  return {{SeaProjectionKind::kPinhole, width, height, glm::dvec2(focal), glm::dvec2(width, height) * 0.5},
          {place_, turn}};
}

Image<Rgb8> SeaVisit::picture(int width, int height, bool waits) {
  cache_.rethrow();
  std::vector<ShownImage> images;
  for (const SeaNeighbor& neighbor : neighbors_) {
    std::shared_ptr<const WarpReference> image = waits ? cache_.get(neighbor.image) : cache_.find(neighbor.image);
    if (image != nullptr) {
      images.push_back({neighbor.image, std::max(neighbor.weight, 1e-6), std::move(image)});
    }
  }
  isComplete_ = images.size() == neighbors_.size();
  if (!images.empty()) {
    shown_ = std::move(images);  // otherwise those of the step before: they are not far
  }
  std::vector<BlendedImage> blended;
  blended.reserve(shown_.size());
  for (const ShownImage& shown : shown_) {
    blended.push_back({shown.reference.get(), poses_[shown.image], shown.weight});
  }
  return blendedView(decoder_, blended, camera(width, height));
}

}  // namespace ocelli
