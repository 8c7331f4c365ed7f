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
constexpr double kMinCrossing = 0.17;  ///< sine of the least angle between lines of sight that cross well
constexpr double kMinCovered = 0.3;    ///< share of a body's box that a blob covers which is that subject

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

/// The share of a box that a blob covers.
double coveredShare(const FeedBox& box, const SubjectBlob& blob) {
  const glm::dvec2 overlap = glm::max(glm::min(box.upper, blob.upper) - glm::max(box.lower, blob.lower), glm::dvec2(0));
  return overlap.x * overlap.y / box.area();
}

double beyond(const Plane& plane, const glm::dvec3& place, double fade) {
  const double height = plane.height(place);
  return fade > 0 ? std::clamp(0.5 + height / (2 * fade), 0.0, 1.0) : (height >= 0 ? 1.0 : 0.0);
}

struct SeenBody {
  FeedBox box;
  double share = 1;
};

/// Of one blob: the bodies that it may show, the nearest first.
std::vector<SeenBody> bodiesOf(const FeedGraph& graph, size_t frustum, const SubjectBlob& blob,
                               const std::vector<SeenSubject>& subjects) {
  const Feed& feed = graph.feedOf(frustum);
  std::vector<SeenBody> bodies;
  for (const SeenSubject& subject : subjects) {
    const auto box = bodyBox(feed, subject.place);
    if (box && coveredShare(*box, blob) >= kMinCovered) {
      bodies.push_back({*box, shareShown(graph, frustum, subject.place)});
    }
  }
  std::sort(bodies.begin(), bodies.end(),
            [](const SeenBody& a, const SeenBody& b) { return a.box.distance < b.box.distance; });
  if (bodies.empty()) {
    // No feed told its place well: its lowest point is at least as far off as its feet.
    const auto told = floorPlace(graph.setup(), graph.feedIndexOf(frustum), blob.foot);
    bodies.push_back({{blob.lower, blob.upper, 0}, told ? shareShown(graph, frustum, told->place) : 1});
  }
  return bodies;
}

/// The share of the nearest body at a column; where none covers it, that of the one beside it.
double shareAtColumn(const std::vector<SeenBody>& bodies, double u) {
  double least = std::numeric_limits<double>::infinity();
  double share = 1;
  for (const SeenBody& body : bodies) {
    const double away = std::max({0.0, body.box.lower.x - u, u - body.box.upper.x});
    if (away < least) {
      least = away;
      share = body.share;
    }
  }
  return share;
}

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
  std::vector<std::vector<uint8_t>> shares;  // of each blob, by column of the mask
  for (const SubjectBlob& blob : blobs.blobs) {
    const std::vector<SeenBody> bodies = bodiesOf(graph, frustum, blob, subjects);
    std::vector<uint8_t>& columns = shares.emplace_back(static_cast<size_t>(marks.width()));
    for (size_t x = 0; x < columns.size(); ++x) {
      const double u = (static_cast<double>(x) + 0.5) * FeedBlobs::kMaskScale;
      columns[x] = static_cast<uint8_t>(std::lround(255 * shareAtColumn(bodies, u)));
    }
  }
  for (int y = 0; y < marks.height(); ++y) {
    for (int x = 0; x < marks.width(); ++x) {
      const uint16_t wide = blobs.wide(x, y);
      if (wide > 0) {
        const uint8_t share = shares[wide - 1u][static_cast<size_t>(x)];
        marks(x, y) = {static_cast<uint8_t>(255 - share), blobs.core(x, y) > 0 ? share : uint8_t{0}};
      }
    }
  }
  return marks;
}

}  // namespace ocelli
