#include "oc_core/feeds/subject_places.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <optional>

namespace ocelli {
namespace {

constexpr double kSubjectHeight = 1.75;  ///< metres, as its body is thought where only a part is seen
constexpr double kSubjectRadius = 0.3;
constexpr double kMaxTold = 60;        ///< metres: floor farther off says nothing of a place
constexpr double kSameSubject = 0.8;   ///< metres between places that two feeds tell of one subject
constexpr double kSameShare = 0.06;    ///< and the same as a share of the distance
constexpr double kMinCrossing = 0.5;   ///< sine of the least angle between lines of sight that cross well
constexpr double kCoreHalf = 0.32;     ///< of a body's width: half of what it surely fills
constexpr double kMaxBeside = 0.3;     ///< of a body's width: what is farther beside it is somebody else
constexpr double kBehind = 1.5;        ///< times as far off is who stands behind somebody, where no feed tells it
constexpr double kCutHalfWidth = 0.2;  ///< of the height that is seen of somebody whose feet are not: half of the width
constexpr int kCutReach = 4;           ///< mask rows from the lower border that are still cut
constexpr int kFootReach = 8;          ///< mask columns on both sides in which a foot is looked for
constexpr double kMinCovered = 0.3;    ///< share of a body's box that a blob covers which shows it
constexpr double kMinPiece = 0.6;      ///< share of a blob's box that a body's covers of which it is a piece
constexpr double kMinSameBox = 0.5;    ///< of both boxes' union: what they share where they are one body

struct PlaceTold {
  size_t feed = 0;
  glm::dvec3 place{0};
  double distance = 0;
};

std::optional<PlaceTold> floorPlace(const FeedSetup& setup, size_t feedIndex, const glm::dvec2& foot) {
  const Feed& feed = setup.feeds[feedIndex];
  const auto ray = feedRayOf(feed, foot);
  if (!ray || !(ray->y < 0)) {
    return std::nullopt;
  }
  const double along = (setup.floorHeight - feed.pose.eye.y) / ray->y;
  const glm::dvec3 place = feed.pose.eye + *ray * along;
  const double distance = glm::length(place - feed.pose.eye);
  if (!(along > 0) || distance > kMaxTold) {
    return std::nullopt;
  }
  return PlaceTold{feedIndex, place, distance};
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
  // The error of a place on the floor grows with the square of the distance.
  glm::dvec3 sum(0);
  double weights = 0;
  for (const PlaceTold& each : told) {
    const double weight = 1 / std::pow(std::max(each.distance, 0.1), 4);
    sum += each.place * weight;
    weights += weight;
  }
  return sum / weights;
}

struct FeedBox {
  glm::dvec2 lower{std::numeric_limits<double>::infinity()};
  glm::dvec2 upper{-std::numeric_limits<double>::infinity()};
  double distance = 0;

