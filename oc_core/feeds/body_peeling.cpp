#include "oc_core/feeds/body_peeling.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "oc_core/feeds/subject_body.h"

namespace ocelli {
namespace {

constexpr int kMaxBodies = 12;          ///< of one blob
constexpr int kCutRows = 2;             ///< mask rows from the lower border in which feet are cut
constexpr int kHiddenReach = 3;         ///< mask rows below a pixel in which a body hides what is under it
constexpr int kHeadReach = 10;          ///< mask columns on both sides in which a head is looked for
constexpr double kFootShare = 1.0 / 8;  ///< of a body's height, from below: its feet
constexpr double kMinShown = 0.35;      ///< of a body's box, but what others hide: less is no body
constexpr double kMinBeside = 0.25;     ///< of the cells of who is known in a body's box: their limbs are less
constexpr int kMinCells = 24;           ///< of a mask
constexpr double kNearer = 0.94;        ///< from one distance that is tried to the next
constexpr int kNearerSteps = 18;
constexpr double kRimMetres = 0.08;  ///< around a body that is taken away

enum class Cell : uint8_t { kBackground, kOpen, kTaken, kKnown };

/// Cells of a mask: from the first to before the last.
struct CellBox {
  glm::ivec2 lower{0};
  glm::ivec2 upper{0};
};

class BlobPeeler {
 public:
  BlobPeeler(const FeedSetup& setup, size_t feed, const FeedBlobs& blobs, const Image<uint16_t>& known, uint16_t label)
      : setup_(setup),
        feed_(setup.feeds[feed]),
        feedIndex_(feed),
        scale_(blobs.scale),
        cells_(blobs.core.width(), blobs.core.height()),
        extent_(cellsOf(blobs.blobs[label - 1u].lower, blobs.blobs[label - 1u].upper)) {
    for (int y = extent_.lower.y; y < extent_.upper.y; ++y) {
      for (int x = extent_.lower.x; x < extent_.upper.x; ++x) {
        if (blobs.core(x, y) == label) {
          cells_(x, y) = !known.empty() && known(x, y) > 0 ? Cell::kKnown : Cell::kOpen;
        }
      }
    }
  }

  void peel(std::vector<PeeledBody>& bodies) {
    for (int n = 0; n < kMaxBodies; ++n) {
      const auto lowest = lowestCell();
      if (!lowest) {
        return;
      }
      const auto body = bodyAt(*lowest);
      if (body && isShown(*body)) {
        bodies.push_back(*body);
        takeAway(*body);
      }
      takeAround(*lowest);
    }
  }

 private:
  CellBox cellsOf(const glm::dvec2& lower, const glm::dvec2& upper) const {
    const glm::ivec2 size(cells_.width(), cells_.height());
    return {glm::clamp(glm::ivec2(glm::floor(lower / scale_)), glm::ivec2(0), size),
            glm::clamp(glm::ivec2(glm::ceil(upper / scale_)), glm::ivec2(0), size)};
  }

  int count(const CellBox& box, Cell kind) const {
    int sum = 0;
    for (int y = box.lower.y; y < box.upper.y; ++y) {
      for (int x = box.lower.x; x < box.upper.x; ++x) {
        sum += cells_(x, y) == kind ? 1 : 0;
      }
    }
    return sum;
  }

  /// Another one than whose cells are open.
  static bool isSomebody(Cell cell) { return cell == Cell::kTaken || cell == Cell::kKnown; }

  static int area(const CellBox& box) { return (box.upper.x - box.lower.x) * (box.upper.y - box.lower.y); }

  /// The middle of the first run of the lowest row.
  std::optional<glm::ivec2> lowestCell() const {
    for (int y = extent_.upper.y - 1; y >= extent_.lower.y; --y) {
      for (int x = extent_.lower.x; x < extent_.upper.x; ++x) {
        if (cells_(x, y) == Cell::kOpen) {
          int end = x;
          while (end + 1 < extent_.upper.x && cells_(end + 1, y) == Cell::kOpen) {
            ++end;
          }
          return glm::ivec2((x + end) / 2, y);
        }
      }
    }
    return std::nullopt;
  }

  std::optional<PeeledBody> bodyAt(const glm::ivec2& lowest) const {
    if (lowest.y >= cells_.height() - kCutRows) {
      return bodyOutOfTheImage(lowest);
    }
    for (int k = 1; k <= kHiddenReach; ++k) {
      if (cells_.contains(lowest.x, lowest.y + k) && isSomebody(cells_(lowest.x, lowest.y + k))) {
        return bodyByHead(lowest);
      }
    }
    return bodyByFeet(lowest);
  }

