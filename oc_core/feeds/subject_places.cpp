#include "oc_core/feeds/subject_places.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <optional>

#include "oc_core/feeds/body_peeling.h"
#include "oc_core/feeds/subject_body.h"

namespace ocelli {
namespace {

constexpr double kSameSubject = 0.8;   ///< metres between places that two feeds tell of one subject
constexpr double kFootError = 0.008;   ///< of a place told by feet, metres for each square metre of distance
constexpr double kHeadError = 0.15;    ///< of one told by a head, metres for each metre of distance
constexpr double kSameShare = 0.06;    ///< of the distance: where a blob's feet and a subject may be apart
constexpr double kMinCrossing = 0.5;   ///< sine of the least angle between lines of sight that cross well
constexpr double kCoreHalf = 0.32;     ///< of a body's width: half of what it surely fills
constexpr double kMaxBeside = 0.3;     ///< of a body's width: what is farther beside it is somebody else
constexpr double kBehind = 1.5;        ///< times as far off is who stands behind somebody, where nothing tells it
constexpr double kHeadCoreHalf = 0.2;  ///< of a body's width: half of what a head surely fills
constexpr int kFootReach = 8;          ///< mask columns on both sides in which a foot is looked for
constexpr int kSeenRows = 10;          ///< of three points each that are looked up of a body
constexpr double kMinCovered = 0.3;    ///< share of a body's box that a blob covers which shows it
constexpr double kMinPiece = 0.6;      ///< share of a blob's box that a body's covers of which it is a piece
constexpr double kMinSameBox = 0.5;    ///< of both boxes' union: what they share where they are one body

std::optional<PlaceTold> floorPlace(const FeedSetup& setup, size_t feedIndex, const glm::dvec2& foot) {
  return placeBelow(setup, feedIndex, foot, 0);
}

/// Metres, about: along the line of sight.
double errorOf(const PlaceTold& told) {
  return told.isByHead ? kHeadError * told.distance : kFootError * told.distance * told.distance;
}

glm::dvec2 planOf(const glm::dvec3& p) {
  return {p.x, p.z};
}

/// Where two lines of sight cross, seen from above; nothing where they hardly do, or behind a camera.
std::optional<glm::dvec2> crossingOf(const glm::dvec2& a, const glm::dvec2& alongA, const glm::dvec2& b,
                                     const glm::dvec2& alongB) {
  const double sine = alongA.x * alongB.y - alongA.y * alongB.x;
  if (std::abs(sine) < kMinCrossing) {
    return std::nullopt;
  }
  const glm::dvec2 way = b - a;
  const double s = (way.x * alongB.y - way.y * alongB.x) / sine;
  const double t = (way.x * alongA.y - way.y * alongA.x) / sine;
  return s > 0 && t > 0 ? std::optional(a + alongA * s) : std::nullopt;
}

/// One place of those that feeds tell of one subject.
glm::dvec3 placeOf(const FeedSetup& setup, const std::vector<PlaceTold>& told) {
  for (size_t i = 0; i < told.size(); ++i) {
    for (size_t k = i + 1; k < told.size(); ++k) {
      const glm::dvec2 a = planOf(setup.feeds[told[i].feed].pose.eye);
      const glm::dvec2 b = planOf(setup.feeds[told[k].feed].pose.eye);
      const auto crossing =
          crossingOf(a, glm::normalize(planOf(told[i].place) - a), b, glm::normalize(planOf(told[k].place) - b));
      if (crossing) {
        return {crossing->x, setup.floorHeight, crossing->y};
      }
    }
  }
  glm::dvec3 sum(0);
  double weights = 0;
  for (const PlaceTold& each : told) {
    const double weight = 1 / std::pow(std::max(errorOf(each), 0.01), 2);
    sum += each.place * weight;
    weights += weight;
  }
  return sum / weights;
}

double overlapOf(const FeedBox& box, const SubjectBlob& blob) {
  const glm::dvec2 overlap = glm::max(glm::min(box.upper, blob.upper) - glm::max(box.lower, blob.lower), glm::dvec2(0));
  return overlap.x * overlap.y;
}

double areaOf(const SubjectBlob& blob) {
  return (blob.upper.x - blob.lower.x) * (blob.upper.y - blob.lower.y);
}

/// Whether a blob may show a body: it covers some of it, or is a piece of it.
bool mayShow(const SubjectBlob& blob, const FeedBox& box) {
  const double overlap = overlapOf(box, blob);
  return overlap >= kMinCovered * box.area() || overlap >= kMinPiece * areaOf(blob);
}

/// Whether a blob is one body and nothing else.
bool isThatBody(const SubjectBlob& blob, const FeedBox& box) {
  const double overlap = overlapOf(box, blob);
  return overlap >= kMinSameBox * (box.area() + areaOf(blob) - overlap);
}

/// Where a subject stands as a feed sees it.
const glm::dvec3& placeFor(size_t feed, const SeenSubject& subject) {
  for (const FeedTold& told : subject.told) {
    if (told.feed == feed) {
      return told.place;
    }
  }
  return subject.place;
}

double beyond(const Plane& plane, const glm::dvec3& place, double fade) {
  const double height = plane.height(place);
  return fade > 0 ? std::clamp(0.5 + height / (2 * fade), 0.0, 1.0) : (height >= 0 ? 1.0 : 0.0);
}

struct SeenBody {
  FeedBox box;
  double share = 1;
  double shareBehind = 1;  ///< of somebody who stands behind it
};

/// The highest and the lowest row of a blob in each column of a mask.
struct BlobRows {
  static constexpr int kNone = -1;

