#include "oc_core/feeds/body_view.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "oc_core/feeds/feed_graph.h"

namespace ocelli {
namespace {

/// Above and below a body, shares of its height in which it may be all the same, as its place is not known exactly.
constexpr float kAbove = 0.1f;
constexpr float kBelow = 0.12f;
constexpr float kUnsure = 0.35f;  ///< how likely it is there, next to the body

struct KnownOutline {
  float height;
  BodyOutline outline;
};

// Somebody who walks is as wide at the feet as a step is long, and between the legs there may be nothing.
constexpr std::array<KnownOutline, 7> kOutlines{{{0.0f, {0.6f, 0.10f, 0.42f}},
                                                 {0.2f, {0.75f, 0.10f, 0.36f}},
                                                 {0.45f, {0.9f, 0.14f, 0.36f}},
                                                 {0.55f, {0.97f, 0.17f, 0.40f}},
                                                 {0.8f, {0.97f, 0.19f, 0.36f}},
                                                 {0.87f, {0.95f, 0.09f, 0.22f}},
                                                 {1.0f, {0.9f, 0.07f, 0.17f}}}};

constexpr int kLevels = 9;  ///< heights at which a body is projected

struct Level {
  glm::dvec2 middle;  ///< cells
  double metresPerCell;
  double height;
};

}  // namespace

BodyOutline bodyOutline(float height) {
  const float within = std::clamp(height, 0.0f, 1.0f);
  const auto* above = std::find_if(kOutlines.begin() + 1, kOutlines.end() - 1,
                                   [&](const KnownOutline& known) { return known.height >= within; });
  const BodyOutline& a = (above - 1)->outline;
  const BodyOutline& b = above->outline;
  const float f = (within - (above - 1)->height) / (above->height - (above - 1)->height);
  BodyOutline outline{a.share + (b.share - a.share) * f, a.sure + (b.sure - a.sure) * f,
                      a.none + (b.none - a.none) * f};
  if (height < 0) {
    outline.share *= kUnsure * std::max(0.0f, 1 + height / kBelow);
  } else if (height > 1) {
    outline.share *= kUnsure * std::max(0.0f, 1 - (height - 1) / kAbove);
  }
  return outline;
}

std::optional<BodyView> BodyView::of(const Feed& feed, const glm::dvec3& place, double height, const glm::ivec2& mask,
                                     int scale) {
  const glm::dvec3 side = feed.pose.right() * (kBodyReach / 2.0);
  std::vector<Level> levels;
  for (int k = 0; k < kLevels; ++k) {
    const double share = -kBelow + (1.0 + kBelow + kAbove) * k / (kLevels - 1);
    const glm::dvec3 middle = place + glm::dvec3(0, share * height, 0);
    const auto left = feedPixelOf(feed, middle - side);
    const auto rightmost = feedPixelOf(feed, middle + side);
    if (left && rightmost) {
      const double cells = glm::length(*rightmost - *left) / scale;
      levels.push_back({(*left + *rightmost) / (2.0 * scale), kBodyReach / std::max(cells, 1e-3), share});
    }
  }
  if (levels.size() < 2) {
    return std::nullopt;
  }
  BodyView view;
  view.distance_ = glm::length(place - feed.pose.eye);
  view.width_ = mask.x;
  // Rows downwards are heights downwards.
  view.first_ = std::clamp(static_cast<int>(std::ceil(levels.back().middle.y - 0.5)), 0, mask.y);
  size_t level = levels.size() - 1;
  for (int y = view.first_; y < mask.y; ++y) {
    const double middle = y + 0.5;
    while (level > 0 && levels[level - 1].middle.y < middle) {
      --level;
    }
    if (level == 0) {
      break;
    }
    const Level& above = levels[level];
    const Level& below = levels[level - 1];
    const double rows = below.middle.y - above.middle.y;
    const double f = rows > 0 ? (middle - above.middle.y) / rows : 0;
    const auto rowHeight = static_cast<float>(above.height + (below.height - above.height) * f);
    view.rows_.push_back({static_cast<float>(above.middle.x + (below.middle.x - above.middle.x) * f),
                          static_cast<float>(above.metresPerCell + (below.metresPerCell - above.metresPerCell) * f),
                          rowHeight, bodyOutline(rowHeight)});
  }
  if (view.rows_.empty()) {
    return std::nullopt;
  }
  view.hasHead_ = view.rows_.front().height >= 1;
  view.hasFeet_ = view.rows_.back().height <= 0;
  return view;
}

glm::ivec2 BodyView::columns(int y) const {
  const Row& at = row(y);
  const float half = kBodyReach / at.metresPerCell;
  return {std::clamp(static_cast<int>(std::floor(at.axis - half)), 0, width_),
          std::clamp(static_cast<int>(std::ceil(at.axis + half)), 0, width_)};
}

}  // namespace ocelli
