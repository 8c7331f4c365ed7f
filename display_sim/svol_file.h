// `.svol`: a volume in a file. Versioned, checksummed, compressed slice by slice; docs/svol.md specifies every byte.
#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <istream>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "display_sim/display_profile.h"
#include "display_sim/volume.h"
#include "oc_core/base/output_file.h"

namespace ocelli {

/// Writes slice after slice; the file appears under its name with finish(). The same slices give the same bytes (as
/// long as the version of zstd is the same). Throws WorkError.
class SvolWriter {
 public:
  SvolWriter(std::filesystem::path path, const DisplayProfile& profile);

  /// The bit planes of the next slice, in the layout of volume.h.
  void add(std::span<const uint8_t> planes);
  /// The same, compressed before by compressPlanes().
  void addCompressed(std::span<const uint8_t> compressed);
  /// Call after the last slice.
  void finish();

 private:
  VolumeLayout layout_;
  OutputFile file_;
  uint32_t next_ = 0;
};

/// The payload of a slice record; may run in several threads at once.
std::vector<uint8_t> compressPlanes(std::span<const uint8_t> planes);

/// Reads slice after slice and trusts nothing: a wrong magic, version, size, checksum, order or padding, an end too
/// soon or too late is an InputError that names file, slice and problem.
class SvolReader {
 public:
  explicit SvolReader(const std::filesystem::path& path);
  /// From a seekable stream that outlives the reader; `where` names it in errors.
  SvolReader(std::istream& in, std::string where);

  const DisplayProfile& profile() const { return profile_; }
  const VolumeLayout& layout() const { return layout_; }
  bool atEnd() const { return next_ == layout_.slices; }
  /// Fills the bit planes of the next slice: layout().sliceBytes bytes. After the last one it also checks that the file
  /// ends there.
  void readSlice(std::span<uint8_t> planes);

 private:
  void readHeader();
  void readExactly(std::span<uint8_t> bytes);
  uint64_t bytesLeft();
  [[noreturn]] void fail(const std::string& what) const;

  std::ifstream file_;
  std::istream& in_;
  std::string where_;
  DisplayProfile profile_;
  VolumeLayout layout_{profile_};
  uint32_t next_ = 0;
  bool inSlice_ = false;
  std::vector<uint8_t> payload_;
};

/// Throws WorkError.
void writeSvol(const std::filesystem::path& path, const Volume& volume);
/// Throws InputError.
Volume readSvol(const std::filesystem::path& path);
Volume readSvol(std::istream& in, const std::string& where);

struct SvolSummary {
  DisplayProfile profile;
  uint64_t fileBytes = 0;
  uint64_t planeBytesTotal = 0;  ///< uncompressed
  uint64_t litVoxels = 0;
};

/// Reads every slice, keeping none. Throws InputError for the first thing that is wrong.
SvolSummary verifySvol(const std::filesystem::path& path);

}  // namespace ocelli
