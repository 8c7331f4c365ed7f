// Writes OpenEXR images.
#pragma once

#include <cstddef>
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

/// One file of so many images, which are not empty; they share one display window. Lossless compression.
std::string exrBytes(const std::vector<ExrPart>& parts);

}  // namespace ocelli
