#include "oc_core/feeds/subject_cells.h"

#include <array>
#include <cmath>

namespace ocelli {
namespace {

constexpr float kNobodyShare = 0.02f;     ///< how likely a cell shows somebody who is not expected
constexpr float kMinShare = 1e-3f;        ///< of a cell: less is none
constexpr float kSureShare = 0.6f;        ///< of a cell that tells a colour
constexpr float kNeighbourWeight = 0.5f;  ///< of each of eight neighbours that show the same subject
constexpr int kAgreeRounds = 2;
constexpr float kFeetHeight = 0.1f;    ///< shares of a body's height
constexpr float kTrunkHeight = 0.45f;  ///< from there on bodies are about the same on both sides
constexpr float kHeadCells = 0.9f;
constexpr int kMinRowCells = 2;  ///< a row with fewer is no end of a body

/// Who a cell may show.
struct CellChoice {
  static constexpr size_t kMost = 3;

  std::array<uint16_t, kMost> body{};  ///< the index of an expected body, plus 1
  std::array<float, kMost> score{};
  uint8_t count = 0;

  void add(uint16_t which, float value) {
    size_t at = count;
    if (count < kMost) {
      ++count;
    } else {
      at = 0;
      for (size_t i = 1; i < kMost; ++i) {
        at = score[i] < score[at] ? i : at;
      }
      if (score[at] >= value) {
        return;
      }
    }
    body[at] = which;
    score[at] = value;
  }
};

class CellTeller {
 public:
  CellTeller(const FeedBlobs& blobs, std::span<const ExpectedBody> bodies)
      : blobs_(blobs),
        bodies_(bodies),
        choices_(blobs.core.width(), blobs.core.height()),
        free_(blobs.core.width(), blobs.core.height(), 1.0f),
        label_(blobs.core.width(), blobs.core.height()) {
    result_.sights.resize(bodies.size());
  }

  SubjectCells tell() {
    for (size_t i = 0; i < bodies_.size(); ++i) {
      expect(i);
    }
    choose();
    for (int round = 0; round < kAgreeRounds; ++round) {
      agree();
    }
    for (size_t i = 0; i < bodies_.size(); ++i) {
      look(i);
    }
    result_.who = Image<uint16_t>(label_.width(), label_.height());
    for (size_t i = 0; i < label_.size(); ++i) {
      result_.who[i] =
          label_[i] == 0 ? SubjectCells::kNobody : static_cast<uint16_t>(bodies_[label_[i] - 1u].subject + 1);
    }
    return std::move(result_);
  }

 private:
  template <class Visit>
  void visitCells(const BodyView& view, const Visit& visit) const {
    for (int y = view.firstRow(); y < view.lastRow(); ++y) {
      const BodyView::Row& row = view.row(y);
      const glm::ivec2 columns = view.columns(y);
      for (int x = columns.x; x < columns.y; ++x) {
        const float beside = BodyView::beside(row, x);
        if (const float share = row.outline.shareAt(beside); share > kMinShare) {
          visit(x, y, row, beside, share);
        }
      }
    }
  }

  void expect(size_t which) {
    const ExpectedBody& body = bodies_[which];
    BodySight& sight = result_.sights[which];
    double trunk = 0;
    visitCells(body.view, [&](int x, int y, const BodyView::Row& row, float beside, float share) {
      const size_t i = free_.index(x, y);
      const float open = share * free_[i];
      sight.inImage += share;
      sight.open += open;
      if (row.height < kFeetHeight) {
        sight.feetInImage += share;
        sight.feetOpen += open;
      } else if (row.height > kHeadCells) {
        sight.headInImage += share;
        sight.headOpen += open;
      }
      if (row.height >= kTrunkHeight) {
        trunk += open;
        sight.besideExpected += open * beside;
      }
      if (blobs_.core[i] > 0 && open > kMinShare) {
        const float likeness =
            body.colors != nullptr && !blobs_.colors.empty()
                ? body.colors->likeness(SubjectColors::partAt(row.height), SubjectColors::binOf(blobs_.colors[i]))
                : 0;
        choices_[i].add(static_cast<uint16_t>(which + 1), std::log(open) + likeness);
      }
      free_[i] *= 1 - share;
    });
    sight.besideExpected /= std::max(trunk, 1e-6);
  }

  uint16_t bestOf(const CellChoice& choice, const std::array<float, CellChoice::kMost>& more, float moreNobody) const {
    uint16_t best = 0;
    float most = std::log(kNobodyShare) + moreNobody;
    for (size_t k = 0; k < choice.count; ++k) {
      if (choice.score[k] + more[k] > most) {
        most = choice.score[k] + more[k];
        best = choice.body[k];
      }
    }
    return best;
  }

  void choose() {
    for (size_t i = 0; i < choices_.size(); ++i) {
      if (choices_[i].count > 0) {
        label_[i] = bestOf(choices_[i], {}, 0);
      }
    }
  }

  /// Cells that may show several go with their neighbours.
  void agree() {
    const Image<uint16_t> before = label_;
    for (int y = 1; y + 1 < label_.height(); ++y) {
      for (int x = 1; x + 1 < label_.width(); ++x) {
        const CellChoice& choice = choices_(x, y);
        if (choice.count == 0) {
          continue;
        }
        std::array<float, CellChoice::kMost> more{};
        float nobody = 0;
        for (int dy = -1; dy <= 1; ++dy) {
          for (int dx = -1; dx <= 1; ++dx) {
            const size_t i = before.index(x + dx, y + dy);
            if (blobs_.core[i] == 0 || (dx == 0 && dy == 0)) {
              continue;
            }
            nobody += before[i] == 0 ? kNeighbourWeight : 0;
            for (size_t k = 0; k < choice.count; ++k) {
              more[k] += before[i] == choice.body[k] ? kNeighbourWeight : 0;
            }
          }
        }
        label_(x, y) = bestOf(choice, more, nobody);
      }
    }
  }

  void look(size_t which) {
    BodySight& sight = result_.sights[which];
    const auto label = static_cast<uint16_t>(which + 1);
    int row = -1;
    int inRow = 0;
    visitCells(bodies_[which].view, [&](int x, int y, const BodyView::Row& at, float beside, float share) {
      if (label_(x, y) != label) {
        return;
      }
      if (share >= kSureShare && choices_(x, y).count == 1 && !blobs_.colors.empty()) {
        result_.sure.push_back({static_cast<uint16_t>(which), static_cast<uint8_t>(SubjectColors::partAt(at.height)),
                                SubjectColors::binOf(blobs_.colors(x, y))});
      }
      inRow = y == row ? inRow + 1 : 1;
      row = y;
      if (inRow == kMinRowCells) {
        sight.highest = sight.highest < 0 ? y : sight.highest;
        sight.lowest = y;
      }
      sight.seen += 1;
      sight.seenAlone += choices_(x, y).count == 1 ? 1 : 0;
      if (at.height >= kTrunkHeight) {
        sight.trunkSeen += 1;
        sight.besideSeen += beside;
      }
    });
    sight.besideSeen /= std::max(sight.trunkSeen, 1.0);
  }

  const FeedBlobs& blobs_;
  std::span<const ExpectedBody> bodies_;
  Image<CellChoice> choices_;
  Image<float> free_;      ///< how likely nobody so far fills a cell
  Image<uint16_t> label_;  ///< the index of an expected body, plus 1
  SubjectCells result_;
};

}  // namespace

SubjectCells tellCells(const FeedBlobs& blobs, std::span<const ExpectedBody> bodies) {
  return CellTeller(blobs, bodies).tell();
}

}  // namespace ocelli
