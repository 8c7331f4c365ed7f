// Writes OpenEXR images, to memory: file_bytes.h puts them into files.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace ocelli {

/// One number a pixel: a float, or a whole number of 32 bits.
struct ExrChannel {
  const char* name;
  const void* first;  ///< the value of the first pixel; rows follow each other
  size_t stride;      ///< bytes from one pixel to the next
  bool isWhole = false;
};

struct ExrPart {
  std::string name;
  int width = 0;
  int height = 0;
  std::vector<ExrChannel> channels;
  std::string description;  ///< the text attribute "ocelli"
};

inline constexpr const char* kExrDescription = "ocelli";

/// One file of so many images, one at least, with names of their own; they share one display window. Lossless
/// compression. Aborts where there is no image, or one without pixels: that is a bug of the caller. Throws what OpenEXR
/// throws (an std::exception) where two parts have one name. `fill` is called before each part is written: parts may
/// share the memory that it fills, so that a file of many parts takes that of one.
std::string exrBytes(const std::vector<ExrPart>& parts, const std::function<void(size_t part)>& fill = {});

}  // namespace ocelli
