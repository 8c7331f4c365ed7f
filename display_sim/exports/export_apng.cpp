#include "display_sim/exports/export_apng.h"

#include <zlib.h>

#include <algorithm>
#include <cstdlib>

#include "oc_core/base/check.h"

namespace ocelli {
namespace {

constexpr int kPixelBytes = 3;

void append16(std::vector<uint8_t>& bytes, uint32_t value) {
  bytes.push_back(static_cast<uint8_t>(value >> 8));
  bytes.push_back(static_cast<uint8_t>(value));
}

void append32(std::vector<uint8_t>& bytes, uint32_t value) {
  append16(bytes, value >> 16);
  append16(bytes, value & 0xffff);
}

/// Of the PNG specification: the one of left, above and above left that is nearest to left + above - above left.
int paeth(int left, int above, int aboveLeft) {
  const int estimate = left + above - aboveLeft;
  const int toLeft = std::abs(estimate - left);
  const int toAbove = std::abs(estimate - above);
  const int toAboveLeft = std::abs(estimate - aboveLeft);
  return toLeft <= toAbove && toLeft <= toAboveLeft ? left : toAbove <= toAboveLeft ? above : aboveLeft;
}

/// What the PNG filter of this number (0 to 4) predicts for a byte.
int predicted(int filter, int left, int above, int aboveLeft) {
  const int predictions[] = {0, left, above, (left + above) / 2, paeth(left, above, aboveLeft)};
  return predictions[filter];
}

/// Each row with the filter whose differences are smallest in sum, as the PNG specification advises.
std::vector<uint8_t> filteredRows(const Image<Rgb8>& image) {
  constexpr int kFilters = 5;
  const auto rowBytes = static_cast<size_t>(image.width()) * kPixelBytes;
  const std::vector<uint8_t> dark(rowBytes, 0);
  std::vector<uint8_t> all;
  all.reserve((rowBytes + 1) * static_cast<size_t>(image.height()));
  std::vector<uint8_t> row(rowBytes + 1);
  std::vector<uint8_t> best;
  for (int y = 0; y < image.height(); ++y) {
    const auto* bytes = reinterpret_cast<const uint8_t*>(&image(0, y));
    const uint8_t* above = y > 0 ? reinterpret_cast<const uint8_t*>(&image(0, y - 1)) : dark.data();
    size_t least = ~size_t{0};
    for (int filter = 0; filter < kFilters; ++filter) {
      row[0] = static_cast<uint8_t>(filter);
      size_t sum = 0;
      for (size_t i = 0; i < rowBytes; ++i) {
        const int left = i >= kPixelBytes ? bytes[i - kPixelBytes] : 0;
        const int aboveLeft = i >= kPixelBytes ? above[i - kPixelBytes] : 0;
        row[i + 1] = static_cast<uint8_t>(bytes[i] - predicted(filter, left, above[i], aboveLeft));
        sum += static_cast<size_t>(std::abs(static_cast<int8_t>(row[i + 1])));
      }
      if (sum < least) {
        least = sum;
        best = row;
      }
    }
    all.insert(all.end(), best.begin(), best.end());
  }
  return all;
}

void appendCompressed(std::vector<uint8_t>& bytes, const std::vector<uint8_t>& rows) {
  const size_t begin = bytes.size();
  uLongf size = compressBound(rows.size());
  bytes.resize(begin + size);
  OC_CHECK(compress2(bytes.data() + begin, &size, rows.data(), rows.size(), Z_DEFAULT_COMPRESSION) == Z_OK,
           "zlib refused a buffer of the size that it asked for");
  bytes.resize(begin + size);
}

}  // namespace

ApngWriter::ApngWriter(const std::filesystem::path& path, int width, int height, uint32_t images)
    : file_(path), width_(width), height_(height), images_(images) {
  OC_CHECK(width > 0 && height > 0 && images > 0, "an animation needs images");
  file_.write("\x89PNG\r\n\x1a\n");
  std::vector<uint8_t> header;
  append32(header, static_cast<uint32_t>(width));
  append32(header, static_cast<uint32_t>(height));
  header.insert(header.end(), {8, 2, 0, 0, 0});  // eight bits, RGB, deflate, filters of rows, not interlaced
  chunk("IHDR", header);
  const uint8_t srgbIntent[] = {0};
  chunk("sRGB", srgbIntent);
  std::vector<uint8_t> control;
  append32(control, images);
  append32(control, 0);  // without end
  chunk("acTL", control);
}

void ApngWriter::chunk(std::string_view type, std::span<const uint8_t> data) {
  std::vector<uint8_t> bytes;
  append32(bytes, static_cast<uint32_t>(data.size()));
  bytes.insert(bytes.end(), type.begin(), type.end());
  bytes.insert(bytes.end(), data.begin(), data.end());
  append32(bytes, static_cast<uint32_t>(crc32_z(0, bytes.data() + 4, bytes.size() - 4)));
  file_.write(bytes);
}

void ApngWriter::add(const Image<Rgb8>& image, uint16_t milliseconds) {
  OC_CHECK(image.width() == width_ && image.height() == height_, "an image of another size");
  OC_CHECK(added_ < images_, "more images than were announced");
  std::vector<uint8_t> control;
  append32(control, sequence_++);
  append32(control, static_cast<uint32_t>(width_));
  append32(control, static_cast<uint32_t>(height_));
  append32(control, 0);
  append32(control, 0);
  append16(control, milliseconds);
  append16(control, 1000);
  control.insert(control.end(), {0, 0});  // stays, and replaces all
  chunk("fcTL", control);
  std::vector<uint8_t> data;
  if (added_ > 0) {
    append32(data, sequence_++);
  }
  appendCompressed(data, filteredRows(image));
  chunk(added_ > 0 ? "fdAT" : "IDAT", data);
  ++added_;
}

void ApngWriter::finish() {
  OC_CHECK(added_ == images_, "fewer images than were announced");
  chunk("IEND", {});
  file_.commit();
}

}  // namespace ocelli
