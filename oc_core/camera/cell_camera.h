// The cell camera: one single-layer image of what is seen from a whole region of viewpoints (the text's future work,
// section 8.2, which extends the viewpoint of a pinhole to a segment and then to a region).
//
// Its rays are those of a reference pinhole, each up to the surface it samples, and pieces of rays of further pinholes,
// the satellites: the piece of each up to the surface it samples that no earlier viewpoint reaches. A point in space
// thus lies on at most one ray, that of the first viewpoint which reaches it: the projection is unambiguous, and is
// found in as many steps as there are viewpoints (the properties of section 4.1: disocclusion, single layer,
// unambiguous and efficient projection).
//
// The image has the reference pinhole's pixels on top. Below stand those pixels of the satellites that hold a sample,
// in square tiles of 16x16, as many beside each other as fit. Neighbouring tiles of a satellite share a row or a column
// of pixels, so that each can be made into a mesh by itself.
#pragma once

#include <vector>

#include "oc_core/camera/pinhole_camera.h"
#include "oc_core/image/image.h"

namespace ocelli {

class CellCamera {
 public:
  static constexpr int kTileSide = 16;

  struct Viewpoint {
    PinholeCamera camera;
    /// How far the ray of each pixel reaches, along the direction of this viewpoint; 0 for pixels that have none. For
    /// the reference, pixels that see no surface reach to its zFar.
    Image<float> reach;
  };

  /// A tile of the image: which pixels of which viewpoint it shows.
  struct Tile {
    size_t viewpoint = 0;
    glm::ivec2 corner{0};  ///< top left pixel in the image of the viewpoint
  };

  /// The first viewpoint is the reference. Each reach has the size of its camera.
  explicit CellCamera(std::vector<Viewpoint> viewpoints);

  int width() const { return reference().width(); }
  int height() const { return height_; }
  const PinholeCamera& reference() const { return viewpoints_[0].camera; }
  const std::vector<Viewpoint>& viewpoints() const { return viewpoints_; }
  /// In the order of the image, row by row.
  const std::vector<Tile>& tiles() const { return tiles_; }
  /// Top left pixel of a tile in the image.
  glm::ivec2 cornerOf(size_t tile) const;

  /// Nothing for points that no viewpoint reaches, or that the one which does shows outside of its image.
  std::optional<ImagePoint> project(const glm::vec3& worldPoint) const;
  std::optional<glm::vec3> unproject(const ImagePoint& q) const;
  RayPath rayPath(const glm::vec2& pixel) const;

 private:
  /// A pixel position of a viewpoint.
  struct Place {
    size_t viewpoint;
    glm::vec2 pixel;
  };

  std::optional<Place> placeOf(const glm::vec2& pixel) const;
  bool reaches(size_t viewpoint, const ImagePoint& q) const;
  bool reachedBefore(size_t viewpoint, const glm::vec3& worldPoint) const;
  std::optional<glm::vec3> pointAt(const Place& place, float referenceZ) const;

  std::vector<Viewpoint> viewpoints_;
  std::vector<Tile> tiles_;
  std::vector<Image<int>> tileOf_;  ///< for each viewpoint, the tile at (x / 15, y / 15), -1 where there is none
  int tilesPerRow_ = 1;
  int height_ = 0;
};

static_assert(Camera<CellCamera>);

}  // namespace ocelli
