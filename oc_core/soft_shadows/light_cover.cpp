#include "oc_core/soft_shadows/light_cover.h"

#include <algorithm>
#include <cmath>

namespace ocelli {

LightCover::LightCover(const LightGrid& grid) : grid_(grid) {
  offLight_.fill(kOffLight);
  for (int column = 0; column < grid.side(); ++column) {
    for (int row = 0; row < grid.side(); ++row) {
      offLight_[index(column, row)] = grid.isOnLight(column, row) ? INT16_MIN : kOffLight;
    }
  }
}

void LightCover::clear() {
  change_.fill(0);
  changeOfRow_.fill(0);
}

void LightCover::add(const glm::vec2& a, const glm::vec2& b, int weight) {
  const bool upwards = a.y <= b.y;
  const glm::vec2& low = upwards ? a : b;
  const glm::vec2& high = upwards ? b : a;
  const auto rows = static_cast<float>(grid_.side());
  const int first = static_cast<int>(std::ceil(std::clamp(low.y, 0.0f, rows)));
  const int end = static_cast<int>(std::ceil(std::clamp(high.y, 0.0f, rows)));
  // Surfaces lie to the left of an edge: it takes them from what is right of it where it runs upwards.
  const auto toTheRight = static_cast<int16_t>(upwards ? -weight : weight);
  const float slope = first < end ? (high.x - low.x) / (high.y - low.y) : 0;
  const bool crossesSide = (a.x < 0) != (b.x < 0);
  if (!crossesSide && a.x < 0) {
    return;
  }
  const bool lowIsLeft = low.x < 0;
  int crossing = end;  // the first row that the edge passes behind where it crosses the light's left side
  for (int row = first; row < end; ++row) {
    const float x = low.x + (static_cast<float>(row) - low.y) * slope;
    // The same question decides for both, so that they agree whatever is rounded.
    const bool isLeft = crossesSide && x < 0;
    if (crossesSide && isLeft != lowIsLeft) {
      crossing = std::min(crossing, row);
    }
    if (isLeft) {
      continue;
    }
    const float after = x - grid_.shift(row);
    const int column = after < 0 ? 0 : after < rows ? static_cast<int>(after) + 1 : grid_.side();
    if (column < grid_.side()) {
      change_[index(column, row)] = static_cast<int16_t>(change_[index(column, row)] + toTheRight);
    }
  }
  if (crossesSide) {
    const int above = a.x < 0 ? weight : -weight;  // of an edge that runs to the right surfaces lie above
    changeOfRow_[static_cast<size_t>(crossing)] =
        static_cast<int16_t>(changeOfRow_[static_cast<size_t>(crossing)] + above);
  }
}

int LightCover::alikeAround(int column, int row, bool isAmongLeast) const {
  const auto isAsked = [&](int x, int y) { return isLeast(x, y) == isAmongLeast && hidden_[index(x, y)] != kOffLight; };
  if (!isAsked(column, row)) {
    return -1;
  }
  const int side = grid_.side();
  return (column > 0 && isAsked(column - 1, row)) + (column + 1 < side && isAsked(column + 1, row)) +
         (row > 0 && isAsked(column, row - 1)) + (row + 1 < side && isAsked(column, row + 1));
}

LightCover::Least LightCover::least() {
  const int side = grid_.side();
  const auto n = static_cast<size_t>(side);
  std::array<int16_t, kSide> running{};
  int16_t base = 0;
  for (size_t row = 0; row < n; ++row) {
    base = static_cast<int16_t>(base + changeOfRow_[row]);
    running[row] = base;
  }
  std::array<int16_t, kSide> fewest;
  fewest.fill(kOffLight);
  for (size_t column = 0; column < n; ++column) {
    const int16_t* change = &change_[column * kSide];
    const int16_t* off = &offLight_[column * kSide];
    int16_t* hidden = &hidden_[column * kSide];
    for (size_t row = 0; row < n; ++row) {
      running[row] = static_cast<int16_t>(running[row] + change[row]);
      hidden[row] = std::max(running[row], off[row]);
      fewest[row] = std::min(fewest[row], hidden[row]);
    }
  }
  least_ = *std::min_element(fewest.begin(), fewest.begin() + side);
  Least result;
  std::array<int16_t, kSide> counts{};
  std::array<int16_t, kSide> pairs{};
  for (size_t column = 0; column < n; ++column) {
    const int16_t* hidden = &hidden_[column * kSide];
    const int16_t* next = column + 1 < n ? hidden + kSide : hidden;
    for (size_t row = 0; row < n; ++row) {
      const bool own = hidden[row] == least_;
      const bool other = next[row] == least_;
      counts[row] = static_cast<int16_t>(counts[row] + own);
      pairs[row] = static_cast<int16_t>(
          pairs[row] + static_cast<int16_t>((own != other) & (hidden[row] != kOffLight) & (next[row] != kOffLight)));
    }
    for (size_t row = 0; row + 1 < n; ++row) {
      const bool own = hidden[row] == least_;
      const bool other = hidden[row + 1] == least_;
      pairs[row] = static_cast<int16_t>(pairs[row] + static_cast<int16_t>((own != other) & (hidden[row] != kOffLight) &
                                                                          (hidden[row + 1] != kOffLight)));
    }
  }
  for (size_t row = 0; row < n; ++row) {
    result.count += counts[row];
    result.neighbours += pairs[row];
  }
  // A sample whose neighbours are of its kind lies in the middle of them: a ray to it passes no edge closely.
  const int samples = side * side;
  const auto choose = [&](bool isAmongLeast, bool fromEnd, int& chosenColumn, int& chosenRow) {
    int most = -1;
    for (int i = 0; i < samples && most < 4; ++i) {
      const int sample = fromEnd ? samples - 1 - i : i;
      if (const int around = alikeAround(sample / side, sample % side, isAmongLeast); around > most) {
        most = around;
        chosenColumn = sample / side;
        chosenRow = sample % side;
      }
    }
  };
  choose(true, false, result.column, result.row);
  choose(true, true, result.otherColumn, result.otherRow);
  result.hasHidden = result.count < grid_.count();
  if (result.hasHidden) {
    choose(false, false, result.hiddenColumn, result.hiddenRow);
  }
  return result;
}

}  // namespace ocelli