  BlobRows(const Image<uint16_t>& labels, uint16_t label)
      : highest(static_cast<size_t>(labels.width()), kNone), lowest(highest) {
    for (int y = 0; y < labels.height(); ++y) {
      for (int x = 0; x < labels.width(); ++x) {
        if (labels(x, y) == label) {
          const auto column = static_cast<size_t>(x);
          highest[column] = highest[column] == kNone ? y : highest[column];
          lowest[column] = y;
        }
      }
    }
  }

  std::vector<int> highest;
  std::vector<int> lowest;
};

/// What the pixels of one blob show, by the bodies that it may be.
class BlobBodies {
 public:
  BlobBodies(const FeedGraph& graph, size_t frustum, const SubjectBlob& blob, const BlobRows& rows,
             const std::vector<SeenSubject>& subjects)
      : graph_(graph), frustum_(frustum), rows_(rows) {
    const Feed& feed = graph.feedOf(frustum);
    const auto told = floorPlace(graph.setup(), graph.feedIndexOf(frustum), blob.foot);
    for (const SeenSubject& subject : subjects) {
      const auto box = bodyBox(feed, placeFor(graph.feedIndexOf(frustum), subject));
      if (!box || !mayShow(blob, *box)) {
        continue;
      }
      const SeenBody body = bodyAt(*box, subject.place);
      if (told && !blob.isCutBelow && isThatBody(blob, *box) &&
          glm::length(told->place - subject.place) < kSameSubject + kSameShare * told->distance) {
        bodies_ = {body};
        return;
      }
      bodies_.push_back(body);
    }
    std::sort(bodies_.begin(), bodies_.end(),
              [](const SeenBody& a, const SeenBody& b) { return a.box.distance < b.box.distance; });
  }

  /// The share of the nearest body at a pixel of the mask. What stands well beside all of them is a subject of its own,
  /// which no feed told, as a nearer one has the lowest pixel of the blob; what rises over them stands behind them.
  double shareAt(int column, int row) const {
    const glm::dvec2 q = (glm::dvec2(column, row) + 0.5) * static_cast<double>(FeedBlobs::kMaskScale);
    double least = std::numeric_limits<double>::infinity();
    double share = 1;
    double shareBehind = 1;
    bool isAbove = false;
    for (const SeenBody& body : bodies_) {
      const double width = std::max(body.box.upper.x - body.box.lower.x, 1.0);
      const double fromMiddle = std::abs(q.x - (body.box.lower.x + body.box.upper.x) / 2) / width;
      const double beside = std::max(0.0, fromMiddle - (q.y < body.box.shoulders ? kHeadCoreHalf : kCoreHalf));
      const double above = std::max(0.0, body.box.lower.y - q.y) / width;
      if (std::max(beside, above) < least) {
        least = std::max(beside, above);
        isAbove = above > beside;
        share = body.share;
        shareBehind = body.shareBehind;
      }
    }
    if (least <= kMaxBeside) {
      return share;
    }
    return isAbove ? shareByHead(column).value_or(shareBehind) : shareByFoot(column).value_or(share);
  }

