#include "oc_core/explore/explore_jumps.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

#include "oc_core/base/check.h"

namespace ocelli {
namespace {

/// Changes below the rounding of bytes are none.
constexpr double kLeastAllowed = 0.02;

double shareOfAllowed(const FrameChange& change) {
  return change.picture / std::max(change.allowed(), kLeastAllowed);
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

std::string csvOf(const std::vector<FrameChange>& changes) {
  std::string text = "frame,picture,pinhole,turn,jumps\n";
  for (const FrameChange& each : changes) {
    text += fmt::format("{},{:.4f},{:.4f},{:.4f},{}\n", each.frame, each.picture, each.pinhole, each.turn,
                        each.jumps() ? 1 : 0);
  }
  return text;
}

void JumpMeasure::add(const ExploreFrame& frame, const Image<Rgb8>& picture, double fovHorizontalDegrees,
                      double turnDegrees) {
  Last now;
  now.picture = picture;
  now.pinhole = renderer_.draw(MultiperspectiveCamera(GraphCamera(frame.pinhole)));
  WalkerView turned = frame.walker;
  turned.headingDegrees += turnDegrees;
  const Image<Rgb8> afterTurn = renderer_.draw(MultiperspectiveCamera(
      GraphCamera(walkerCamera(turned, scene_, fovHorizontalDegrees, frame.pinhole.width(), frame.pinhole.height()))));
  now.turn = imageChange(now.pinhole, afterTurn);
  if (last_ && last_->picture.width() == picture.width() && last_->picture.height() == picture.height()) {
    changes_.push_back({frame.number, imageChange(last_->picture, picture), imageChange(last_->pinhole, now.pinhole),
                        std::max(last_->turn, now.turn)});
  }
  last_ = std::move(now);
}

std::optional<FrameChange> JumpMeasure::worst() const {
  const auto found = std::max_element(changes_.begin(), changes_.end(), [](const auto& a, const auto& b) {
    return shareOfAllowed(a) < shareOfAllowed(b);
  });
  return found == changes_.end() ? std::nullopt : std::optional(*found);
}

}  // namespace ocelli
