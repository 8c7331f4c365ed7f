// Relief tiles where they stand: which tile a ray meets first (section 3.5.2.3.2).
//
// A ray is moved into the coordinates of a tile by an affine map, which keeps the share of its step: shares of
// different tiles compare, and where steps have a length of 1 along the view they are depths.
#pragma once

#include <memory>
#include <vector>

#include "oc_core/relief/relief_object.h"

namespace ocelli {

/// One copy of an object.
struct ReliefTile {
  size_t object = 0;
  glm::mat4 worldFromTile{1};  ///< affine and invertible
  glm::vec3 tint{1};           ///< linear; multiplies the colours of the object
};

class ReliefScene {
 public:
  using Objects = std::vector<std::shared_ptr<const ReliefObject>>;

  /// Throws InputError where a map is not invertible or not finite. Tiles of objects that rays cannot meet are never
  /// met.
  ReliefScene(Objects objects, std::vector<ReliefTile> tiles);

  struct Meeting {
    size_t tile = 0;
    TriangleMeeting meeting = {};
  };
  /// The first surface of any tile: through a tree over their boxes. Of equally near ones that of the first tile.
  std::optional<Meeting> meet(const StraightRay& ray, RayCost& cost) const;
  /// Whether any tile is met at all.
  bool meetsAny(const StraightRay& ray, RayCost& cost) const;
  /// As meet(), one tile after the other, each as its object does it slowly: what tests compare with.
  std::optional<Meeting> meetSlowly(const StraightRay& ray) const;

  struct Surface {
    glm::vec3 color{0};
    glm::vec3 normal{0};  ///< in the world, unit, on the side that `towards` comes from
  };
  /// `towards` is the direction of the ray.
  Surface surfaceAt(const Meeting& meeting, const glm::vec3& towards) const;

  const std::vector<ReliefTile>& tiles() const { return tiles_; }
  const ReliefObject& objectOf(size_t tile) const { return *objects_[tiles_[tile].object]; }
  const glm::mat4& tileFromWorld(size_t tile) const { return tileFromWorld_[tile]; }
  /// In the world; empty for a tile that nothing meets.
  const Box& boxOf(size_t tile) const { return boxes_[tile]; }
  Box bounds() const;
  /// What a length in a tile is multiplied with in the world, on average of the directions.
  float scaleOf(size_t tile) const { return scales_[tile]; }
  StraightRay rayInTile(const StraightRay& ray, size_t tile) const;

 private:
  /// A binary tree: a leaf has one tile.
  struct Node {
    Box box;
    size_t left = 0;  ///< children are nodes left and left + 1
    size_t tile = 0;
    bool leaf = true;
  };

  void build(size_t node, std::vector<size_t> tiles);
  /// Calls `visit(tile)` for tiles whose box the ray meets within the reach that visit() leaves it; until it returns
  /// true.
  template <class Visit>
  void visitAlong(StraightRay& ray, const Visit& visit) const;

  Objects objects_;
  std::vector<ReliefTile> tiles_;
  std::vector<glm::mat4> tileFromWorld_;
  std::vector<float> scales_;
  std::vector<Box> boxes_;
  std::vector<Node> nodes_;
};

}  // namespace ocelli
