#include "oc_core/feeds_place/near_faces.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <compare>
#include <glm/geometric.hpp>
#include <map>
#include <optional>

#include "oc_core/base/conventions.h"
#include "oc_core/base/error.h"
#include "oc_core/feeds/feed_map.h"
#include "oc_core/feeds_place/opening_faces.h"

namespace ocelli {
namespace {

constexpr int kTrialWidth = 160;        ///< pixels, of images in which faces are tried
constexpr double kTurnStep = 1;         ///< degrees
constexpr double kCoverageLost = 0.02;  ///< share of a face that may become empty by turning it

/// The frusta of a setup while they are found.
class FaceFinder {
 public:
  FaceFinder(FeedSetup& setup, const FeedPlaceScene& place, const NearFaceOptions& options)
      : setup_(setup), options_(options), map_(place.map), walls_(place.mesh) {
    setup_.frusta.resize(1);  // the root, which orderFrusta() has put first
  }

  NearFaces find() {
    for (size_t parent = 0; parent < setup_.frusta.size(); ++parent) {
      placeChildrenOf(std::string(setup_.frusta[parent].feed));
    }
    turnFaces();
    const FeedMap map{FeedGraph(setup_)};
    for (size_t i = 1; i < setup_.frusta.size(); ++i) {
      found_.faces[i - 1].coverage = map.coverage(i);
    }
    for (const Feed& feed : setup_.feeds) {
      if (!isPlaced(feed.name)) {
        found_.missing.push_back({feed.name, whyNot(feed)});
      }
    }
    return std::move(found_);
  }

 private:
  const Feed& feed(const std::string& name) const { return setup_.feeds[static_cast<size_t>(setup_.feedIndex(name))]; }
  bool isPlaced(const std::string& name) const {
    return std::ranges::any_of(setup_.frusta, [&](const FeedFrustum& f) { return f.feed == name; });
  }

  /// How well the feeds fill the image; nothing where the frusta are no graph camera.
  std::optional<std::vector<double>> coverageOf(const std::vector<FeedFrustum>& frusta) {
    FeedSetup trial = setup_;
    trial.frusta = frusta;
    trial.output.height = std::max(16, trial.output.height * kTrialWidth / trial.output.width);
    trial.output.width = kTrialWidth;
    try {
      const FeedMap map{FeedGraph(trial)};
      std::vector<double> coverage;
      for (size_t i = 0; i < frusta.size(); ++i) {
        coverage.push_back(map.coverage(i));
      }
      return coverage;
    } catch (const InputError& error) {
      refusal_ = error.what();
      return std::nullopt;
    }
  }

  /// Makes feeds children of a parent, beginning with the opening that is nearest to it: what lies behind is seen
  /// through that.
  void placeChildrenOf(const std::string& parent) {
    const glm::dvec3 eye = feed(parent).pose.eye;
    struct Candidate {
      double distance;
      size_t opening;
      std::string feed;
      auto operator<=>(const Candidate&) const = default;
    };
    std::vector<Candidate> candidates;
    for (const Feed& feed : setup_.feeds) {
      for (size_t i = 0; i < map_.portals.size(); ++i) {
        const WalkPortal& portal = map_.portals[i];
        if (!isPlaced(feed.name) && !portal.isJoint && looksThrough(feed, eye, portal.opening, walls_)) {
          candidates.push_back({glm::distance(eye, glm::dvec3(portal.opening.center)), i, feed.name});
        }
      }
    }
    std::ranges::sort(candidates);
    for (const Candidate& each : candidates) {
      if (isPlaced(each.feed)) {
        continue;
      }
      std::vector<FeedFrustum> frusta = setup_.frusta;
      frusta.push_back({each.feed, parent, faceOf(map_.portals[each.opening].opening, walls_)});
      if (coverageOf(frusta)) {
        setup_.frusta = std::move(frusta);
        found_.faces.push_back({each.feed, parent, each.opening, 0, 0});
      } else {
        refusals_[each.feed] = fmt::format("{} is refused: {}", nameOfOpening(each.opening), refusal_);
      }
    }
  }

  std::vector<FeedFrustum> turned(double degrees, std::vector<double>& turns) const {
    std::vector<FeedFrustum> frusta = setup_.frusta;
    turns.assign(frusta.size(), 0);
    for (size_t i = 1; i < frusta.size(); ++i) {
      const glm::dvec3 eye = feed(frusta[i].parent).pose.eye;
      const double wanted = degreesFromRadians(angleTowards(frusta[i].near, eye)) - kFaceTowards;
      turns[i] = std::clamp(wanted, 0.0, degrees);
      if (turns[i] > 0) {
        frusta[i].near = turnedFace(frusta[i].near, eye, radiansFromDegrees(turns[i]), walls_);
      }
    }
    return frusta;
  }

  /// All by the same angle, so that those on both sides of a way meet in its middle.
  void turnFaces() {
    const auto before = coverageOf(setup_.frusta);
    std::vector<FeedFrustum> best = setup_.frusta;
    for (double degrees = kTurnStep; degrees <= options_.maxTurnDegrees; degrees += kTurnStep) {
      std::vector<double> turns;
      std::vector<FeedFrustum> frusta = turned(degrees, turns);
      const auto coverage = coverageOf(frusta);
      bool isAsFull = coverage.has_value();
      for (size_t i = 1; isAsFull && i < frusta.size(); ++i) {
        isAsFull = (*coverage)[i] >= (*before)[i] - kCoverageLost;
      }
      if (!isAsFull) {
        break;
      }
      best = std::move(frusta);
      for (size_t i = 1; i < best.size(); ++i) {
        found_.faces[i - 1].turnDegrees = turns[i];
      }
    }
    setup_.frusta = std::move(best);
  }

  std::string whyNot(const Feed& feed) const {
    if (const auto refused = refusals_.find(feed.name); refused != refusals_.end()) {
      return refused->second;
    }
    const bool seesOpening = std::ranges::any_of(map_.portals, [&](const WalkPortal& portal) {
      return !portal.isJoint && seesMiddle(feed, portal.opening, walls_);
    });
    if (!seesOpening) {
      return "it sees no opening: turn its camera towards one, or draw its near face by hand";
    }
    return "it looks through no opening that a frustum sees from the same side: its camera must stand before its near "
           "face, where people come from; draw that by hand";
  }

  FeedSetup& setup_;
  const NearFaceOptions& options_;
  const WalkMap& map_;
  PlaceWalls walls_;
  NearFaces found_;
  std::string refusal_;                          ///< why frusta were no graph camera, the last time
  std::map<std::string, std::string> refusals_;  ///< by feed
};

}  // namespace

NearFaces findNearFaces(FeedSetup& setup, const FeedPlaceScene& place, const NearFaceOptions& options) {
  if (place.map.openingCount() == 0) {
    throw InputError("the place has no openings between rooms", "--place",
                     "`ocelli scene walk` shows what it has; draw near faces by hand");
  }
  return FaceFinder(setup, place, options).find();
}

}  // namespace ocelli
