// What an animated PNG file holds, read without the code that wrote it.
#pragma once

#include <gtest/gtest.h>
#include <zlib.h>

#include <cstdint>
#include <cstdlib>
#include <string>
#include <vector>

#include "oc_core/image/image.h"
#include "oc_core/image/png_file.h"

namespace ocelli::test {

struct AnimatedPng {
  std::vector<Image<Rgb8>> images;
  std::vector<int> milliseconds;
};

/// Undoes the PNG filters of rows of RGB pixels.
inline Image<Rgb8> unfiltered(const std::vector<uint8_t>& rows, int width, int height) {
  Image<Rgb8> image(width, height, Rgb8(0));
  const uint8_t* at = rows.data();
  for (int y = 0; y < height; ++y) {
    const int filter = *at++;
    for (int x = 0; x < width; ++x) {
      for (int c = 0; c < 3; ++c) {
        const int a = x > 0 ? image(x - 1, y)[c] : 0;
        const int b = y > 0 ? image(x, y - 1)[c] : 0;
        const int ab = x > 0 && y > 0 ? image(x - 1, y - 1)[c] : 0;
        int guess = 0;
        if (filter == 1) {
          guess = a;
        } else if (filter == 2) {
          guess = b;
        } else if (filter == 3) {
          guess = (a + b) / 2;
        } else if (filter == 4) {
          const int da = std::abs(b - ab);
          const int db = std::abs(a - ab);
          const int dab = std::abs(a + b - 2 * ab);
          guess = da <= db && da <= dab ? a : db <= dab ? b : ab;
        }
        image(x, y)[c] = static_cast<uint8_t>(*at++ + guess);
      }
    }
  }
  return image;
}

/// Fails the test for a wrong checksum, order or size.
inline AnimatedPng readAnimatedPng(const std::string& file) {
  const auto* bytes = reinterpret_cast<const uint8_t*>(file.data());
  const auto u32 = [](const uint8_t* at) {
    return uint32_t{at[0]} << 24 | uint32_t{at[1]} << 16 | uint32_t{at[2]} << 8 | at[3];
  };
  AnimatedPng animation;
  EXPECT_TRUE(file.starts_with("\x89PNG\r\n\x1a\n"));
  int width = 0;
  int height = 0;
  uint32_t announced = 0;
  uint32_t sequence = 0;
  std::string last;
  for (size_t at = 8; at + 12 <= file.size();) {
    const size_t size = u32(bytes + at);
    const std::string type = file.substr(at + 4, 4);
    const uint8_t* data = bytes + at + 8;
    EXPECT_EQ(u32(data + size), crc32(0, bytes + at + 4, static_cast<uInt>(size + 4))) << type;
    if (type == "IHDR") {
      width = static_cast<int>(u32(data));
      height = static_cast<int>(u32(data + 4));
    } else if (type == "acTL") {
      announced = u32(data);
    } else if (type == "fcTL") {
      EXPECT_EQ(u32(data), sequence++);
      EXPECT_EQ(data[22] << 8 | data[23], 1000);
      animation.milliseconds.push_back(data[20] << 8 | data[21]);
    } else if (type == "IDAT" || type == "fdAT") {
      const size_t skipped = type == "IDAT" ? 0 : 4;
      if (skipped > 0) {
        EXPECT_EQ(u32(data), sequence++);
      }
      std::vector<uint8_t> rows(static_cast<size_t>(height) * (1 + 3 * static_cast<size_t>(width)));
      uLongf length = rows.size();
      EXPECT_EQ(uncompress(rows.data(), &length, data + skipped, size - skipped), Z_OK);
      EXPECT_EQ(length, rows.size());
      animation.images.push_back(unfiltered(rows, width, height));
    }
    last = type;
    at += 12 + size;
  }
  EXPECT_EQ(last, "IEND");
  EXPECT_EQ(announced, animation.images.size());
  EXPECT_EQ(announced, animation.milliseconds.size());
  return animation;
}

}  // namespace ocelli::test
