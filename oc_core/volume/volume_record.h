// What `ocelli-read-volume` hands back: volumes whose voxels lie in a file, or why there are none. The reader of the
// record trusts nothing (base/record_bytes.h).
//
//   bytes "OCVOLUM1", u32 kind (0 volumes, 1 the input is wrong, 2 the work failed)
//   1, 2:    text, a whole error message
//   volumes: 3 i32 size, 16 f64 (columns of worldFromIndex), text unit, u8 anatomical, u32 type, f64 scale, f64 offset,
//            text file, u32 volumes, each u64 where its voxels begin, u32 times (0, or one a volume), each f64,
//            texts modality, value unit, format, u32 warnings, each a text
//   bytes "END."
//   text:    u32 bytes, then the bytes
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "oc_core/base/byte_sink.h"
#include "oc_core/volume/scalar_volume.h"

namespace ocelli {

/// Volumes of one grid, at one time or several.
struct VolumeRecord {
  /// Of one volume. Larger numbers are those of damaged files.
  static constexpr int kMaxEdge = 1 << 20;
  static constexpr uint32_t kMaxVolumes = 1 << 16;

  VolumeGrid grid;
  VoxelType type = VoxelType::kUint8;
  double scale = 1;              ///< what a voxel means is this times what it holds,
  double offset = 0;             ///< plus this
  std::string file;              ///< whose bytes are the voxels as volumes have them; empty: the scratch file
  std::vector<uint64_t> begins;  ///< where the voxels of each volume begin, in that file
  std::vector<double> times;     ///< of the volumes, in seconds, rising; or empty
  VolumeFacts facts;
  std::vector<std::string> warnings;  ///< what the user should know of, a sentence each

  /// Of one volume. The product of what is in range fits.
  uint64_t volumeBytes() const { return grid.voxelCount() * bytesOf(type); }
};

/// Writes what volumeFromRecord() reads.
void writeVolumeRecord(const VolumeRecord& record, const ByteSink& sink);
/// `message` as Error::what() gives it. `isInput`: the file is at fault (InputError), not this machine (WorkError).
void writeVolumeFailure(const std::string& message, bool isInput, const ByteSink& sink);

/// Throws InputError or WorkError with the message of a failure, and WorkError naming `writer` where the bytes are no
/// record: a size or an index out of range, a number that is not finite, a grid without volume, or bytes missing or
/// left over.
VolumeRecord volumeFromRecord(std::span<const std::byte> bytes, const std::string& writer);

}  // namespace ocelli
