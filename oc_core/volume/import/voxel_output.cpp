#include "oc_core/volume/import/voxel_output.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <system_error>

#include "oc_core/base/check.h"
#include "oc_core/base/error.h"
#include "oc_core/volume/import/inflate.h"
#include "oc_core/volume/mapped_voxels.h"

namespace ocelli {
namespace {

constexpr size_t kCopiedPiece = 1 << 18;
constexpr double kGibibyteOfVoxels = 1 << 30;

struct StoredTypeRow {
  size_t bytes;
  VoxelType voxel;
};

constexpr std::array<StoredTypeRow, 10> kStoredTypes{{{1, VoxelType::kUint8},
                                                      {1, VoxelType::kInt8},
                                                      {2, VoxelType::kUint16},
                                                      {2, VoxelType::kInt16},
                                                      {4, VoxelType::kUint32},
                                                      {4, VoxelType::kInt32},
                                                      {4, VoxelType::kFloat32},
                                                      {8, VoxelType::kFloat64},
                                                      {8, VoxelType::kFloat64},
                                                      {8, VoxelType::kFloat64}}};

bool isConverted(StoredType type) {
  return type == StoredType::kUint64 || type == StoredType::kInt64;
}

void swapBytes(std::span<std::byte> bytes, size_t size) {
  for (size_t at = 0; size > 1 && at + size <= bytes.size(); at += size) {
    std::reverse(bytes.begin() + static_cast<ptrdiff_t>(at), bytes.begin() + static_cast<ptrdiff_t>(at + size));
  }
}

template <class Integer>
void toDoubles(std::span<std::byte> bytes, const std::string& where) {
  for (size_t at = 0; at + sizeof(Integer) <= bytes.size(); at += sizeof(Integer)) {
    Integer integer = 0;
    std::memcpy(&integer, bytes.data() + at, sizeof(Integer));
    constexpr auto kExact = static_cast<Integer>(int64_t{1} << 53U);
    bool isExact = integer <= kExact;
    if constexpr (std::is_signed_v<Integer>) {
      isExact = isExact && integer >= -kExact;
    }
    if (!isExact) {
      throw InputError(fmt::format("a voxel of 64 bits is {}, which no float64 is for sure", integer), where,
                       "convert the voxels to float or to integers of 32 bits");
    }
    const auto number = static_cast<double>(integer);
    std::memcpy(bytes.data() + at, &number, sizeof(number));
  }
}

[[noreturn]] void failMissing(uint64_t missing, uint64_t all, const std::string& where) {
  throw InputError(
      fmt::format("the file has {} bytes of voxels, {} fewer than its header says", all - missing, missing), where,
      "copy or export the file again");
}

}  // namespace

size_t bytesOf(StoredType type) {
  return kStoredTypes[static_cast<size_t>(type)].bytes;
}
VoxelType voxelTypeOf(StoredType type) {
  return kStoredTypes[static_cast<size_t>(type)].voxel;
}

ScratchOutput::ScratchOutput(const std::filesystem::path& path, std::filesystem::path folder, ReadingBudget* budget)
    : folder_(std::move(folder)), budget_(budget) {
  if (!path.empty()) {
    file_ = ::open(path.c_str(), O_WRONLY | O_CLOEXEC);
    if (file_ < 0) {
      fail(errno);
    }
  }
}

ScratchOutput::~ScratchOutput() {
  if (file_ >= 0) {
    ::close(file_);
  }
}

void ScratchOutput::fail(int reason) const {
  throw WorkError(
      "the voxels of this file must be unpacked here, which failed: " + std::generic_category().message(reason),
      folder_.string(),
      "free some space, let the environment variable TMPDIR name a folder on a larger disk, or convert the "
      "file to NRRD without compression");
}

void ScratchOutput::expect(uint64_t bytes, uint64_t holeBytes) {
  if (file_ < 0) {
    return;
  }
  std::error_code ignored;
  const std::filesystem::space_info space = std::filesystem::space(folder_, ignored);
  if (!ignored && space.available < bytes - std::min(bytes, holeBytes)) {
    fail(ENOSPC);
  }
  if (budget_ != nullptr) {
    budget_->addWriting(bytes);
  }
}

void ScratchOutput::write(std::span<const std::byte> bytes) {
  while (file_ >= 0 && !bytes.empty()) {
    const ssize_t some = ::pwrite(file_, bytes.data(), bytes.size(), static_cast<off_t>(size_));
    if (some == 0 || (some < 0 && errno != EINTR)) {
      fail(some == 0 ? ENOSPC : errno);
    }
    const size_t count = some > 0 ? static_cast<size_t>(some) : 0;
    bytes = bytes.subspan(count);
    size_ += count;
  }
  size_ += bytes.size();
}

void ScratchOutput::skip(uint64_t bytes) {
  if (file_ >= 0 && ::ftruncate(file_, static_cast<off_t>(size_ + bytes)) != 0) {
    fail(errno);
  }
  size_ += bytes;
}

VoxelWriter::VoxelWriter(VolumeRecord& record, uint64_t volumes, StoredType type, bool isSwapped,
                         ScratchOutput& scratch)
    : type_(type), isSwapped_(isSwapped), scratch_(scratch) {
  record.type = voxelTypeOf(type);
  record.file.clear();
  record.begins.clear();
  // Scratch files hold one record.
  OC_CHECK(scratch.size() == 0, "a scratch file is written once");
  for (uint64_t at = 0; at < volumes; ++at) {
    record.begins.push_back(at * record.volumeBytes());
  }
  all_ = missing_ = volumes * record.grid.voxelCount() * bytesOf(type);
}

void VoxelWriter::append(std::span<const std::byte> bytes, const std::string& where) {
  OC_CHECK(bytes.size() <= missing_, "no more voxels are written than there are");
  missing_ -= bytes.size();
  const size_t size = bytesOf(type_);
  if (!partial_.empty()) {
    const size_t taken = std::min(size - partial_.size(), bytes.size());
    partial_.insert(partial_.end(), bytes.begin(), bytes.begin() + static_cast<ptrdiff_t>(taken));
    bytes = bytes.subspan(taken);
    if (partial_.size() < size) {
      return;
    }
    const std::vector<std::byte> whole = std::move(partial_);
    partial_.clear();
    writeWhole(whole, where);
  }
  const size_t whole = bytes.size() / size * size;
  writeWhole(bytes.first(whole), where);
  partial_.assign(bytes.begin() + static_cast<ptrdiff_t>(whole), bytes.end());
}

void VoxelWriter::writeWhole(std::span<const std::byte> bytes, const std::string& where) {
  if (!isSwapped_ && !isConverted(type_)) {
    scratch_.write(bytes);
    return;
  }
  made_.assign(bytes.begin(), bytes.end());
  if (isSwapped_) {
    swapBytes(made_, bytesOf(type_));
  }
  if (type_ == StoredType::kInt64) {
    toDoubles<int64_t>(made_, where);
  } else if (type_ == StoredType::kUint64) {
    toDoubles<uint64_t>(made_, where);
  }
  scratch_.write(made_);
}

void VoxelWriter::skip(uint64_t bytes) {
  OC_CHECK(bytes <= missing_ && partial_.empty() && bytes % bytesOf(type_) == 0, "whole voxels are skipped");
  missing_ -= bytes;
  scratch_.skip(bytes / bytesOf(type_) * bytesOf(voxelTypeOf(type_)));
}

void VoxelWriter::finish(const std::string& where) const {
  if (missing_ > 0) {
    failMissing(missing_, all_, where);
  }
}

namespace {

/// Whole voxels at a time, so that holes can be skipped.
void copyRaw(const StoredVoxels& stored, const ByteSource& source, VoxelWriter& writer) {
  std::vector<std::byte> piece(kCopiedPiece);
  uint64_t at = stored.offset;
  while (writer.missingBytes() > 0) {
    const uint64_t hole = std::min(source.skipHole(at) - at, writer.missingBytes()) / sizeof(double) * sizeof(double);
    if (hole >= kCopiedPiece) {
      writer.skip(hole);
      at += hole;
      continue;
    }
    const auto count = static_cast<size_t>(std::min<uint64_t>(piece.size(), writer.missingBytes()));
    source.read(at, std::span(piece).first(count));
    writer.append(std::span(piece).first(count), source.name());
    at += count;
  }
}

void copyDeflated(const StoredVoxels& stored, const ByteSource& source, VoxelWriter& writer) {
  std::vector<std::byte> piece(kCopiedPiece);
  uint64_t at = std::min(stored.offset, source.size());
  const ByteFeed feed = [&]() -> std::span<const std::byte> {
    const auto count = static_cast<size_t>(std::min<uint64_t>(piece.size(), source.size() - at));
    source.read(at, std::span(piece).first(count));
    at += count;
    return std::span(piece).first(count);
  };
  uint64_t skip = stored.skip;
  inflateBytes(feed, skip + writer.missingBytes(), source.name(), [&](std::span<const std::byte> bytes) {
    const auto skipped = static_cast<size_t>(std::min<uint64_t>(skip, bytes.size()));
    skip -= skipped;
    writer.append(bytes.subspan(skipped), source.name());
  });
}

/// zlib makes at most this many bytes of one.
constexpr uint64_t kMaxInflation = 1032;

}  // namespace

void placeVoxels(VolumeRecord& record, uint64_t volumes, const StoredVoxels& stored, const ByteSource& source,
                 const std::string& path, ScratchOutput& scratch) {
  const uint64_t volumeBytes = record.grid.voxelCount() * bytesOf(stored.type);
  const uint64_t bytes = volumes * volumeBytes;
  const uint64_t there = source.size() - std::min(stored.offset, source.size());
  if (!stored.isDeflated && there < bytes) {
    failMissing(bytes - there, bytes, source.name());
  }
  if (stored.isDeflated && bytes / kMaxInflation > there) {
    throw InputError(
        fmt::format("the header says {} bytes of voxels, far more than {} compressed bytes can hold", bytes, there),
        source.name(), "copy or export the file again");
  }
  record.type = voxelTypeOf(stored.type);
  const bool isAsItMustBe =
      !stored.isDeflated && !isConverted(stored.type) && (!stored.isSwapped || bytesOf(stored.type) == 1);
  if (isAsItMustBe && areVoxelsAligned(stored.offset, record.type)) {
    record.file = path;
    record.begins.clear();
    for (uint64_t at = 0; at < volumes; ++at) {
      record.begins.push_back(stored.offset + at * volumeBytes);
    }
    return;
  }
  if (isAsItMustBe && static_cast<double>(std::min(bytes, source.storedBytes())) > kGibibyteOfVoxels) {
    record.warnings.push_back(
        fmt::format("the {:.1f} GiB of voxels are copied first, as they begin at byte {} of their file, which is no "
                    "multiple of the "
                    "{} bytes of a voxel; in a file of their own they would be read from there",
                    static_cast<double>(bytes) / kGibibyteOfVoxels, stored.offset, bytesOf(stored.type)));
  }
  scratch.expect(volumes * record.volumeBytes(), stored.isDeflated ? 0 : source.size() - source.storedBytes());
  VoxelWriter writer(record, volumes, stored.type, stored.isSwapped, scratch);
  if (stored.isDeflated) {
    copyDeflated(stored, source, writer);
  } else {
    copyRaw(stored, source, writer);
  }
  writer.finish(source.name());
}

void checkVolumeSize(const glm::dvec3& size, double volumes, const std::string& where) {
  for (int axis = 0; axis < 3; ++axis) {
    if (!(size[axis] >= 1 && size[axis] <= VolumeRecord::kMaxEdge)) {
      throw InputError(fmt::format("a volume of {} x {} x {} voxels", size.x, size.y, size.z), where,
                       fmt::format("give 1 to {} voxels along each axis", VolumeRecord::kMaxEdge));
    }
  }
  if (!(volumes >= 1 && volumes <= VolumeRecord::kMaxVolumes)) {
    throw InputError(fmt::format("a series of {} volumes", volumes), where,
                     fmt::format("give 1 to {} of them", VolumeRecord::kMaxVolumes));
  }
  constexpr double kMaxBytes = 4e18;  // more is no size of a file
  if (size.x * size.y * size.z * volumes * sizeof(double) > kMaxBytes) {
    throw InputError(
        fmt::format("{} volumes of {} x {} x {} voxels are larger than any file", volumes, size.x, size.y, size.z),
        where, "the header is damaged: copy or export the file again");
  }
}

}  // namespace ocelli
