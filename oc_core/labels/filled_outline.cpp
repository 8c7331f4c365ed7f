#include "oc_core/labels/filled_outline.h"

#include <algorithm>
#include <map>
#include <utility>

namespace ocelli {
namespace {

struct OutlineEdge {
  glm::dvec2 lower;
  glm::dvec2 upper;
  int winding = 0;  ///< 1 where the outline goes up

  double at(double y) const {
    // Exact at both ends, so that edges meet.
    return y == lower.y   ? lower.x
           : y == upper.y ? upper.x
                          : lower.x + (upper.x - lower.x) * ((y - lower.y) / (upper.y - lower.y));
  }
};

struct OpenTrapezoid {
  uint32_t left;
  uint32_t right;
  double from;
};

class Filler {
 public:
  explicit Filler(const std::vector<std::vector<glm::dvec2>>& outlines) {
    for (const std::vector<glm::dvec2>& corners : outlines) {
      for (size_t i = 0; i < corners.size(); ++i) {
        const glm::dvec2& a = corners[i];
        const glm::dvec2& b = corners[(i + 1) % corners.size()];
        heights_.push_back(a.y);
        if (a.y != b.y) {
          edges_.push_back(a.y < b.y ? OutlineEdge{a, b, 1} : OutlineEdge{b, a, -1});
        }
      }
    }
    std::ranges::sort(heights_);
    const auto repeated = std::ranges::unique(heights_);
    heights_.erase(repeated.begin(), repeated.end());
  }

  FilledOutline fill() {
    std::vector<OpenTrapezoid> open;
    for (size_t i = 0; i + 1 < heights_.size(); ++i) {
      std::vector<OpenTrapezoid> now = trapezoids(heights_[i], heights_[i + 1]);
      for (OpenTrapezoid& trapezoid : now) {
        const auto same = std::ranges::find_if(open, [&](const OpenTrapezoid& before) {
          return before.left == trapezoid.left && before.right == trapezoid.right;
        });
        if (same != open.end()) {
          trapezoid.from = same->from;
          open.erase(same);
        }
      }
      close(open, heights_[i]);
      open = std::move(now);
    }
    if (!heights_.empty()) {
      close(open, heights_.back());
    }
    return std::move(filled_);
  }

 private:
  /// From left to right, between two neighbouring heights.
  std::vector<OpenTrapezoid> trapezoids(double from, double to) const {
    std::vector<uint32_t> across;
    for (uint32_t i = 0; i < edges_.size(); ++i) {
      if (edges_[i].lower.y <= from && edges_[i].upper.y >= to) {
        across.push_back(i);
      }
    }
    const double middle = (from + to) / 2;
    std::ranges::sort(across, {}, [&](uint32_t edge) { return edges_[edge].at(middle); });
    std::vector<OpenTrapezoid> found;
    int winding = 0;
    uint32_t left = 0;
    for (const uint32_t edge : across) {
      const int before = std::exchange(winding, winding + edges_[edge].winding);
      if (before == 0) {
        left = edge;
      } else if (winding == 0) {
        found.push_back({left, edge, from});
      }
    }
    return found;
  }

  void close(const std::vector<OpenTrapezoid>& open, double to) {
    for (const OpenTrapezoid& trapezoid : open) {
      const OutlineEdge& left = edges_[trapezoid.left];
      const OutlineEdge& right = edges_[trapezoid.right];
      const uint32_t a = corner({left.at(trapezoid.from), trapezoid.from});
      const uint32_t b = corner({right.at(trapezoid.from), trapezoid.from});
      const uint32_t c = corner({right.at(to), to});
      const uint32_t d = corner({left.at(to), to});
      if (a != b) {
        filled_.triangles.emplace_back(a, b, c);
      }
      if (c != d) {
        filled_.triangles.emplace_back(a, c, d);
      }
    }
  }

  uint32_t corner(const glm::dvec2& place) {
    const auto [slot, isNew] = known_.try_emplace({place.x, place.y}, static_cast<uint32_t>(filled_.corners.size()));
    if (isNew) {
      filled_.corners.push_back(place);
    }
    return slot->second;
  }

  std::vector<OutlineEdge> edges_;
  std::vector<double> heights_;
  std::map<std::pair<double, double>, uint32_t> known_;
  FilledOutline filled_;
};

}  // namespace

FilledOutline fillOutlines(const std::vector<std::vector<glm::dvec2>>& outlines) {
  return Filler(outlines).fill();
}

}  // namespace ocelli
