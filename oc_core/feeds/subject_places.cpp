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

constexpr double kSameSubject = 0.8;  ///< metres between places that two feeds tell of one subject
constexpr double kFootError = 0.008;  ///< of a place told by feet, metres for each square metre of distance
constexpr double kHeadError = 0.15;   ///< of one told by a head, metres for each metre of distance
constexpr double kMinCrossing = 0.5;  ///< sine of the least angle between lines of sight that cross well

/// Metres, about: along the line of sight.
double errorOf(const PlaceTold& told) {
  return told.isByHead ? kHeadError * told.distance : kFootError * told.distance * told.distance;
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

double beyond(const Plane& plane, const glm::dvec3& place, double fade) {
  const double height = plane.height(place);
  return fade > 0 ? std::clamp(0.5 + height / (2 * fade), 0.0, 1.0) : (height >= 0 ? 1.0 : 0.0);
}

}  // namespace

std::vector<SeenSubject> locateSubjects(const FeedSetup& setup, const std::vector<FeedBlobs>& blobs,
                                        const std::vector<const Image<uint16_t>*>& known) {
  const Image<uint16_t> nobody;
  std::vector<PlaceTold> told;
  for (size_t feed = 0; feed < blobs.size(); ++feed) {
    for (const PeeledBody& body : peelBodies(setup, feed, blobs[feed], known.empty() ? nobody : *known[feed])) {
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
    std::vector<size_t> feeds{told[i].feed};
    for (size_t k = i + 1; k < told.size(); ++k) {
      const bool isOtherFeed = std::find(feeds.begin(), feeds.end(), told[k].feed) == feeds.end();
      const double reach = kSameSubject + errorOf(told[k]);
      if (!isTaken[k] && isOtherFeed && glm::length(told[k].place - told[i].place) < reach) {
        isTaken[k] = true;
        same.push_back(told[k]);
        feeds.push_back(told[k].feed);
      }
    }
    subjects.push_back({placeOf(setup, same), feeds, errorOf(same.front())});
  }
  return subjects;
}

double shareEntered(const FeedGraph& graph, size_t frustum, const glm::dvec3& place) {
  const auto& frusta = graph.camera().frusta();
  double share = 1;
  for (int i = static_cast<int>(frustum); i != GraphCamera::kRoot; i = frusta[static_cast<size_t>(i)].parent) {
    share = std::min(share, beyond(frusta[static_cast<size_t>(i)].plane, place, graph.setup().fadeMetres));
  }
  return share;
}

double shareShown(const FeedGraph& graph, size_t frustum, const glm::dvec3& place) {
  const auto& frusta = graph.camera().frusta();
  const double fade = graph.setup().fadeMetres;
  double share = shareEntered(graph, frustum, place);
  for (const int child : frusta[frustum].children) {
    share = std::min(share, 1 - beyond(frusta[static_cast<size_t>(child)].plane, place, fade));
  }
  return share;
}

}  // namespace ocelli
