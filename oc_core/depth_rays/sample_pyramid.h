// A pyramid of bounds over the cells of samples: where rays first meet a reference image, without missing any hit.
//
// The lowest level groups the cells of 4 x 4 pixels; where a group holds surfaces with a gap between them, which an
// image shows side by side, each gets a node of its own. Above it nodes group 16 by their places in the world:
// neighbours in an image may lie far apart, as tiles, layers and the images of a union do. Each node knows the least
// and the largest coordinates of each of its children, in the world: bounds of the surfaces themselves hold for every
// camera, however it displaces its samples or bends its rays, and a ray stays straight in them, where its image in an
// occlusion camera is a curve.
//
// Nodes are opened from near to far, and the walk ends when nothing that is left begins before the first hit. Boxes are
// grown by more than single precision rounds: a ray that meets a triangle meets all boxes around it.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "oc_core/depth_rays/ray_block.h"
#include "oc_core/depth_rays/ray_cost.h"
#include "oc_core/depth_rays/sample_cells.h"
#include "oc_core/depth_rays/straight_ray.h"
#include "oc_core/scene/box.h"

namespace ocelli {

class SamplePyramid {
 public:
  /// The cells must outlive it.
  explicit SamplePyramid(const SampleCells& cells);

  /// The first triangle that the ray meets. The ray has finite numbers and a direction. `cost` grows.
  std::optional<TriangleMeeting> meet(const StraightRay& ray, RayCost& cost) const;

  /// The same for each ray of a block, which stands for fewer steps where they run close to each other: a triangle that
  /// is met nearer than the reach of a ray takes the place of what `meeting` says, and shortens the reach.
  void meetBlock(RayBlock& block, RayCost& cost) const;
  /// The same, for blocks whose rays run far apart from each other, compared with samples: the nodes that are about as
  /// wide as the block are found for all rays together, and each ray goes on from there by itself.
  void meetWideBlock(RayBlock& block, RayCost& cost) const;

  /// Cells that hold surfaces.
  size_t filledCells() const { return filledCells_; }
  /// The most steps that a ray can take: no node is opened twice, and no cell is tested twice.
  size_t maxSteps() const { return nodes_.size() + filledCells_; }
  Box bounds() const { return bounds_; }

  // How it lies in memory, for what walks it elsewhere than on the CPU (oc_core/gl_rays).

  static constexpr int kSide = 4;
  static constexpr size_t kChildren = kSide * kSide;
  /// What a child is: a node, or the cell of a pixel.
  static constexpr uint32_t kCellBit = 0x80000000u;

  struct Node {
    std::array<std::array<float, kChildren>, 3> lower;
    std::array<std::array<float, kChildren>, 3> upper;
    std::array<uint32_t, kChildren> child;
    uint32_t count = 0;  ///< of children; the others are boxes that nothing meets
  };

  /// Each stands behind the nodes below it.
  std::span<const Node> nodes() const { return nodes_; }
  /// What the walk begins with: a node or a cell; nothing where there is nothing to hit.
  std::optional<uint32_t> root() const { return root_.box.empty() ? std::nullopt : std::optional(root_.reference); }
  /// Nodes on the longest way down to a cell.
  size_t depth() const;
  /// The most children that wait at once in a walk that opens the nearest first: each opened node takes the place of
  /// one and leaves kChildren.
  size_t maxWaiting() const { return depth() * (kChildren - 1) + 1; }

 private:
  struct Child {
    Box box;  ///< empty where there is none
    uint32_t reference = 0;
  };
  using Children = std::vector<Child>;
  /// What a ray has still to look at. Without initial values: a ray needs few of an array of them.
  struct Waiting {
    float entry;
    uint32_t reference;
  };
  /// Ranges are halved evenly, so that 2^31 cells have less than 10 levels; each leaves 15 children waiting.
  static constexpr size_t kMaxWaiting = 16 * 16;
  /// Nodes that the rays of a wide block begin at.
  static constexpr size_t kMaxBegins = 40;
  using WaitingList = std::array<Waiting, kMaxWaiting + kMaxBegins>;

  /// Goes on with what waits, the nearest last.
  std::optional<TriangleMeeting> goOn(const StraightRay& ray, WaitingList& waiting, size_t count, RayCost& cost) const;
  Children cellsOf(const SampleGrid& grid, float margin) const;
  /// One node, or several where gaps part them.
  void addBlock(std::span<Child> cells, Children& blocks);
  /// One node over all of them.
  Child treeOver(std::span<Child> children);
  /// Of 16 at most.
  Child nodeOf(std::span<const Child> children);

  const SampleCells& cells_;
  std::vector<Node> nodes_;
  size_t filledCells_ = 0;
  Child root_;
  Box bounds_;
};

/// The slow reference: every triangle of every cell.
std::optional<TriangleMeeting> meetEveryCell(const SampleCells& cells, const StraightRay& ray);

}  // namespace ocelli
