#include "oc_core/feeds/feed_setup.h"

#include <fmt/format.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <set>

#include "oc_core/base/error.h"

namespace ocelli {
namespace {

/// Corners of a near face lie in one plane to within this share of its size.
constexpr double kFlatness = 1e-3;

[[noreturn]] void failSetup(const std::string& what, const std::string& where, const std::string& next) {
  throw InputError(what, where, next);
}

void checkNearFace(const FeedFrustum& frustum, const std::string& where) {
  const auto& p = frustum.near;
  const glm::dvec3 normal = glm::cross(p[2] - p[0], p[3] - p[1]);
  const double size = std::max(glm::length(p[2] - p[0]), glm::length(p[3] - p[1]));
  if (!(glm::length(normal) > 1e-6 * size * size) || !(size > 0)) {
    failSetup(fmt::format("the near face of \"{}\" has no area", frustum.feed), where,
              "give its four corners one after another around it");
  }
  const double offPlane = std::abs(glm::dot(p[1] - p[0], glm::normalize(normal)));
  if (offPlane > kFlatness * size) {
    failSetup(fmt::format("the near face of \"{}\" is not flat: its corners are {:.3g} m off a plane", frustum.feed,
                          offPlane),
              where, "move its corners into one plane");
  }
}

void checkNames(const FeedSetup& setup, const std::string& where) {
  std::set<std::string> feeds;
  for (const Feed& feed : setup.feeds) {
    if (!feeds.insert(feed.name).second) {
      failSetup(fmt::format("two feeds are called \"{}\"", feed.name), where, "give each feed a name of its own");
    }
  }
  std::set<std::string> frusta;
  for (const FeedFrustum& frustum : setup.frusta) {
    if (setup.feedIndex(frustum.feed) < 0) {
      failSetup(fmt::format("a frustum names the feed \"{}\", which does not exist", frustum.feed), where,
                "use the name of one of the feeds");
    }
    if (!frusta.insert(frustum.feed).second) {
      failSetup(fmt::format("two frusta have the feed \"{}\"", frustum.feed), where, "give each frustum its own feed");
    }
  }
  const auto checkPlace = [&](const std::string& feed) {
    if (!feeds.contains(feed)) {
      failSetup(fmt::format("\"places\" names the feed \"{}\", which does not exist", feed), where,
                "use the name of one of the feeds");
    }
  };
  for (const KnownTag& tag : setup.places.tags) {
    std::ranges::for_each(tag.seenBy, checkPlace);
  }
  for (const ClickedCorner& corner : setup.places.corners) {
    checkPlace(corner.feed);
  }
  for (const FeedFrustum& frustum : setup.frusta) {
    if (!frustum.isRoot() && !frusta.contains(frustum.parent)) {
      failSetup(fmt::format("the parent \"{}\" of frustum \"{}\" is no frustum", frustum.parent, frustum.feed), where,
                "name the feed of another frustum, or leave \"parent\" out for the root");
    }
  }
}

}  // namespace

glm::dvec3 FeedPose::forward() const {
  return glm::normalize(target - eye);
}

glm::dvec3 FeedPose::right() const {
  return glm::normalize(glm::cross(forward(), up));
}

glm::dvec3 FeedPose::down() const {
  return glm::cross(forward(), right());
}

int FeedSetup::feedIndex(const std::string& name) const {
  const auto found = std::find_if(feeds.begin(), feeds.end(), [&](const Feed& feed) { return feed.name == name; });
  return found == feeds.end() ? -1 : static_cast<int>(found - feeds.begin());
}

void orderFrusta(FeedSetup& setup, const std::string& where) {
  checkNames(setup, where);
  const auto roots =
      std::count_if(setup.frusta.begin(), setup.frusta.end(), [](const FeedFrustum& f) { return f.isRoot(); });
  if (roots != 1) {
    failSetup(roots == 0 ? "no frustum is the root" : fmt::format("{} frusta are roots", roots), where,
              "leave \"parent\" and \"near\" out for the one frustum that the image begins with");
  }
  std::vector<FeedFrustum> ordered;
  std::set<std::string> placed;
  while (ordered.size() < setup.frusta.size()) {
    const size_t before = ordered.size();
    for (const FeedFrustum& frustum : setup.frusta) {
      if (!placed.contains(frustum.feed) && (frustum.isRoot() || placed.contains(frustum.parent))) {
        if (!frustum.isRoot()) {
          checkNearFace(frustum, where);
        }
        placed.insert(frustum.feed);
        ordered.push_back(frustum);
      }
    }
    if (ordered.size() == before) {
      const auto lost = std::find_if(setup.frusta.begin(), setup.frusta.end(),
                                     [&](const FeedFrustum& f) { return !placed.contains(f.feed); });
      failSetup(fmt::format("frustum \"{}\" does not lead to the root: its parents go round in a circle", lost->feed),
                where, "give one of them a parent that leads to the root");
    }
  }
  setup.frusta = std::move(ordered);
}

}  // namespace ocelli
