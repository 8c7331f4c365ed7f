// Where voxels come from that need not be in memory: a mapped file, of which what was read can be given back.
#pragma once

#include <cstddef>
#include <span>

namespace ocelli {

/// Any thread may call any function at any time, and read the bytes.
class VoxelStore {
 public:
  VoxelStore() = default;
  virtual ~VoxelStore() = default;
  VoxelStore(const VoxelStore&) = delete;
  VoxelStore& operator=(const VoxelStore&) = delete;

  /// All of them. What is touched comes into memory, and stays there until it is released.
  virtual std::span<const std::byte> bytes() const = 0;
  /// Whether the bytes in [begin, end) are known to be zero without being read: the holes of sparse files.
  virtual bool isKnownZero(size_t begin, size_t end) const = 0;
  /// How many bytes are not known to be zero: what reading all of them reads.
  virtual size_t bytesToRead() const = 0;
  /// Reads these bytes ahead.
  virtual void willRead(size_t begin, size_t end) const = 0;
  /// Gives the memory of these bytes back. They can be read again.
  virtual void release(size_t begin, size_t end) const = 0;
};

}  // namespace ocelli
