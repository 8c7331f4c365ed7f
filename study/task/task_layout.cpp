#include "study/task/task_layout.h"

#include <cmath>

namespace ocelli {

PixelRect wholeScreen(const TrialScreen& screen) {
  return {0, 0, static_cast<double>(screen.width), static_cast<double>(screen.height)};
}

PixelRect stageOf(const TrialScreen& screen) {
  const double top = promptHeight(screen);
  return {0, top, static_cast<double>(screen.width), screen.height - top};
}

std::vector<PixelRect> gridOf(const PixelRect& area, int rows, int columns, double gap) {
  const double space = std::round(gap * area.height);
  const double width = std::floor((area.width - (columns - 1) * space) / columns);
  const double height = std::floor((area.height - (rows - 1) * space) / rows);
  std::vector<PixelRect> places;
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      places.push_back({area.left + column * (width + space), area.top + row * (height + space), width, height});
    }
  }
  return places;
}

std::vector<PixelRect> buttonsIn(const PixelRect& area, int count) {
  constexpr double kSpace = 0.4;  // of a button
  const double side = std::floor(std::min(area.width / (count + (count + 1) * kSpace), area.height / 5));
  const double space = std::floor(kSpace * side);
  const double left = area.left + std::floor((area.width - count * side - (count - 1) * space) / 2);
  const double top = area.top + std::floor((area.height - side) / 2);
  std::vector<PixelRect> places;
  for (int i = 0; i < count; ++i) {
    places.push_back({left + i * (side + space), top, side, side});
  }
  return places;
}

glm::ivec2 sizeOf(const PixelRect& place) {
  return {static_cast<int>(place.width), static_cast<int>(place.height)};
}

}  // namespace ocelli
