#include "display_sim/viewer/transfer_editor.h"

#include <algorithm>
#include <glm/common.hpp>
#include <numeric>
#include <utility>

#include "oc_core/volume/transfer_file.h"

namespace ocelli {

TransferEditor::TransferEditor(VolumeAppearance appearance)
    : current_(std::make_shared<const VolumeAppearance>(std::move(appearance))), saved_(current_) {}

void TransferEditor::choose(std::optional<size_t> point) {
  chosen_ = point;
  endStep();
}

void TransferEditor::put(VolumeAppearance appearance, std::optional<Step> step) {
  if (!step || step != last_) {
    past_.push_back(current_);
    if (past_.size() > kMaxSteps) {
      past_.erase(past_.begin());
    }
  }
  last_ = step;
  future_.clear();
  current_ = std::make_shared<const VolumeAppearance>(std::move(appearance));
  keepChosen();
}

void TransferEditor::putPoints(std::vector<TransferPoint> points, std::optional<Step> step) {
  VolumeAppearance appearance = *current_;
  appearance.transfer = TransferFunction(std::move(points), appearance.transfer.opacityLength());
  put(std::move(appearance), step);
}

void TransferEditor::keepChosen() {
  if (chosen_ && *chosen_ >= points().size()) {
    chosen_.reset();
  }
}

void TransferEditor::movePoint(size_t point, double value, double opacity) {
  constexpr double kFar = TransferDescription::kMaxValue;
  std::vector<TransferPoint> all = points();
  const double least = point > 0 ? all[point - 1].value : -kFar;
  const double greatest = point + 1 < all.size() ? all[point + 1].value : kFar;
  all[point].value = std::clamp(value, least, greatest);
  all[point].opacity = std::clamp(opacity, 0.0, 1.0);
  putPoints(std::move(all), Step{Kind::kMove, point});
}

void TransferEditor::colorPoint(size_t point, const glm::dvec3& color) {
  std::vector<TransferPoint> all = points();
  all[point].color = glm::clamp(color, 0.0, 1.0);
  putPoints(std::move(all), Step{Kind::kColor, point});
}

bool TransferEditor::insertPoint(size_t index, const TransferPoint& point) {
  if (points().size() >= TransferDescription::kMaxPoints) {
    return false;
  }
  std::vector<TransferPoint> all = points();
  all.insert(all.begin() + static_cast<std::ptrdiff_t>(index), point);
  putPoints(std::move(all), std::nullopt);
  chosen_ = index;
  return true;
}

bool TransferEditor::addPoint(double value, double opacity) {
  const auto next = std::ranges::upper_bound(points(), value, {}, &TransferPoint::value);
  return insertPoint(static_cast<size_t>(next - points().begin()),
                     {value, current_->transfer.at(value).color, std::clamp(opacity, 0.0, 1.0)});
}

// Not by addPoint(), which would put it behind all points of its value: halfway up a step that lies between its ends.
bool TransferEditor::addBeside(size_t point) {
  const std::vector<TransferPoint>& all = points();
  const size_t first = point + 1 < all.size() || point == 0 ? point : point - 1;
  const TransferPoint& a = all[first];
  const TransferPoint& b = all[std::min(first + 1, all.size() - 1)];
  return insertPoint(first + 1, {std::midpoint(a.value, b.value), glm::mix(a.color, b.color, 0.5),
                                 std::midpoint(a.opacity, b.opacity)});
}

bool TransferEditor::removePoint(size_t point) {
  std::vector<TransferPoint> all = points();
  if (all.size() < 2) {
    return false;
  }
  all.erase(all.begin() + static_cast<std::ptrdiff_t>(point));
  const size_t last = all.size() - 1;
  putPoints(std::move(all), std::nullopt);
  chosen_ = std::min(point, last);
  return true;
}

void TransferEditor::setOpacityLength(double length) {
  using Limits = TransferDescription;
  VolumeAppearance appearance = *current_;
  appearance.transfer =
      TransferFunction(points(), std::clamp(length, Limits::kMinOpacityLength, Limits::kMaxOpacityLength));
  put(std::move(appearance), Step{Kind::kLength});
}

void TransferEditor::setShading(const VolumeShading& shading) {
  VolumeAppearance appearance = *current_;
  appearance.shading = shading;
  put(std::move(appearance), Step{Kind::kShading});
}

void TransferEditor::replace(VolumeAppearance appearance, bool isSaved) {
  put(std::move(appearance), std::nullopt);
  chosen_.reset();
  if (isSaved) {
    markSaved();
  }
}

bool TransferEditor::go(std::vector<Appearance>& from, std::vector<Appearance>& to) {
  endStep();
  if (from.empty()) {
    return false;
  }
  to.push_back(current_);
  current_ = from.back();
  from.pop_back();
  keepChosen();
  return true;
}

bool TransferEditor::warnsOfLoss() {
  if (isSaved() || warnedOf_ == current_) {
    return false;
  }
  warnedOf_ = current_;
  return true;
}

bool TransferEditor::undo() {
  return go(past_, future_);
}

bool TransferEditor::redo() {
  return go(future_, past_);
}

}  // namespace ocelli
