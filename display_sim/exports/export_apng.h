// An animated PNG file (wiki.mozilla.org/APNG_Specification): browsers and image viewers play it, and any PNG reader
// shows its first image.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string_view>
#include <vector>

#include "oc_core/base/output_file.h"
#include "oc_core/image/image.h"
#include "oc_core/image/png_file.h"

namespace ocelli {

class ApngWriter {
 public:
  /// For so many images of this size, at least one; they are played over and over. The file appears with finish().
  /// Throws WorkError.
  ApngWriter(const std::filesystem::path& path, int width, int height, uint32_t images);

  /// Shown for so many milliseconds, up to 65535.
  void add(const Image<Rgb8>& image, uint16_t milliseconds);
  void finish();

 private:
  void chunk(std::string_view type, std::span<const uint8_t> data);

  OutputFile file_;
  int width_;
  int height_;
  uint32_t images_;
  uint32_t added_ = 0;
  uint32_t sequence_ = 0;  ///< of frame control and frame data chunks
};

}  // namespace ocelli