  double area() const { return std::max(0.0, upper.x - lower.x) * std::max(0.0, upper.y - lower.y); }
};

/// The box of a body at a place, as a feed sees it, cut to its image; nothing where it does not.
std::optional<FeedBox> bodyBox(const Feed& feed, const glm::dvec3& place) {
  const glm::dvec3 right = feed.pose.right();
  const glm::dvec3 side = glm::normalize(glm::dvec3(right.x, 0, right.z)) * kSubjectRadius;
  FeedBox box;
  for (const double height : {0.0, kSubjectHeight / 2, kSubjectHeight}) {
    for (const double sign : {-1.0, 1.0}) {
      if (const auto q = feedPixelOf(feed, place + side * sign + glm::dvec3(0, height, 0))) {
        box.lower = glm::min(box.lower, *q);
        box.upper = glm::max(box.upper, *q);
      }
    }
  }
  box.lower = glm::max(box.lower, glm::dvec2(0));
  box.upper = glm::min(box.upper, glm::dvec2(feed.width, feed.height));
  box.distance = glm::length(place - feed.pose.eye);
  return box.area() > 0 ? std::optional(box) : std::nullopt;
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

double beyond(const Plane& plane, const glm::dvec3& place, double fade) {
  const double height = plane.height(place);
  return fade > 0 ? std::clamp(0.5 + height / (2 * fade), 0.0, 1.0) : (height >= 0 ? 1.0 : 0.0);
}

struct SeenBody {
  FeedBox box;
  double share = 1;
  double shareBehind = 1;  ///< of somebody who stands behind it
};

/// Columns of the mask in which a blob has pixels: the lowest one of each, -1 where there is none.
std::vector<int> lowestRows(const Image<uint16_t>& labels, uint16_t label) {
  std::vector<int> lowest(static_cast<size_t>(labels.width()), -1);
  for (int y = 0; y < labels.height(); ++y) {
    for (int x = 0; x < labels.width(); ++x) {
      if (labels(x, y) == label) {
        lowest[static_cast<size_t>(x)] = y;
      }
    }
  }
  return lowest;
}

/// What the pixels of one blob show, by the bodies that it may be.
class BlobBodies {
 public:
  BlobBodies(const FeedGraph& graph, size_t frustum, const SubjectBlob& blob, const std::vector<int>& lowest,
             const std::vector<SeenSubject>& subjects)
      : graph_(graph), frustum_(frustum), lowest_(lowest) {
    const Feed& feed = graph.feedOf(frustum);
    const auto told = floorPlace(graph.setup(), graph.feedIndexOf(frustum), blob.foot);
    for (const SeenSubject& subject : subjects) {
      const auto box = bodyBox(feed, subject.place);
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
    if (blob.isCutBelow) {
      addCutBody(blob);
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
    bool isAbove = false;
    for (const SeenBody& body : bodies_) {
      const double width = std::max(body.box.upper.x - body.box.lower.x, 1.0);
      const double fromMiddle = std::abs(q.x - (body.box.lower.x + body.box.upper.x) / 2) / width;
      const double beside = std::max(0.0, fromMiddle - kCoreHalf);
      const double above = std::max(0.0, body.box.lower.y - q.y) / width;
      if (std::max(beside, above) < least) {
        least = std::max(beside, above);
        isAbove = above > beside;
        share = isAbove && above > kMaxBeside ? body.shareBehind : body.share;
      }
    }
    return least > kMaxBeside && !isAbove ? shareByFoot(column).value_or(share) : share;
  }

 private:
  SeenBody bodyAt(const FeedBox& box, const glm::dvec3& place) const {
    const glm::dvec3& eye = graph_.feedOf(frustum_).pose.eye;
    const glm::dvec3 behind = eye + (place - eye) * kBehind;
    return {box, shareShown(graph_, frustum_, place),
            shareShown(graph_, frustum_, {behind.x, graph_.setup().floorHeight, behind.z})};
  }

  /// Feet that are out of the image are nearer than the floor at its lower border.
  void addCutBody(const SubjectBlob& blob) {
    const double bottom = blob.upper.y / FeedBlobs::kMaskScale - kCutReach;
    FeedBox box{blob.upper, blob.lower, 0};
    for (size_t x = 0; x < lowest_.size(); ++x) {
      if (lowest_[x] >= bottom) {
        const double u = (static_cast<double>(x) + 0.5) * FeedBlobs::kMaskScale;
        box.lower = glm::min(box.lower, glm::dvec2(u, blob.lower.y));
        box.upper = glm::max(box.upper, glm::dvec2(u, blob.upper.y));
      }
    }
    if (const auto told = floorPlace(graph_.setup(), graph_.feedIndexOf(frustum_), blob.foot)) {
      const double byHeight = kCutHalfWidth * (blob.upper.y - blob.lower.y);
      const double byDistance = kSubjectRadius * graph_.feedOf(frustum_).lens.focal.x / std::max(told->distance, 0.1);
      const double around = std::max(byHeight, byDistance);
      box.lower.x -= around;
      box.upper.x += around;
      bodies_.push_back(bodyAt(box, told->place));
    }
  }

  /// By the lowest pixel around a column.
  std::optional<double> shareByFoot(int column) const {
    int row = -1;
    double u = column;
    for (int x = std::max(0, column - kFootReach);
         x <= std::min(static_cast<int>(lowest_.size()) - 1, column + kFootReach); ++x) {
      if (lowest_[static_cast<size_t>(x)] > row) {
        row = lowest_[static_cast<size_t>(x)];
        u = x;
      }
    }
    if (row < 0) {
      return std::nullopt;
    }
    const glm::dvec2 foot = glm::dvec2(u + 0.5, row + 1) * static_cast<double>(FeedBlobs::kMaskScale);
    const auto told = floorPlace(graph_.setup(), graph_.feedIndexOf(frustum_), foot);
    return told ? std::optional(shareShown(graph_, frustum_, told->place)) : std::nullopt;
  }

  const FeedGraph& graph_;
  size_t frustum_;
  const std::vector<int>& lowest_;
  std::vector<SeenBody> bodies_;  ///< the nearest first
};

}  // namespace

std::vector<SeenSubject> locateSubjects(const FeedSetup& setup, const std::vector<FeedBlobs>& blobs) {
  std::vector<PlaceTold> told;
  for (size_t feed = 0; feed < blobs.size(); ++feed) {
    for (const SubjectBlob& blob : blobs[feed].blobs) {
      if (!blob.isCutBelow) {
        if (const auto place = floorPlace(setup, feed, blob.foot)) {
          told.push_back(*place);
        }
      }
    }
  }
  std::sort(told.begin(), told.end(), [](const PlaceTold& a, const PlaceTold& b) { return a.distance < b.distance; });
  std::vector<SeenSubject> subjects;
  std::vector<bool> isTaken(told.size(), false);
  for (size_t i = 0; i < told.size(); ++i) {
    if (isTaken[i]) {
      continue;
    }
    std::vector<PlaceTold> same{told[i]};
    std::vector<size_t> feeds{told[i].feed};
    for (size_t k = i + 1; k < told.size(); ++k) {
      const bool isOtherFeed = std::find(feeds.begin(), feeds.end(), told[k].feed) == feeds.end();
      const double reach = kSameSubject + kSameShare * told[k].distance;
      if (!isTaken[k] && isOtherFeed && glm::length(told[k].place - told[i].place) < reach) {
        isTaken[k] = true;
        same.push_back(told[k]);
        feeds.push_back(told[k].feed);
      }
    }
    subjects.push_back({placeOf(setup, same), feeds});
  }
  return subjects;
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
  std::vector<std::vector<int>> lowest;
  lowest.reserve(blobs.blobs.size());
  for (size_t k = 0; k < blobs.blobs.size(); ++k) {
    lowest.push_back(lowestRows(blobs.core, static_cast<uint16_t>(k + 1)));
    bodies.emplace_back(graph, frustum, blobs.blobs[k], lowest.back(), subjects);
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
