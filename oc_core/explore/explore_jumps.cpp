#include "oc_core/explore/explore_jumps.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <glm/geometric.hpp>

#include "oc_core/base/check.h"

namespace ocelli {
namespace {

/// Changes below the rounding of bytes are none.
constexpr double kMinAllowed = 0.02;
constexpr int kTurnHeadings = 8;
constexpr double kSamePlaceMetres = 0.5;

double shareOfAllowed(const FrameChange& change) {
  return change.picture / std::max(change.allowed(), kMinAllowed);
}

}  // namespace

double imageChange(const Image<Rgb8>& one, const Image<Rgb8>& other) {
  OC_CHECK(one.width() == other.width() && one.height() == other.height(), "images of one size");
  uint64_t sum = 0;
  for (size_t i = 0; i < one.size(); ++i) {
    for (int k = 0; k < 3; ++k) {
      sum += static_cast<uint64_t>(std::abs(int{one[i][k]} - int{other[i][k]}));
    }
  }
  return one.empty() ? 0 : static_cast<double>(sum) / (3.0 * static_cast<double>(one.size()));
}

Image<Rgb8> WorstFrame::difference() const {
  Image<Rgb8> difference(after.width(), after.height());
  for (size_t i = 0; i < after.size(); ++i) {
    for (int k = 0; k < 3; ++k) {
      difference[i][k] = static_cast<uint8_t>(std::abs(int{after[i][k]} - int{before[i][k]}));
    }
  }
  return difference;
}

std::string csvOf(const std::vector<FrameChange>& changes) {
  std::string text = "frame,image,pinhole,turn,jumps\n";
  for (const FrameChange& each : changes) {
    text += fmt::format("{},{:.4f},{:.4f},{:.4f},{}\n", each.frame, each.picture, each.pinhole, each.turn,
                        each.jumps() ? 1 : 0);
  }
  return text;
}

double JumpMeasure::turnAt(const ExploreFrame& frame, double fovHorizontalDegrees, double turnDegrees) {
  if (place_ && glm::distance(place_->eye, frame.walker.eye) <= kSamePlaceMetres * scene_.metre()) {
    return place_->turn;
  }
  place_ = Place{frame.walker.eye, 0};
  const auto pictureAt = [&](double heading) {
    WalkerView view = frame.walker;
    view.headingDegrees = heading;
    return renderer_.draw(MultiperspectiveCamera(
        GraphCamera(walkerCamera(view, scene_, fovHorizontalDegrees, frame.pinhole.width(), frame.pinhole.height()))));
  };
  for (int i = 0; i < kTurnHeadings; ++i) {
    const double heading = frame.walker.headingDegrees + 360.0 * i / kTurnHeadings;
    place_->turn = std::max(place_->turn, imageChange(pictureAt(heading), pictureAt(heading + turnDegrees)));
  }
  return place_->turn;
}

void JumpMeasure::add(const ExploreFrame& frame, const Image<Rgb8>& picture, double fovHorizontalDegrees,
                      double turnDegrees) {
  Last now;
  now.picture = picture;
  now.pinhole = renderer_.draw(MultiperspectiveCamera(GraphCamera(frame.pinhole)));
  now.turn = turnAt(frame, fovHorizontalDegrees, turnDegrees);
  if (last_ && last_->picture.width() == picture.width() && last_->picture.height() == picture.height()) {
    changes_.push_back({frame.number, imageChange(last_->picture, picture), imageChange(last_->pinhole, now.pinhole),
                        std::max(last_->turn, now.turn)});
    if (!worst_ || shareOfAllowed(changes_.back()) > shareOfAllowed(worst_->change)) {
      worst_ = WorstFrame{changes_.back(), last_->picture, picture};
    }
  }
  last_ = std::move(now);
}

}  // namespace ocelli
