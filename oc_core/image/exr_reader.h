// Reads OpenEXR images from memory: the headers first, so that a caller can judge them before there are buffers for
// what they promise.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "oc_core/image/exr_writer.h"

namespace ocelli {

/// The most that deflate can do: no image has more bytes than so many times its file's.
inline constexpr int64_t kMaxExrCompression = 1032;

struct ExrChannelHeader {
  std::string name;
  bool isFloat = false;   ///< of 32 bits
  bool fullSize = false;  ///< a value for each pixel
};

struct ExrPartHeader {
  int64_t left = 0;  ///< of the data window, which may begin anywhere
  int64_t top = 0;
  int64_t width = 0;  ///< 0 or less in files that are wrong
  int64_t height = 0;
  std::vector<ExrChannelHeader> channels = {};
  std::optional<std::string> description = {};  ///< the text attribute "ocelli"

  const ExrChannelHeader* find(std::string_view channel) const;
};

/// Of each part. Throws an std::exception, which says what is wrong, where the bytes are no EXR file, or one of more
/// parts.
std::vector<ExrPartHeader> exrHeaders(std::string_view bytes, size_t maxParts);

class ExrReader {
 public:
  /// The bytes must outlive it. Throws what OpenEXR throws (an std::exception).
  explicit ExrReader(std::string_view bytes);
  ~ExrReader();
  ExrReader(const ExrReader&) = delete;
  ExrReader& operator=(const ExrReader&) = delete;

  /// Fills the places that the channels name, which must have room for the data window of the part. Throws what OpenEXR
  /// throws.
  void read(size_t part, const ExrPartHeader& header, const std::vector<ExrChannel>& channels);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace ocelli
