// Voxels in a file, mapped: what is not touched is not read, and the holes of a sparse file never are.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <utility>
#include <vector>

#include "oc_core/base/mapped_file.h"
#include "oc_core/volume/scalar_volume.h"

namespace ocelli {

/// Whether a volume can stand on the bytes of a file as they are. Where not, they must be copied: processors and
/// compilers want numbers at multiples of their size.
inline bool areVoxelsAligned(uint64_t offset, VoxelType type) {
  return offset % bytesOf(type) == 0;
}

/// A file that is mapped, and what of it is no hole: what several volumes can stand on.
class MappedVoxelFile {
 public:
  using Extent = std::pair<uint64_t, uint64_t>;  ///< begin and end, bytes of the file

  /// Throws InputError where the file cannot be read. Once this is made the file may be unlinked.
  explicit MappedVoxelFile(std::filesystem::path path);

  const std::filesystem::path& path() const { return path_; }
  const MappedFile& file() const { return file_; }
  const std::vector<Extent>& data() const { return data_; }  ///< what is no hole, in order

 private:
  std::filesystem::path path_;
  MappedFile file_;
  std::vector<Extent> data_;
};

class MappedVoxels : public VoxelStore {
 public:
  /// Throws InputError where the file ends before the last voxel.
  MappedVoxels(std::shared_ptr<const MappedVoxelFile> file, uint64_t offset, uint64_t bytes);

  std::span<const std::byte> bytes() const override;
  bool isKnownZero(size_t begin, size_t end) const override;
  size_t bytesToRead() const override;
  void willRead(size_t begin, size_t end) const override;
  void release(size_t begin, size_t end) const override;

 private:
  std::shared_ptr<const MappedVoxelFile> file_;
  uint64_t offset_;
  uint64_t size_;
};

/// Volumes of one grid on one file, which is mapped once. The voxels of each begin at one of `begins`, bytes of the
/// file; they are as a volume has them in memory: uncompressed, in the byte order of this machine. Throws as
/// MappedVoxelFile and MappedVoxels do. The begins must be aligned.
std::vector<ScalarVolume> mapVolumes(const VolumeGrid& grid, VoxelType type, const std::filesystem::path& path,
                                     const std::vector<uint64_t>& begins, double scale = 1, double offset = 0);

}  // namespace ocelli
