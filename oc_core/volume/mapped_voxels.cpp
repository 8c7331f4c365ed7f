#include "oc_core/volume/mapped_voxels.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <memory>
#include <string>

#include "oc_core/base/check.h"
#include "oc_core/base/error.h"

namespace ocelli {
namespace {

/// A file in more pieces than this counts as one without holes from there on.
constexpr size_t kMaxExtents = 1 << 20;

/// What of a file is no hole, in order. One piece where the system cannot tell.
std::vector<std::pair<uint64_t, uint64_t>> dataExtents(const std::filesystem::path& path, uint64_t size) {
  std::vector<std::pair<uint64_t, uint64_t>> extents;
  const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (file < 0) {
    return {{0, size}};
  }
  uint64_t at = 0;
  while (at < size) {
    const off_t data = ::lseek(file, static_cast<off_t>(at), SEEK_DATA);
    if (data < 0) {
      // ENXIO: nothing but a hole is left.
      if (errno != ENXIO) {
        extents.emplace_back(at, size);
      }
      break;
    }
    const off_t hole = extents.size() < kMaxExtents ? ::lseek(file, data, SEEK_HOLE) : -1;
    const uint64_t end = hole > data ? static_cast<uint64_t>(hole) : size;
    extents.emplace_back(static_cast<uint64_t>(data), end);
    at = end;
  }
  ::close(file);
  return extents;
}

}  // namespace

MappedVoxelFile::MappedVoxelFile(std::filesystem::path path)
    : path_(std::move(path)), file_(path_), data_(dataExtents(path_, file_.bytes().size())) {}

MappedVoxels::MappedVoxels(std::shared_ptr<const MappedVoxelFile> file, uint64_t offset, uint64_t bytes)
    : file_(std::move(file)), offset_(offset), size_(bytes) {
  const uint64_t has = file_->file().bytes().size();
  if (offset_ > has || size_ > has - offset_) {
    throw InputError("the file ends before its last voxel: " + std::to_string(size_) + " bytes of voxels from byte " +
                         std::to_string(offset_) + " on are not in the " + std::to_string(has) + " that it has",
                     file_->path().string(), "copy it again, or correct the sizes in its header");
  }
}

std::span<const std::byte> MappedVoxels::bytes() const {
  return std::as_bytes(file_->file().bytes()).subspan(offset_, size_);
}

bool MappedVoxels::isKnownZero(size_t begin, size_t end) const {
  const std::vector<MappedVoxelFile::Extent>& data = file_->data();
  const auto next = std::ranges::upper_bound(data, offset_ + begin, {}, &MappedVoxelFile::Extent::second);
  return next == data.end() || next->first >= offset_ + end;
}

size_t MappedVoxels::bytesToRead() const {
  uint64_t sum = 0;
  for (const auto& [begin, end] : file_->data()) {
    const uint64_t from = std::max(begin, offset_);
    const uint64_t to = std::min(end, offset_ + size_);
    sum += to > from ? to - from : 0;
  }
  return sum;
}

void MappedVoxels::willRead(size_t begin, size_t end) const {
  file_->file().willNeed(offset_ + begin, offset_ + end);
}

void MappedVoxels::release(size_t begin, size_t end) const {
  file_->file().release(offset_ + begin, offset_ + end);
}

std::vector<ScalarVolume> mapVolumes(const VolumeGrid& grid, VoxelType type, const std::filesystem::path& path,
                                     const std::vector<uint64_t>& begins, double scale, double offset) {
  const auto file = std::make_shared<const MappedVoxelFile>(path);
  std::vector<ScalarVolume> volumes;
  for (const uint64_t begin : begins) {
    OC_CHECK(areVoxelsAligned(begin, type), "voxels that are mapped lie at multiples of their size");
    volumes.emplace_back(grid, type,
                         std::make_shared<const MappedVoxels>(file, begin, grid.voxelCount() * bytesOf(type)), scale,
                         offset);
  }
  return volumes;
}

}  // namespace ocelli
