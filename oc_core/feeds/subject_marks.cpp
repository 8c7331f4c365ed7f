#include "oc_core/feeds/subject_marks.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "oc_core/feeds/subject_body.h"

namespace ocelli {
namespace {

constexpr int kMaxSpread = 8;      ///< cells from a subject's to those of its rim, or of an arm that swings out
constexpr int kStrangerReach = 8;  ///< columns on both sides in which a foot is looked for

/// Cells of the rim, and others beside those of a subject, are that subject's.
Image<uint16_t> spread(const Image<uint16_t>& wide, const Image<uint16_t>& who) {
  Image<uint16_t> all(wide.width(), wide.height());
  std::vector<glm::ivec2> rim;
  for (int y = 0; y < wide.height(); ++y) {
    for (int x = 0; x < wide.width(); ++x) {
      if (!who.empty() && wide(x, y) > 0 && who(x, y) > 0) {
        all(x, y) = who(x, y);
        rim.emplace_back(x, y);
      }
    }
  }
  std::vector<glm::ivec2> next;
  for (int step = 0; step < kMaxSpread && !rim.empty(); ++step) {
    next.clear();
    for (const glm::ivec2& cell : rim) {
      for (const glm::ivec2& way : {glm::ivec2(1, 0), glm::ivec2(-1, 0), glm::ivec2(0, 1), glm::ivec2(0, -1)}) {
        const glm::ivec2 beside = cell + way;
        if (wide.contains(beside.x, beside.y) && wide(beside.x, beside.y) > 0 && all(beside.x, beside.y) == 0) {
          all(beside.x, beside.y) = all(cell.x, cell.y);
          next.push_back(beside);
        }
      }
    }
    std::swap(rim, next);
  }
  return all;
}

/// How much of somebody is shown where the picture shows this frustum, and where it shows a later one.
struct Shares {
  double here = 1;
  double before = 1;

  static Shares at(const FeedGraph& graph, size_t frustum, const glm::dvec3& place) {
    return {shareEntered(graph, frustum, place), shareShown(graph, frustum, place)};
  }
};

/// The same of somebody who is not known, by the lowest cell near each column of a blob.
class StrangerShares {
 public:
  StrangerShares(const FeedGraph& graph, size_t frustum, const FeedBlobs& blobs, uint16_t label)
      : graph_(graph),
        frustum_(frustum),
        scale_(blobs.scale),
        lowest_(static_cast<size_t>(blobs.core.width()), -1),
        shares_(lowest_.size()) {
    const Image<uint16_t>& core = blobs.core;
    for (int y = 0; y < core.height(); ++y) {
      for (int x = 0; x < core.width(); ++x) {
        if (core(x, y) == label) {
          lowest_[static_cast<size_t>(x)] = y;
        }
      }
    }
  }

  Shares at(int column) {
    std::optional<Shares>& shares = shares_[static_cast<size_t>(column)];
    if (!shares) {
      shares = Shares();
      int row = -1;
      int at = column;
      const int last = std::min(static_cast<int>(lowest_.size()) - 1, column + kStrangerReach);
      for (int x = std::max(0, column - kStrangerReach); x <= last; ++x) {
        if (lowest_[static_cast<size_t>(x)] > row) {
          row = lowest_[static_cast<size_t>(x)];
          at = x;
        }
      }
      const glm::dvec2 foot = glm::dvec2(at + 0.5, row + 1) * scale_;
      if (const auto told = placeBelow(graph_.setup(), graph_.feedIndexOf(frustum_), foot, 0); told && row >= 0) {
        shares = Shares::at(graph_, frustum_, told->place);
      }
    }
    return *shares;
  }

 private:
  const FeedGraph& graph_;
  size_t frustum_;
  double scale_;
  std::vector<int> lowest_;
  std::vector<std::optional<Shares>> shares_;  ///< of columns that were asked for
};

}  // namespace

FeedMarks markSubjects(const FeedGraph& graph, size_t frustum, const FeedBlobs& blobs, const Image<uint16_t>& who,
                       std::span<const glm::dvec3> places) {
  FeedMarks all(blobs.wide.width(), blobs.wide.height(), blobs.scale);
  Image<FeedMark>& marks = all.cells();
  const Image<uint16_t> subjects = spread(blobs.wide, who);
  std::vector<Shares> shares;
  for (const glm::dvec3& place : places) {
    shares.push_back(Shares::at(graph, frustum, place));
  }
  std::vector<StrangerShares> strangers;
  for (size_t k = 0; k < blobs.blobs.size(); ++k) {
    strangers.emplace_back(graph, frustum, blobs, static_cast<uint16_t>(k + 1));
  }
  for (int y = 0; y < marks.height(); ++y) {
    for (int x = 0; x < marks.width(); ++x) {
      if (const uint16_t wide = blobs.wide(x, y); wide > 0) {
        const uint16_t subject = subjects(x, y);
        const Shares of = subject > 0 ? shares[subject - 1u] : strangers[wide - 1u].at(x);
        marks(x, y).erased = static_cast<uint8_t>(std::lround(255 * (1 - of.here)));
        marks(x, y).shown = blobs.core(x, y) > 0 ? static_cast<uint8_t>(std::lround(255 * of.before)) : uint8_t{0};
      }
    }
  }
  return all;
}

FeedMarks eraseSubjects(const FeedBlobs& blobs) {
  FeedMarks all(blobs.wide.width(), blobs.wide.height(), blobs.scale);
  for (int y = 0; y < blobs.wide.height(); ++y) {
    for (int x = 0; x < blobs.wide.width(); ++x) {
      all.cells()(x, y).erased = blobs.wide(x, y) > 0 ? 255 : 0;
    }
  }
  return all;
}

}  // namespace ocelli
