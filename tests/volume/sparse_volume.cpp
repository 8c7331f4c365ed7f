#include "tests/volume/sparse_volume.h"

#include <sys/stat.h>

#include <fstream>
#include <vector>

namespace ocelli::test {
namespace {

uint64_t sliceBytesOf(const glm::ivec3& size) {
  return uint64_t(size.x) * uint64_t(size.y) * sizeof(int16_t);
}

}  // namespace

SparseVolume::SparseVolume(const std::filesystem::path& folder, const glm::ivec3& size, int first, int last)
    : size_(size), path_(folder / "sparse.raw") {
  std::ofstream(path_).close();
  std::filesystem::resize_file(path_, sliceBytesOf(size) * uint64_t(size.z));
  std::fstream file(path_, std::ios::in | std::ios::out | std::ios::binary);
  const std::vector<int16_t> slice(size_t(size.x) * size_t(size.y), kSlabValue);
  file.seekp(static_cast<std::streamoff>(sliceBytesOf(size) * uint64_t(first)));
  for (int k = first; k < last; ++k) {
    file.write(reinterpret_cast<const char*>(slice.data()), static_cast<std::streamsize>(sliceBytesOf(size)));
  }
}

bool SparseVolume::isSparse() const {
  struct stat info {};
  constexpr uint64_t kBytesOfBlock = 512;
  return ::stat(path_.c_str(), &info) == 0 &&
         uint64_t(info.st_blocks) * kBytesOfBlock < sliceBytesOf(size_) * uint64_t(size_.z) / 2;
}

ScalarVolume SparseVolume::map() const {
  VolumeGrid grid;
  grid.size = size_;
  return mapVolumes(grid, VoxelType::kInt16, path_, {0}).front();
}

}  // namespace ocelli::test
