#include "display_sim/quilt/line_painter.h"

#include <algorithm>
#include <limits>

namespace ocelli {
namespace {

constexpr int kUnknown = -1;
constexpr float kNothingBeside = std::numeric_limits<float>::infinity();

/// The first pixel whose centre is at x or beyond, in [0, width].
int firstPixelFrom(float x, float width) {
  return static_cast<int>(std::clamp(x + 0.5f, 0.0f, width));
}

}  // namespace

LinePainter::LinePainter(int width)
    : width_(width), inverseZ_(static_cast<size_t>(width)), segment_(static_cast<size_t>(width)) {}

void LinePainter::draw(const SampleLine& line, const LineMap& map) {
  std::fill(inverseZ_.begin(), inverseZ_.end(), -1.0f);
  std::fill(segment_.begin(), segment_.end(), kUnknown);
  const size_t count = line.size();
  x_.resize(count);
  for (size_t i = 0; i < count; ++i) {
    x_[i] = map.perU * line.u[i] + map.perInverseZ * line.inverseZ[i] + map.offset;
  }
  const auto width = static_cast<float>(width_);
  for (size_t i = 0; i + 1 < count; ++i) {
    if (line.joinsNext[i] == 0) {
      continue;
    }
    const float x0 = x_[i];
    const float x1 = x_[i + 1];
    const int begin = firstPixelFrom(std::min(x0, x1), width);
    const int end = firstPixelFrom(std::max(x0, x1), width);
    if (begin >= end) {
      continue;
    }
    const float w0 = line.inverseZ[i];
    const float slope = (line.inverseZ[i + 1] - w0) / (x1 - x0);
    for (int x = begin; x < end; ++x) {
      const float w = w0 + (static_cast<float>(x) + 0.5f - x0) * slope;
      if (w > inverseZ_[static_cast<size_t>(x)]) {
        inverseZ_[static_cast<size_t>(x)] = w;
        segment_[static_cast<size_t>(x)] = static_cast<int>(i);
      }
    }
  }
}

size_t LinePainter::write(const SampleLine& line, const SampleLines& lines, const SrgbEncoder& encoder, Rgb8* color,
                          float* inverseZ) {
  size_t unknown = 0;
  for (int x = 0; x < width_; ++x) {
    const int segment = segment_[static_cast<size_t>(x)];
    const float w = inverseZ_[static_cast<size_t>(x)];
    if (segment == kUnknown || w <= lines.emptyInverseZ) {
      unknown += segment == kUnknown ? 1 : 0;
      color[x] = Rgb8(0);
      if (inverseZ != nullptr) {
        inverseZ[x] = 0;
      }
      continue;
    }
    const auto i = static_cast<size_t>(segment);
    // Along a segment, 1/z and colour/z are linear in the image.
    const float part = (static_cast<float>(x) + 0.5f - x_[i]) / (x_[i + 1] - x_[i]);
    const float share = part * line.inverseZ[i + 1] / w;
    color[x] = encoder.bytesFromLinear(line.color[i] * (1 - share) + line.color[i + 1] * share);
    if (inverseZ != nullptr) {
      inverseZ[x] = w;
    }
  }
  return unknown > 0 && lines.knowsEmpty ? fillGaps(lines.emptyInverseZ, color) : unknown;
}

size_t LinePainter::fillGaps(float emptyInverseZ, Rgb8* color) const {
  size_t filled = 0;
  for (int begin = 0; begin < width_; ++begin) {
    if (segment_[static_cast<size_t>(begin)] != kUnknown) {
      continue;
    }
    int end = begin;
    while (end < width_ && segment_[static_cast<size_t>(end)] == kUnknown) {
      ++end;
    }
    const float leftInverseZ = begin > 0 ? inverseZ_[static_cast<size_t>(begin) - 1] : kNothingBeside;
    const float rightInverseZ = end < width_ ? inverseZ_[static_cast<size_t>(end)] : kNothingBeside;
    const float farther = std::min(leftInverseZ, rightInverseZ);
    if (farther > emptyInverseZ) {
      filled += static_cast<size_t>(end - begin);
      if (farther < kNothingBeside) {
        std::fill(color + begin, color + end, leftInverseZ <= rightInverseZ ? color[begin - 1] : color[end]);
      }
    }
    begin = end;
  }
  return filled;
}

}  // namespace ocelli