 private:
  SeenBody bodyAt(const FeedBox& box, const glm::dvec3& place) const {
    const glm::dvec3& eye = graph_.feedOf(frustum_).pose.eye;
    const glm::dvec3 behind = eye + (place - eye) * kBehind;
    return {box, shareShown(graph_, frustum_, place),
            shareShown(graph_, frustum_, {behind.x, graph_.setup().floorHeight, behind.z})};
  }

  double shareAtFloor(const glm::dvec3& place) const { return shareShown(graph_, frustum_, place); }

  /// By the lowest pixel around a column.
  std::optional<double> shareByFoot(int column) const {
    int row = BlobRows::kNone;
    const int at = extremeAround(
        column, rows_.lowest, [](int a, int b) { return a > b; }, row);
    if (row == BlobRows::kNone) {
      return std::nullopt;
    }
    const glm::dvec2 foot = glm::dvec2(at + 0.5, row + 1) * static_cast<double>(FeedBlobs::kMaskScale);
    const auto told = floorPlace(graph_.setup(), graph_.feedIndexOf(frustum_), foot);
    return told ? std::optional(shareAtFloor(told->place)) : std::nullopt;
  }

  /// By the highest pixel around a column, of somebody whose feet others hide.
  std::optional<double> shareByHead(int column) const {
    int row = BlobRows::kNone;
    const int at = extremeAround(
        column, rows_.highest, [](int a, int b) { return a < b; }, row);
    if (row == BlobRows::kNone || !isOverHeads(graph_.setup(), graph_.feedIndexOf(frustum_))) {
      return std::nullopt;
    }
    const glm::dvec2 head = glm::dvec2(at + 0.5, row) * static_cast<double>(FeedBlobs::kMaskScale);
    const auto told = placeBelow(graph_.setup(), graph_.feedIndexOf(frustum_), head, kSubjectHeight);
    return told ? std::optional(shareAtFloor(told->place)) : std::nullopt;
  }

  /// The column near another one whose row comes first, and that row; kNone where there is none.
  template <typename Before>
  static int extremeAround(int column, const std::vector<int>& rows, Before isBefore, int& row) {
    int at = column;
    const int last = std::min(static_cast<int>(rows.size()) - 1, column + kFootReach);
    for (int x = std::max(0, column - kFootReach); x <= last; ++x) {
      const int here = rows[static_cast<size_t>(x)];
      if (here != BlobRows::kNone && (row == BlobRows::kNone || isBefore(here, row))) {
        row = here;
        at = x;
      }
    }
    return at;
  }

