#include "oc_core/soft_shadows/light_grid.h"

#include "oc_core/base/check.h"

namespace ocelli {

LightGrid::LightGrid(const LightFrame& frame, int side) : side_(side) {
  OC_CHECK(side >= 8 && side <= kMaxSide && side % 8 == 0, "a grid has 8, 16, 24 or 32 rows");
  const auto n = static_cast<float>(side);
  scale_ = glm::vec2(n) / (2.0f * frame.half());
  offset_ = {n / 2, n / 2 - 0.5f};
  constexpr double kGoldenShare = 0.6180339887498949;
  for (int row = 0; row < side; ++row) {
    const double turns = kGoldenShare * row + 0.5 / side;
    shift_.push_back(static_cast<float>(turns - std::floor(turns)));
  }
  onLight_.assign(static_cast<size_t>(side) * static_cast<size_t>(side), 1);
  for (int column = 0; column < side; ++column) {
    for (int row = 0; row < side; ++row) {
      const glm::vec2 p = glm::vec2(point(column, row)) / frame.half();
      onLight_[index(column, row)] = !frame.light().isDisc || glm::dot(p, p) <= 1 ? 1 : 0;
      count_ += onLight_[index(column, row)];
    }
  }
}

glm::vec3 LightGrid::point(int column, int row) const {
  return {(static_cast<float>(column) + shift(row) - offset_.x) / scale_.x,
          (static_cast<float>(row) - offset_.y) / scale_.y, 0};
}

}  // namespace ocelli
