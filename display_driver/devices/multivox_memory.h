// The shared memory that a multivox display shows, as its driver or simulator made it.
//
// It is a POSIX shared memory object that holds, one after the other and in the machine's byte order: page 0 and page 1
// (VoxelGrid::cells() bytes each), the page that is shown (uint8, 0 or 1), bits shown of each channel (uint8), flags
// (uint16), revolutions per minute (uint16) and microseconds per frame (uint16). Who has something to show writes the
// page that is not shown, then the number of the page. Nobody locks anything.
//
// How a page stays whole. Readers take the number of the page, then read from that page. So after a page was changed
// for the other, readers may still be reading it; it gets a rest of 20 ms, or of twice the microseconds per frame where
// that is longer, before it is written again. A page of a megabyte is read in about a millisecond; the rest is for
// readers that lose the CPU meanwhile. A reader that takes longer than the rest to read one page may get parts of
// two frames: the format has no way to know. It follows that at most 50 frames a second are shown, more than twice as
// many as a screen of 600 rpm refreshes.
//
// Why pwrite() and not a mapping: where another program makes the object shorter, writing to a mapping ends the writer
// (SIGBUS). A write to a descriptor only makes the object longer again, and not even that happens as long as the size
// is looked at before each part of 64 KiB, except in the microseconds between.
//
// Nothing of ours is left in the system, whenever the writer is killed: it makes no object, takes no lock, and a page
// is shown only when it is whole.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "display_driver/devices/multivox_target.h"
#include "display_driver/devices/voxel_grid.h"

namespace ocelli {

class MultivoxMemory final : public MultivoxTarget {
 public:
  /// Opens nothing yet. `object` is a name for shm_open(): "/vortex_double_buffer".
  MultivoxMemory(std::string object, const VoxelGrid& grid);
  ~MultivoxMemory() override;
  MultivoxMemory(const MultivoxMemory&) = delete;
  MultivoxMemory& operator=(const MultivoxMemory&) = delete;

  std::string name() const override { return object_.substr(1); }
  std::string link() const override { return "shared memory " + object_; }
  /// Looks for the object by its name, takes the one that has it now, and checks its size.
  Found look() override;

  std::optional<MultivoxStatus> status() const override;
  /// Into the page that is not shown, which must have rested.
  bool write(std::span<const uint8_t> cells) override;
  /// Shows the page that was written last.
  bool show() override;
  Clock::time_point rested() const override { return rested_; }
  size_t frameBytes() const override { return grid_.cells(); }
  uint64_t bytesSent() const override { return bytesSent_; }

  const std::string& problem() const override { return problem_; }
  const std::string& object() const { return object_; }

 private:
  bool sizeIsRight();
  bool writeAt(size_t offset, std::span<const uint8_t> bytes);
  void rest();
  Found lose(std::string problem);

  std::string object_;
  VoxelGrid grid_;
  int descriptor_ = -1;
  uint64_t device_ = 0;  ///< with inode_: which object the descriptor is of
  uint64_t inode_ = 0;
  int written_ = 0;           ///< the page that write() filled last
  std::optional<int> shown_;  ///< the page that show() showed last
  Clock::time_point rested_;
  uint64_t bytesSent_ = 0;
  std::string problem_;
};

/// Bytes of the object.
size_t multivoxBytes(const VoxelGrid& grid);

}  // namespace ocelli