  std::optional<PeeledBody> bodyByFeet(const glm::ivec2& lowest) const {
    const auto near = placeBelow(setup_, feedIndex_, glm::dvec2(lowest.x + 0.5, lowest.y + 1) * scale_, 0);
    const auto box = near ? bodyBox(feed_, near->place) : std::nullopt;
    if (!box) {
      return std::nullopt;
    }
    const int reach = std::max(1, static_cast<int>((box->upper.x - box->lower.x) / scale_ / 2));
    const int rows = std::max(1, static_cast<int>((box->upper.y - box->lower.y) / scale_ * kFootShare));
    double sum = 0;
    double cells = 0;
    for (int y = std::max(extent_.lower.y, lowest.y - rows); y <= lowest.y; ++y) {
      for (int x = std::max(extent_.lower.x, lowest.x - reach); x < std::min(extent_.upper.x, lowest.x + reach + 1);
           ++x) {
        if (cells_(x, y) == Cell::kOpen) {
          sum += x + 0.5;
          ++cells;
        }
      }
    }
    const auto told = placeBelow(setup_, feedIndex_, glm::dvec2(sum / std::max(cells, 1.0), lowest.y + 1) * scale_, 0);
    return told ? std::optional(PeeledBody{told->place, told->distance, false}) : std::nullopt;
  }

  /// Of those whose heads are around a column, the highest in the image.
  std::optional<PeeledBody> bodyByHead(const glm::ivec2& lowest) const {
    if (!isOverHeads(setup_, feedIndex_)) {
      return std::nullopt;
    }
    for (int y = extent_.lower.y; y <= lowest.y; ++y) {
      for (int x = std::max(extent_.lower.x, lowest.x - kHeadReach);
           x < std::min(extent_.upper.x, lowest.x + kHeadReach + 1); ++x) {
        if (cells_(x, y) == Cell::kOpen) {
          const auto told = placeBelow(setup_, feedIndex_, glm::dvec2(x + 0.5, y) * scale_, kSubjectHeight);
          return told ? std::optional(PeeledBody{told->place, told->distance, true}) : std::nullopt;
        }
      }
    }
    return std::nullopt;
  }

  /// Whose feet are below the image is nearer than the floor there; how much, the size of what is seen tells.
  std::optional<PeeledBody> bodyOutOfTheImage(const glm::ivec2& lowest) const {
    const auto farthest = placeBelow(setup_, feedIndex_, glm::dvec2(lowest.x + 0.5, lowest.y + 1) * scale_, 0);
    if (!farthest || !isOverHeads(setup_, feedIndex_)) {
      return std::nullopt;
    }
    const glm::dvec3 under(feed_.pose.eye.x, setup_.floorHeight, feed_.pose.eye.z);
    std::optional<PeeledBody> best;
    double most = 0;
    double share = 1;
    int top = -1;
    for (int n = 0; n < kNearerSteps; ++n, share *= kNearer) {
      const glm::dvec3 place = under + (farthest->place - under) * share;
      const auto box = bodyBox(feed_, place);
      if (!box) {
        continue;
      }
      const CellBox cells = cellsOf(box->lower, box->upper);
      top = top < 0 ? cells.lower.y : top;
      const CellBox around{{cells.lower.x, top}, {cells.upper.x, extent_.upper.y}};
      const int inside = count(cells, Cell::kOpen);
      const double likeness = 2.0 * inside / std::max(1, area(cells) + count(around, Cell::kOpen));
      if (likeness > most) {
        most = likeness;
        best = PeeledBody{place, box->distance, true};
      }
    }
    return best;
  }

  bool isShown(const PeeledBody& body) const {
    const auto box = bodyBox(feed_, body.place);
    if (!box) {
      return false;
    }
    const CellBox cells = cellsOf(box->lower, box->upper);
    const int open = count(cells, Cell::kOpen);
    const int known = count(cells, Cell::kKnown);
    return open >= kMinCells && open >= kMinShown * (area(cells) - count(cells, Cell::kTaken) - known) &&
           open >= kMinBeside * known;
  }

  void take(const CellBox& box) {
    for (int y = box.lower.y; y < box.upper.y; ++y) {
      for (int x = box.lower.x; x < box.upper.x; ++x) {
        cells_(x, y) = cells_(x, y) == Cell::kOpen ? Cell::kTaken : cells_(x, y);
      }
    }
  }

  void takeAway(const PeeledBody& body) {
    if (const auto box = bodyBox(feed_, body.place)) {
      const double rim = kRimMetres * feed_.lens.focal.x / std::max(body.distance, 0.1);
      take(cellsOf(box->lower - rim, box->upper + rim));
    }
  }

  /// So that each round leaves less.
  void takeAround(const glm::ivec2& cell) {
    take({glm::max(cell - 2, extent_.lower), glm::min(cell + 3, extent_.upper)});
  }

  const FeedSetup& setup_;
  const Feed& feed_;
  size_t feedIndex_;
  double scale_;  ///< of a cell, feed pixels
  Image<Cell> cells_;
  CellBox extent_;
};

}  // namespace

std::vector<PeeledBody> peelBodies(const FeedSetup& setup, size_t feed, const FeedBlobs& blobs,
                                   const Image<uint16_t>& known) {
  std::vector<PeeledBody> bodies;
  for (size_t k = 0; k < blobs.blobs.size(); ++k) {
    BlobPeeler(setup, feed, blobs, known, static_cast<uint16_t>(k + 1)).peel(bodies);
  }
  return bodies;
}

}  // namespace ocelli
