#include "oc_core/walkable/walk_box.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "oc_core/base/conventions.h"

namespace ocelli {
namespace {

constexpr double kFitsWell = 0.8;    // shared area, of the area of both
constexpr double kFitsBetter = 0.1;  // what a turned box must gain

struct Range {
  double low = 0;
  double high = 0;
};

/// Where at least half as many values fall into bins of that size as into the median bin.
Range fullRange(const std::vector<double>& values, double bin) {
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  const double begin = *low - bin / 2;
  const auto count = static_cast<size_t>((*high - begin) / bin) + 1;
  std::vector<int> counts(count, 0);
  for (const double value : values) {
    ++counts[std::min(count - 1, static_cast<size_t>((value - begin) / bin))];
  }
  std::vector<int> ordered = counts;
  std::nth_element(ordered.begin(), ordered.begin() + static_cast<long>(count / 2), ordered.end());
  const int least = (ordered[count / 2] + 1) / 2;
  size_t first = 0;
  size_t last = count - 1;
  while (counts[first] < least) {
    ++first;
  }
  while (counts[last] < least) {
    --last;
  }
  return {begin + static_cast<double>(first) * bin, begin + static_cast<double>(last + 1) * bin};
}

BoxFit fitAlong(const std::vector<glm::dvec2>& points, double cell, const glm::dvec2& axis) {
  const glm::dvec2 right(-axis.y, axis.x);
  // A turned grid has points at all distances: wider bins even that out.
  const bool isTurned = std::min(std::abs(axis.x), std::abs(axis.y)) > 1e-6;
  const double bin = isTurned ? 2 * cell : cell;
  std::vector<double> us;
  std::vector<double> vs;
  for (const glm::dvec2& p : points) {
    us.push_back(p.x * axis.x + p.y * axis.y);
    vs.push_back(p.x * right.x + p.y * right.y);
  }
  Range u = fullRange(us, bin);
  Range v = fullRange(vs, bin);
  for (int pass = 0; pass < 2; ++pass) {  // each within the other
    std::vector<double> inU;
    for (size_t i = 0; i < us.size(); ++i) {
      if (vs[i] > v.low && vs[i] < v.high) {
        inU.push_back(us[i]);
      }
    }
    u = inU.empty() ? u : fullRange(inU, bin);
    std::vector<double> inV;
    for (size_t i = 0; i < vs.size(); ++i) {
      if (us[i] > u.low && us[i] < u.high) {
        inV.push_back(vs[i]);
      }
    }
    v = inV.empty() ? v : fullRange(inV, bin);
  }
  size_t inside = 0;
  for (size_t i = 0; i < us.size(); ++i) {
    inside += us[i] > u.low && us[i] < u.high && vs[i] > v.low && vs[i] < v.high ? 1 : 0;
  }
  BoxFit fit;
  fit.box.axis = axis;
  fit.box.halfLength = (u.high - u.low) / 2;
  fit.box.halfWidth = (v.high - v.low) / 2;
  fit.box.center = (u.high + u.low) / 2 * axis + (v.high + v.low) / 2 * right;
  const double area = (u.high - u.low) * (v.high - v.low);
  const double both = static_cast<double>(inside) * cell * cell;
  fit.shared = both / (area + static_cast<double>(points.size()) * cell * cell - both);
  return fit;
}

glm::dvec2 directionAt(double degrees) {
  const double angle = radiansFromDegrees(degrees);
  return {std::cos(angle), std::sin(angle)};
}

}  // namespace

glm::dvec2 middleOf(const WalkField& field, const WalkSquare& square) {
  return {field.origin.x + (square.x + 0.5) * field.cellSize, field.origin.y + (square.z + 0.5) * field.cellSize};
}

BoxFit boxAround(const WalkField& field, const std::vector<uint32_t>& squares, const glm::dvec2& axis) {
  std::vector<glm::dvec2> points;
  for (const uint32_t i : squares) {
    points.push_back(middleOf(field, field.squares[i]));
  }
  // Which way a piece lies, a part of its squares tells.
  constexpr size_t kMaxTried = 4000;
  const size_t stride = points.size() / kMaxTried + 1;
  std::vector<glm::dvec2> some;
  for (size_t i = 0; i < points.size(); i += stride) {
    some.push_back(points[i]);
  }
  const bool isGiven = axis.x != 0 || axis.y != 0;
  BoxFit best = fitAlong(points, field.cellSize, isGiven ? axis : glm::dvec2(1, 0));
  if (best.shared < kFitsWell) {
    const double coarse = field.cellSize * std::sqrt(static_cast<double>(stride));
    const auto sharedAt = [&](double degrees) { return fitAlong(some, coarse, directionAt(degrees)).shared; };
    double degrees = 5;
    double most = 0;
    for (int candidate = 5; candidate < 90; candidate += 5) {
      const double shared = sharedAt(candidate);
      if (shared > most) {
        most = shared;
        degrees = candidate;
      }
    }
    const double around = degrees;
    for (const int off : {-3, -2, -1, 1, 2, 3}) {
      const double shared = sharedAt(around + off);
      if (shared > most) {
        most = shared;
        degrees = around + off;
      }
    }
    const BoxFit turned = fitAlong(points, field.cellSize, directionAt(degrees));
    if (turned.shared > best.shared + kFitsBetter) {
      best = turned;
      // A tunnel keeps to the side that it was given.
      if (isGiven && std::abs(best.box.axis.x * axis.x + best.box.axis.y * axis.y) < std::sqrt(0.5)) {
        std::swap(best.box.halfLength, best.box.halfWidth);
        best.box.axis = best.box.right();
      }
      if (isGiven && best.box.axis.x * axis.x + best.box.axis.y * axis.y < 0) {
        best.box.axis = -best.box.axis;
      }
    }
  }
  if (!isGiven && best.box.halfWidth > best.box.halfLength) {
    std::swap(best.box.halfLength, best.box.halfWidth);
    best.box.axis = best.box.right();
  }
  return best;
}

}  // namespace ocelli