  const FeedGraph& graph_;
  size_t frustum_;
  const BlobRows& rows_;
  std::vector<SeenBody> bodies_;  ///< the nearest first
};

}  // namespace

std::vector<SeenSubject> locateSubjects(const FeedSetup& setup, const std::vector<FeedBlobs>& blobs) {
  std::vector<PlaceTold> told;
  for (size_t feed = 0; feed < blobs.size(); ++feed) {
    for (const PeeledBody& body : peelBodies(setup, feed, blobs[feed])) {
      told.push_back({feed, body.place, body.distance, body.isByHead});
    }
  }
  std::sort(told.begin(), told.end(), [](const PlaceTold& a, const PlaceTold& b) { return errorOf(a) < errorOf(b); });
  std::vector<SeenSubject> subjects;
  std::vector<bool> isTaken(told.size(), false);
  for (size_t i = 0; i < told.size(); ++i) {
    if (isTaken[i]) {
      continue;
    }
    std::vector<PlaceTold> same{told[i]};
    std::vector<FeedTold> feeds{{told[i].feed, told[i].place}};
    for (size_t k = i + 1; k < told.size(); ++k) {
      const bool isOtherFeed =
          std::none_of(feeds.begin(), feeds.end(), [&](const FeedTold& each) { return each.feed == told[k].feed; });
      const double reach = kSameSubject + errorOf(told[k]);
      if (!isTaken[k] && isOtherFeed && glm::length(told[k].place - told[i].place) < reach) {
        isTaken[k] = true;
        same.push_back(told[k]);
        feeds.push_back({told[k].feed, told[k].place});
      }
    }
    subjects.push_back({placeOf(setup, same), feeds, errorOf(same.front())});
  }
  return subjects;
}

std::optional<double> shareSeen(const FeedGraph& graph, const std::vector<FeedBlobs>& blobs, const glm::dvec3& place) {
  std::optional<double> least;
  for (size_t i = 0; i < graph.frusta(); ++i) {
    const Image<uint16_t>& mask = blobs[graph.feedIndexOf(i)].wide;
    if (mask.empty() || shareShown(graph, i, place) <= 0) {
      continue;
    }
    const Feed& feed = graph.feedOf(i);
    const glm::dvec3 right = feed.pose.right();
    const glm::dvec3 side = glm::normalize(glm::dvec3(right.x, 0, right.z)) * (kSubjectRadius / 2);
    int seen = 0;
    int covered = 0;
    for (int row = 0; row < kSeenRows; ++row) {
      for (int column = -1; column <= 1; ++column) {
        const double height = kSubjectHeight * (row + 0.5) / kSeenRows;
        const auto q = feedPixelOf(feed, place + side * static_cast<double>(column) + glm::dvec3(0, height, 0));
        const glm::ivec2 cell =
            q ? glm::ivec2(glm::floor(*q / static_cast<double>(FeedBlobs::kMaskScale))) : glm::ivec2(-1);
        if (mask.contains(cell.x, cell.y)) {
          ++seen;
          covered += mask(cell.x, cell.y) > 0 ? 1 : 0;
        }
      }
    }
    if (2 * seen >= 3 * kSeenRows) {
      least = std::min(least.value_or(1), static_cast<double>(covered) / seen);
    }
  }
  return least;
}

double shareShown(const FeedGraph& graph, size_t frustum, const glm::dvec3& place) {
  const auto& frusta = graph.camera().frusta();
  const double fade = graph.setup().fadeMetres;
  double share = 1;
  for (int i = static_cast<int>(frustum); i != GraphCamera::kRoot; i = frusta[static_cast<size_t>(i)].parent) {
    share = std::min(share, beyond(frusta[static_cast<size_t>(i)].plane, place, fade));
  }
  for (const int child : frusta[frustum].children) {
    share = std::min(share, 1 - beyond(frusta[static_cast<size_t>(child)].plane, place, fade));
  }
  return share;
}

Image<FeedMark> markSubjects(const FeedGraph& graph, size_t frustum, const FeedBlobs& blobs,
                             const std::vector<SeenSubject>& subjects) {
  Image<FeedMark> marks(blobs.wide.width(), blobs.wide.height());
  std::vector<BlobBodies> bodies;
  std::vector<BlobRows> rows;
  rows.reserve(blobs.blobs.size());
  for (size_t k = 0; k < blobs.blobs.size(); ++k) {
    rows.emplace_back(blobs.core, static_cast<uint16_t>(k + 1));
    bodies.emplace_back(graph, frustum, blobs.blobs[k], rows.back(), subjects);
  }
  for (int y = 0; y < marks.height(); ++y) {
    for (int x = 0; x < marks.width(); ++x) {
      if (const uint16_t wide = blobs.wide(x, y); wide > 0) {
        const auto share = static_cast<uint8_t>(std::lround(255 * bodies[wide - 1u].shareAt(x, y)));
        marks(x, y) = {static_cast<uint8_t>(255 - share), blobs.core(x, y) > 0 ? share : uint8_t{0}};
      }
    }
  }
  return marks;
}

}  // namespace ocelli
