// Voxels in a file, mapped: what is not touched is not read, and the holes of a sparse file never are.
#pragma once

#include <cstdint>
#include <filesystem>
#include <utility>
#include <vector>

#include "oc_core/base/mapped_file.h"
#include "oc_core/volume/scalar_volume.h"

namespace ocelli {

/// Bytes of a file that are voxels as a volume has them in memory: uncompressed, in the byte order of this machine.
struct VoxelFile {
  std::filesystem::path path;
  uint64_t offset = 0;  ///< of the first voxel, from the begin of the file: a multiple of the bytes of a voxel
  uint64_t bytes = 0;   ///< of all voxels
};

/// Whether a volume can stand on the bytes of a file as they are. Where not, they must be copied: processors and
/// compilers want numbers at multiples of their size.
inline bool areVoxelsAligned(uint64_t offset, VoxelType type) {
  return offset % bytesOf(type) == 0;
}

class MappedVoxels : public VoxelStore {
 public:
  /// Throws InputError where the file cannot be read, or ends before the last voxel. Once this is made the file may be
  /// unlinked.
  explicit MappedVoxels(const VoxelFile& file);

  std::span<const std::byte> bytes() const override;
  bool isKnownZero(size_t begin, size_t end) const override;
  size_t bytesToRead() const override;
  void willRead(size_t begin, size_t end) const override;
  void release(size_t begin, size_t end) const override;

 private:
  using Extent = std::pair<uint64_t, uint64_t>;  ///< begin and end, bytes of the file

  MappedFile file_;
  uint64_t offset_;
  uint64_t size_;
  std::vector<Extent> data_;  ///< what is no hole, in order
};

/// A volume on a file. Throws as MappedVoxels does. The offset must be aligned, and the bytes those of the grid.
ScalarVolume mapVolume(const VolumeGrid& grid, VoxelType type, const VoxelFile& file, double scale = 1,
                       double offset = 0);

}  // namespace ocelli
