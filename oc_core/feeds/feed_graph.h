// The graph camera of a setup, and where each pixel of its image lies in the feeds (section 4.3.3).
//
// "The quad corresponds to the near face of frustum PPC_i and the texture corresponds to the video frame acquired by
// the video camera of PPC_i." Without distortion such a quad is mapped by a homography, and along the tree homographies
// are multiplied. With G_p the matrix that makes a pixel (u, v, 1) of the output a direction of the rays of frustum p,
// with eye C_p, and (n, d) the plane of the near face of its child i,
//
//   G_i = ((C_p - C_i) n^T - (n . C_p - d) I) G_p,
//
// as the ray crosses the plane at C_p - (n . C_p - d) / (n . G_p q) G_p q, seen from C_i, times n . G_p q > 0.
#pragma once

#include <glm/mat3x3.hpp>
#include <optional>
#include <vector>

#include "oc_core/camera/graph_camera.h"
#include "oc_core/feeds/feed_setup.h"

namespace ocelli {

class FeedGraph {
 public:
  /// Frustum i of the camera is frustum i of the setup, which orderFrusta() has ordered. Throws InputError, naming the
  /// frustum, where a near face is not seen by its parent, lies before it or crosses that of another one, and where the
  /// camera of a frustum does not stand before its near face.
  explicit FeedGraph(const FeedSetup& setup);

  const FeedSetup& setup() const { return setup_; }
  const GraphCamera& camera() const { return camera_; }
  size_t frusta() const { return directions_.size(); }
  const Feed& feedOf(size_t frustum) const { return setup_.feeds[feeds_[frustum]]; }
  size_t feedIndexOf(size_t frustum) const { return feeds_[frustum]; }
  /// The frusta that the ray of a pixel of the output passes, from the root on.
  std::vector<size_t> chainAt(const glm::dvec2& pixel) const;

  /// The direction (x right, y down, 1 ahead) in the camera of a frustum of a pixel of the output, as if its near face
  /// had no borders; nothing behind the camera.
  std::optional<glm::dvec2> directionAt(size_t frustum, const glm::dvec2& pixel) const;
  /// The pixel of the feed of a frustum, through its lens; nothing outside of the feed.
  std::optional<glm::dvec2> feedPixelAt(size_t frustum, const glm::dvec2& pixel) const;

 private:
  FeedSetup setup_;
  GraphCamera camera_;
  std::vector<size_t> feeds_;           ///< of each frustum
  std::vector<glm::dmat3> directions_;  ///< to the axes of its camera
};

/// Where a world point is in a feed; nothing behind its camera or so far out that its lens says nothing.
std::optional<glm::dvec2> feedPixelOf(const Feed& feed, const glm::dvec3& point);
/// The ray of a pixel of a feed: its direction in the world; nothing where the lens has none.
std::optional<glm::dvec3> feedRayOf(const Feed& feed, const glm::dvec2& pixel);

}  // namespace ocelli
