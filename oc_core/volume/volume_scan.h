// Reading all voxels of a volume once, on all threads, also where they do not fit into memory.
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <limits>

#include "oc_core/volume/scalar_volume.h"

namespace ocelli {

/// Calls `body(begin, end)` on all threads, for slices (indices along k) that together are those of [first, last). Of a
/// volume that comes from a store (voxel_store.h), parts of some 128 MiB, or of one slice where that is more, are
/// read ahead and given back when they are done: no more of it is in memory for this.
void scanSlices(const ScalarVolume& volume, size_t first, size_t last,
                const std::function<void(size_t begin, size_t end)>& body);

/// Slices, or rows of one: those from `first` on, before `last`.
struct IndexRange {
  size_t first = 0;
  size_t last = 0;
};
inline constexpr IndexRange kAllRows{0, std::numeric_limits<size_t>::max()};

/// While it lives, these rows of these slices may be read, of those that there are. Of a volume from a store they are
/// read ahead, unless few of them will be read, and given back at the end. Of any other this does nothing.
class RowsInMemory {
 public:
  RowsInMemory(const ScalarVolume& volume, const IndexRange& slices, const IndexRange& rows = kAllRows,
               bool readsAhead = true);
  ~RowsInMemory();
  RowsInMemory(const RowsInMemory&) = delete;
  RowsInMemory& operator=(const RowsInMemory&) = delete;

 private:
  /// Calls `visit(begin, end)` with the bytes of each piece.
  void forEachPiece(const std::function<void(size_t begin, size_t end)>& visit) const;

  const VoxelStore* store_;
  size_t pieces_ = 0;
  size_t firstByte_ = 0;  ///< of the first piece
  size_t pieceBytes_ = 0;
  size_t stride_ = 0;  ///< bytes from one piece to the next
};

/// Whether the rows [firstRow, lastRow) of slice k, in the store of the volume, are known to be zero without being
/// read.
bool areRowsKnownZero(const ScalarVolume& volume, size_t slice, size_t firstRow, size_t lastRow);

/// Calls `onRow(j, row)` with a pointer to the first voxel of each row of a slice, in order, and `onZeros(rows)` for
/// rows that are known to be zero. `first` is the first voxel of the volume, of the type that it has.
template <class Voxel, class OnRow, class OnZeros>
void visitRows(const ScalarVolume& volume, const Voxel* first, size_t slice, OnRow&& onRow, OnZeros&& onZeros) {
  constexpr size_t kRowsAtOnce = 64;
  const auto width = static_cast<size_t>(volume.grid().size.x);
  const auto height = static_cast<size_t>(volume.grid().size.y);
  if (areRowsKnownZero(volume, slice, 0, height)) {
    onZeros(height);
    return;
  }
  for (size_t begin = 0; begin < height; begin += kRowsAtOnce) {
    const size_t end = std::min(begin + kRowsAtOnce, height);
    if (areRowsKnownZero(volume, slice, begin, end)) {
      onZeros(end - begin);
      continue;
    }
    for (size_t j = begin; j < end; ++j) {
      onRow(j, first + (slice * height + j) * width);
    }
  }
}

}  // namespace ocelli
