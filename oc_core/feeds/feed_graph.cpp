#include "oc_core/feeds/feed_graph.h"

#include <fmt/format.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "oc_core/base/error.h"

namespace ocelli {
namespace {

constexpr float kFeedNear = 0.05f;
constexpr float kFeedFar = 1e4f;

PinholeCamera rootOf(const FeedSetup& setup) {
  const Feed& feed = setup.feeds[static_cast<size_t>(setup.feedIndex(setup.frusta.front().feed))];
  View view;
  view.eye = glm::vec3(feed.pose.eye);
  view.target = glm::vec3(setup.output.target);
  view.up = glm::vec3(feed.pose.up);
  view.fovVerticalDegrees = setup.output.fovVerticalDegrees;
  view.zNear = kFeedNear;
  view.zFar = kFeedFar;
  validate(view, "the output of the setup");
  return {view, setup.output.width, setup.output.height};
}

/// Columns are the axes of a camera: right, down, forward.
glm::dmat3 worldFromFeed(const FeedPose& pose) {
  return {pose.right(), pose.down(), pose.forward()};
}

double turnOf(const GraphCamera::Part& part) {
  double twice = 0;
  for (size_t i = 0; i < part.size(); ++i) {
    const glm::dvec2& a = part[i];
    const glm::dvec2& b = part[(i + 1) % part.size()];
    twice += a.x * b.y - a.y * b.x;
  }
  return twice;
}

Plane nearPlaneOf(const FeedFrustum& frustum, const glm::dvec3& eye) {
  const auto& p = frustum.near;
  const glm::dvec3 middle = (p[0] + p[1] + p[2] + p[3]) / 4.0;
  Plane plane = Plane::through(middle, glm::cross(p[2] - p[0], p[3] - p[1]));
  if (plane.height(eye) > 0) {
    plane = {-plane.normal, -plane.distance};
  }
  return plane;
}

/// The near face in the image of its parent, cut to what that shows.
GraphCamera::Part partOf(const FeedFrustum& frustum, const GraphCamera::Frustum& parent) {
  GraphCamera::Part part;
  for (const glm::dvec3& corner : frustum.near) {
    const glm::dvec4 q = parent.pixelFromWorld * glm::dvec4(corner, 1);
    if (!(parent.plane.height(corner) > 0) || !(q.w > 0)) {
      throw InputError(
          fmt::format("the near face of \"{}\" begins before that of its parent \"{}\"", frustum.feed, frustum.parent),
          "frustum \"" + frustum.feed + "\"", "move the near face away from the root, along the rays");
    }
    part.emplace_back(q.x / q.w, q.y / q.w);
  }
  if (turnOf(part) < 0) {
    std::reverse(part.begin(), part.end());
  }
  for (size_t i = 0; i < parent.part.size() && !part.empty(); ++i) {
    part = GraphCamera::cut(part, parent.part[i], parent.part[(i + 1) % parent.part.size()]).first;
  }
  if (part.empty()) {
    throw InputError(
        fmt::format("the near face of \"{}\" is out of the sight of its parent \"{}\"", frustum.feed, frustum.parent),
        "frustum \"" + frustum.feed + "\"", "move the near face into the image of the parent");
  }
  return part;
}

/// Errors of cameras speak of planes and rays: here they are about near faces.
void bendAt(GraphCamera& camera, int parent, const GraphCamera::Bend& bend, const std::string& feed,
            const GraphCamera::Part& part) {
  try {
    camera.bend(parent, bend, feed, part);
  } catch (const InputError& error) {
    throw InputError("the near face of \"" + feed + "\" cannot stand there: " + error.parts().problem,
                     "frustum \"" + feed + "\"",
                     "move it beside the others, across the view of its parent and before its own camera; `ocelli "
                     "feeds edit` draws them");
  }
}

}  // namespace

FeedGraph::FeedGraph(const FeedSetup& setup) : setup_(setup), camera_(rootOf(setup)) {
  const PinholeCamera& root = camera_.root();
  const double f = static_cast<double>(root.focalPixels());
  const glm::dvec2 center(root.centerPixels());
  // A pixel (u, v, 1) as a direction in the world, in the frustum of the root.
  const glm::dmat3 worldFromPixel = glm::dmat3(root.right(), root.down(), root.forward()) *
                                    glm::dmat3(1 / f, 0, 0, 0, 1 / f, 0, -center.x / f, -center.y / f, 1);
  std::vector<glm::dmat3> worldFromPixels;
  std::vector<glm::dvec3> eyes;
  for (size_t i = 0; i < setup_.frusta.size(); ++i) {
    const FeedFrustum& frustum = setup_.frusta[i];
    const auto feed = static_cast<size_t>(setup_.feedIndex(frustum.feed));
    const FeedPose& pose = setup_.feeds[feed].pose;
    feeds_.push_back(feed);
    if (frustum.isRoot()) {
      worldFromPixels.push_back(worldFromPixel);
      eyes.emplace_back(root.eye());
    } else {
      const auto parent =
          static_cast<size_t>(std::find_if(setup_.frusta.begin(), setup_.frusta.end(),
                                           [&](const FeedFrustum& other) { return other.feed == frustum.parent; }) -
                              setup_.frusta.begin());
      const Plane plane = nearPlaneOf(frustum, pose.eye);
      const auto part = partOf(frustum, camera_.frusta()[parent]);
      bendAt(camera_, static_cast<int>(parent), {plane, pose.eye}, frustum.feed, part);
      const double height = plane.height(eyes[parent]);
      worldFromPixels.push_back((glm::outerProduct(eyes[parent] - pose.eye, plane.normal) - glm::dmat3(height)) *
                                worldFromPixels[parent]);
      eyes.push_back(pose.eye);
    }
    directions_.push_back(glm::transpose(worldFromFeed(pose)) * worldFromPixels[i]);
  }
}

std::vector<size_t> FeedGraph::chainAt(const glm::dvec2& pixel) const {
  std::vector<size_t> chain;
  for (int i = GraphCamera::kRoot; i >= 0; i = camera_.childAt(i, pixel)) {
    chain.push_back(static_cast<size_t>(i));
  }
  return chain;
}

std::optional<glm::dvec2> FeedGraph::directionAt(size_t frustum, const glm::dvec2& pixel) const {
  const glm::dvec3 direction = directions_[frustum] * glm::dvec3(pixel, 1);
  return direction.z > 0 ? std::optional(glm::dvec2(direction) / direction.z) : std::nullopt;
}

std::optional<glm::dvec2> FeedGraph::feedPixelAt(size_t frustum, const glm::dvec2& pixel) const {
  const auto direction = directionAt(frustum, pixel);
  if (!direction) {
    return std::nullopt;
  }
  const Feed& feed = feedOf(frustum);
  const auto found = pixelOf(feed.lens, *direction);
  const bool isInside = found && found->x >= 0 && found->y >= 0 && found->x <= feed.width && found->y <= feed.height;
  return isInside ? found : std::nullopt;
}

std::optional<glm::dvec2> feedPixelOf(const Feed& feed, const glm::dvec3& point) {
  const glm::dvec3 p = glm::transpose(worldFromFeed(feed.pose)) * (point - feed.pose.eye);
  return p.z > 0 ? pixelOf(feed.lens, glm::dvec2(p) / p.z) : std::nullopt;
}

std::optional<glm::dvec3> feedRayOf(const Feed& feed, const glm::dvec2& pixel) {
  const auto direction = directionOf(feed.lens, pixel);
  return direction ? std::optional(worldFromFeed(feed.pose) * glm::dvec3(*direction, 1)) : std::nullopt;
}

}  // namespace ocelli
