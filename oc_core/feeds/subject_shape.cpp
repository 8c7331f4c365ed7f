#include "oc_core/feeds/subject_shape.h"

#include <algorithm>
#include <cmath>

#include "oc_core/feeds/body_view.h"
#include "oc_core/feeds/subject_body.h"

namespace ocelli {
namespace {

constexpr float kLowest = -0.12f;  ///< shares of the body's height
constexpr float kHighest = 1.1f;
constexpr double kHalfSeconds = 1.5;  ///< after so long half is forgotten
constexpr float kUsualFrames = 2;     ///< so many count for what anybody looks like
constexpr float kLeast = 0.03f;       ///< of the usual share: arms and legs move

}  // namespace

size_t SubjectShape::indexOf(float height, float beside) {
  const int row = std::clamp(static_cast<int>((height - kLowest) / (kHighest - kLowest) * kRows), 0, kRows - 1);
  const int column = std::clamp(static_cast<int>((beside / kBodyReach + 1) / 2 * kColumns), 0, kColumns - 1);
  return static_cast<size_t>(row) * kColumns + static_cast<size_t>(column);
}

void SubjectShape::add(float height, float beside, bool isFilled, float side) {
  constexpr float kPointHeight = (kHighest - kLowest) * static_cast<float>(kSubjectHeight) / kRows;
  constexpr float kPointWidth = 2 * kBodyReach / kColumns;
  const float weight = std::min(1.0f, side * side / (kPointHeight * kPointWidth));
  Point& point = points_[indexOf(height, beside)];
  point.filled += isFilled ? weight : 0;
  point.all += weight;
}

void SubjectShape::add(const SubjectShape& other) {
  for (size_t i = 0; i < points_.size(); ++i) {
    points_[i].filled += other.points_[i].filled;
    points_[i].all += other.points_[i].all;
  }
}

void SubjectShape::forget(double seconds) {
  const auto kept = static_cast<float>(std::exp2(-seconds / kHalfSeconds));
  for (Point& point : points_) {
    point.filled *= kept;
    point.all *= kept;
  }
}

float SubjectShape::shareAt(float height, float beside, float usual) const {
  const Point& point = points_[indexOf(height, beside)];
  return std::max(kLeast * usual, (point.filled + kUsualFrames * usual) / (point.all + kUsualFrames));
}

}  // namespace ocelli
