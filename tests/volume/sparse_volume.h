// Volumes in sparse files, for tests of volumes that are larger than memory.
#pragma once

#include <cstdint>
#include <filesystem>
#include <glm/vec3.hpp>

#include "oc_core/volume/mapped_voxels.h"

namespace ocelli::test {

/// A volume of int16 voxels that are 0, but for the slabs of some slices, which are `kSlabValue`.
class SparseVolume {
 public:
  static constexpr int16_t kSlabValue = 1000;

  /// The file is made in `folder`. Slices from `first` up to `last` are written, the others are holes.
  SparseVolume(const std::filesystem::path& folder, const glm::ivec3& size, int first, int last);

  /// Whether the disk keeps holes: where not, there is nothing to test.
  bool isSparse() const;
  ScalarVolume map() const;

 private:
  glm::ivec3 size_;
  std::filesystem::path path_;
};

}  // namespace ocelli::test
