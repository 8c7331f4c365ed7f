// Reading all voxels of a volume once, on all threads, also where they do not fit into memory.
#pragma once

#include <cstddef>
#include <functional>

#include "oc_core/base/progress.h"
#include "oc_core/volume/scalar_volume.h"

namespace ocelli {

/// Calls `body(begin, end)` on all threads, for slices (indices along k) that together are those of [first, last). Of a
/// volume that comes from a store (voxel_store.h), parts are read ahead and given back when they are done, so that no
/// more than some 256 MiB of it are in memory for this.
void scanSlices(const ScalarVolume& volume, size_t first, size_t last,
                const std::function<void(size_t begin, size_t end)>& body);

/// While it lives, slices [first, last) may be read; those that there are, at the most. Of a volume from a store they
/// are read ahead, and given back at the end. Of any other this does nothing.
class SlicesInMemory {
 public:
  SlicesInMemory(const ScalarVolume& volume, size_t first, size_t last);
  ~SlicesInMemory();
  SlicesInMemory(const SlicesInMemory&) = delete;
  SlicesInMemory& operator=(const SlicesInMemory&) = delete;

 private:
  const VoxelStore* store_;
  size_t begin_ = 0;  ///< bytes of the voxels
  size_t end_ = 0;
};

/// Whether the rows [firstRow, lastRow) of slice k, in the store of the volume, are known to be zero without being
/// read.
bool areRowsKnownZero(const ScalarVolume& volume, size_t slice, size_t firstRow, size_t lastRow);

}  // namespace ocelli
