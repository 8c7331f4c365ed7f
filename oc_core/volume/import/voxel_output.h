// Where the voxels of a record come to lie: in the file that holds them, where volumes can stand on its bytes as they
// are; else, made such, in the scratch file.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string_view>
#include <vector>

#include "oc_core/base/reading_budget.h"
#include "oc_core/volume/import/byte_source.h"
#include "oc_core/volume/volume_record.h"

namespace ocelli {

/// Numbers in files. Those that volumes have not become float64.
enum class StoredType { kUint8, kInt8, kUint16, kInt16, kUint32, kInt32, kFloat32, kFloat64, kUint64, kInt64 };

size_t bytesOf(StoredType type);
VoxelType voxelTypeOf(StoredType type);

/// Bytes that hold the voxels of all volumes of a record, one after the other.
struct StoredVoxels {
  StoredType type = StoredType::kUint8;
  bool isSwapped = false;   ///< the other byte order than this machine's
  uint64_t offset = 0;      ///< of the first one in the source
  bool isDeflated = false;  ///< by zlib or gzip, from `offset` on
  uint64_t skip = 0;        ///< of what is inflated, before the first voxel
};

/// The scratch file.
class ScratchOutput {
 public:
  /// An empty path: what is written goes nowhere, but is counted. `folder` is named where the disk is full. `budget`
  /// may be null.
  ScratchOutput(const std::filesystem::path& path, std::filesystem::path folder, ReadingBudget* budget);
  ~ScratchOutput();
  ScratchOutput(const ScratchOutput&) = delete;
  ScratchOutput& operator=(const ScratchOutput&) = delete;

  /// So many bytes will be written at most, all but `holeBytes` of them onto the disk. Throws WorkError where that has
  /// no room for them.
  void expect(uint64_t bytes, uint64_t holeBytes = 0);
  /// Throws WorkError where the disk is full.
  void write(std::span<const std::byte> bytes);
  /// Zeros, as a hole.
  void skip(uint64_t bytes);
  uint64_t size() const { return size_; }

 private:
  [[noreturn]] void fail(int reason) const;

  std::filesystem::path folder_;
  ReadingBudget* budget_;
  int file_ = -1;
  uint64_t size_ = 0;
};

/// Writes the voxels of a record that come piece by piece, whatever the pieces. The record's grid stands; its type and
/// where its volumes begin are set.
class VoxelWriter {
 public:
  VoxelWriter(VolumeRecord& record, uint64_t volumes, StoredType type, bool isSwapped, ScratchOutput& scratch);

  /// Bytes as they are stored. More than all are a bug. Throws InputError, naming `where`, for a 64-bit number that
  /// float64 has not.
  void append(std::span<const std::byte> bytes, const std::string& where);
  /// As many zeros.
  void skip(uint64_t bytes);
  uint64_t missingBytes() const { return missing_; }  ///< as they are stored
  /// Throws InputError, naming `where`, where bytes are missing.
  void finish(const std::string& where) const;

 private:
  void writeWhole(std::span<const std::byte> bytes, const std::string& where);

  StoredType type_;
  bool isSwapped_;
  uint64_t all_;      ///< bytes, as they are stored
  uint64_t missing_;  ///< of them
  ScratchOutput& scratch_;
  std::vector<std::byte> partial_;  ///< the begin of a number
  std::vector<std::byte> made_;
};

/// Sets the record's type, its file, and where its volumes begin; its grid stands. `path` is that of the source. Throws
/// InputError where the source has fewer bytes than its header says, WorkError where the disk is full.
void placeVoxels(VolumeRecord& record, uint64_t volumes, const StoredVoxels& stored, const ByteSource& source,
                 const std::string& path, ScratchOutput& scratch);

/// Throws InputError where a size or a number of volumes, of a header, is out of range.
void checkVolumeSize(const glm::dvec3& size, double volumes, const std::string& where);

}  // namespace ocelli
