#include "oc_core/remote/region_wishes.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <optional>

namespace ocelli {
namespace {

/// Narrower ones have next to no samples left between two regions.
constexpr double kNarrowest = 0.25;
/// What is left between outer rectangles and beside borders, shares of the image: more than single floats round by.
constexpr double kGap = 1e-5;
constexpr double kMinWishZoom = 1.01;

struct Rectangle {
  glm::dvec2 lower;
  glm::dvec2 upper;
};

glm::dvec2 innerHalf(const RegionWish& wish) {
  return wish.content * wish.zoom / 2.0;
}

Rectangle outerOf(const RegionWish& wish, double transition) {
  const glm::dvec2 half = innerHalf(wish) * (1 + transition) + kGap;
  return {wish.center - half, wish.center + half};
}

bool overlap(const Rectangle& a, const Rectangle& b) {
  const glm::dvec2 common = glm::min(a.upper, b.upper) - glm::max(a.lower, b.lower);
  return common.x > 0 && common.y > 0;
}

bool overlap(const RegionWish& a, const RegionWish& b) {
  return overlap(outerOf(a, kNarrowest), outerOf(b, kNarrowest));
}

/// What half a region may measure around its centre, with its transition.
glm::dvec2 roomAround(const glm::dvec2& center) {
  return glm::max(glm::min(center, 1.0 - center) - kGap, 0.0);
}

/// Shows less, so that it lies in the image with the narrowest transition. Nothing where hardly anything is left.
std::optional<RegionWish> fitted(RegionWish wish) {
  wish.center = glm::clamp(wish.center, 0.0, 1.0);
  wish.zoom = std::min(wish.zoom, GpcRegion::kMaxZoom);
  const glm::dvec2 most = roomAround(wish.center) * 2.0 / ((1 + kNarrowest) * wish.zoom);
  wish.content = glm::min(wish.content, most);
  const glm::dvec2 extent = wish.content * wish.zoom;
  const bool isSome = wish.zoom >= kMinWishZoom && std::min(extent.x, extent.y) >= GpcRegion::kMinExtent;
  return isSome ? std::optional(wish) : std::nullopt;
}

/// One that shows what both show.
RegionWish joined(const RegionWish& a, const RegionWish& b) {
  const glm::dvec2 lower = glm::min(a.center - a.content / 2.0, b.center - b.content / 2.0);
  const glm::dvec2 upper = glm::max(a.center + a.content / 2.0, b.center + b.content / 2.0);
  RegionWish both{.center = (lower + upper) / 2.0,
                  .content = upper - lower,
                  .zoom = std::max(a.zoom, b.zoom),
                  .transition = std::max(a.transition, b.transition)};
  const glm::dvec2 fits = roomAround(both.center) * 2.0 / ((1 + kNarrowest) * both.content);
  both.zoom = std::min({both.zoom, fits.x, fits.y});
  return both;
}

std::vector<RegionWish> disjoint(const std::vector<RegionWish>& wishes) {
  std::vector<RegionWish> apart;
  for (const RegionWish& wish : wishes) {
    std::optional<RegionWish> next = fitted(wish);
    // What is joined may overlap others.
    for (size_t i = 0; next && i < apart.size();) {
      if (overlap(*next, apart[i])) {
        next = fitted(joined(*next, apart[i]));
        apart.erase(apart.begin() + static_cast<std::ptrdiff_t>(i));
        i = 0;
      } else {
        ++i;
      }
    }
    if (next) {
      apart.push_back(*next);
    }
  }
  return apart;
}

/// The widest transition up to the wished one with which `wish` lies in the image and overlaps none of the others.
double widestTransition(const RegionWish& wish, const std::vector<RegionWish>& all, size_t self,
                        const std::vector<double>& transitions) {
  const glm::dvec2 room = roomAround(wish.center) / innerHalf(wish) - 1.0;
  double works = kNarrowest;
  double wished = std::clamp(std::min(room.x, room.y), kNarrowest, std::max(wish.transition, kNarrowest));
  const auto isFree = [&](double transition) {
    for (size_t i = 0; i < all.size(); ++i) {
      if (i != self && overlap(outerOf(wish, transition), outerOf(all[i], transitions[i]))) {
        return false;
      }
    }
    return true;
  };
  if (isFree(wished)) {
    return wished;
  }
  for (int step = 0; step < 30; ++step) {
    const double middle = (works + wished) / 2;
    (isFree(middle) ? works : wished) = middle;
  }
  return works;
}

std::vector<GpcRegion> regionsFrom(const std::vector<RegionWish>& apart) {
  std::vector<double> transitions(apart.size(), kNarrowest);
  // Twice: those that come first leave half of the room to the others.
  for (const double share : {0.5, 1.0}) {
    for (size_t i = 0; i < apart.size(); ++i) {
      const double widest = widestTransition(apart[i], apart, i, transitions);
      transitions[i] += (widest - transitions[i]) * share;
    }
  }
  std::vector<GpcRegion> regions;
  for (size_t i = 0; i < apart.size(); ++i) {
    regions.push_back({.center = glm::vec2(apart[i].center),
                       .extent = glm::vec2(glm::min(innerHalf(apart[i]) * 2.0, 1.0)),
                       .zoom = static_cast<float>(apart[i].zoom),
                       .transitionWidth = static_cast<float>(transitions[i])});
  }
  return regions;
}

}  // namespace

std::vector<GpcRegion> regionsOf(std::vector<RegionWish> wishes) {
  return regionsFrom(disjoint(wishes));
}

std::vector<GpcRegion> regionsOf(std::vector<RegionWish> wishes, const RegionWish& yielding) {
  std::vector<RegionWish> apart = disjoint(wishes);
  for (double share = 1; share >= 0.5; share -= 1.0 / 32) {
    RegionWish smaller = yielding;
    smaller.content *= share;
    const std::optional<RegionWish> fits = fitted(smaller);
    if (!fits) {
      break;
    }
    if (std::ranges::none_of(apart, [&](const RegionWish& other) { return overlap(*fits, other); })) {
      apart.push_back(*fits);
      break;
    }
  }
  return regionsFrom(apart);
}

}  // namespace ocelli
