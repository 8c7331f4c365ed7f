// The rays of a tile of pixels, where the rays of a camera differ smoothly: between those of its corners. And which of
// such tiles see nothing of a volume. For .cpp files.
#pragma once

#include <array>
#include <functional>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>

#include "oc_core/camera/ray_path.h"
#include "oc_core/volume_render/index_points.h"
#include "oc_core/volume_render/volume_occupancy.h"

namespace ocelli {

/// In the world, around a volume: rays are compared where they are in it.
struct TileBall {
  glm::dvec3 center{0};
  double radius = 0;
};

class RayTile {
 public:
  using Rays = std::function<RayPath(const glm::vec2& pixel)>;

  /// Of the rays through the pixels from `first` to `last`, in pixels, both included. False, and the tile means
  /// nothing, where rays have no points or not as many as others, or where rays at the middle of the tile and of its
  /// sides are in the ball farther than `deviation`, in the unit of the world, from what is between those of the
  /// corners.
  bool fit(const Rays& rays, const glm::vec2& first, const glm::vec2& last, const TileBall& ball, double deviation);

  /// Bilinear between the corners' rays, point by point.
  RayPath at(const glm::vec2& pixel) const;

  /// `upper` are those of (first.x, first.y) and (last.x, first.y).
  const std::array<RayPath, 2>& upper() const { return upper_; }
  const std::array<RayPath, 2>& lower() const { return lower_; }

 private:
  glm::vec2 first_{0};
  glm::vec2 perSize_{0};
  std::array<RayPath, 2> upper_;
  std::array<RayPath, 2> lower_;
};

/// Which bricks of a volume rays can meet.
class TileSight {
 public:
  /// The occupancy must outlive it. `room`: so many voxels may rays be off.
  TileSight(const VolumeOccupancy& occupancy, const glm::dmat4& indexFromWorld, double room);

  /// Whether some ray of the tile may meet a brick that shows something. False only where none does.
  bool meets(const RayTile& tile) const;

 private:
  /// Corners of the tile at the begin and the end of a piece of its rays.
  struct Block {
    std::array<glm::dvec3, 4> from;
    std::array<glm::dvec3, 4> to;
  };
  bool meets(const Block& block, int splits) const;

  const VolumeOccupancy& occupancy_;
  glm::dmat4 indexFromWorld_;
  double room_;
};

}  // namespace ocelli
