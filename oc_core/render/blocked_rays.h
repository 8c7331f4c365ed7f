// Whether anything stands between two points: rays that need no first hit, and so end at any. Embree's where the
// toolkit is built with it, the tree of triangle_tree.h where not.
#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "oc_core/render/sight_line.h"
#include "oc_core/scene/mesh.h"

namespace ocelli {

class BlockedRays {
 public:
  /// The mesh must outlive it. `fast` builds faster and answers slower.
  explicit BlockedRays(const Mesh& mesh, bool fast = false);
  ~BlockedRays();
  BlockedRays(const BlockedRays&) = delete;
  BlockedRays& operator=(const BlockedRays&) = delete;

  /// Writes 1 where a triangle meets the line, both of its ends included, else 0; one entry of `blocked` a line. Lines
  /// whose coordinates are not finite meet nothing. Neighbours should run alike. Safe to call from many threads.
  void find(std::span<const SightLine> lines, std::span<uint8_t> blocked) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace ocelli
