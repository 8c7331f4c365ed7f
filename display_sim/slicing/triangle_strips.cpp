#include "display_sim/slicing/triangle_strips.h"

#include <algorithm>

#include "display_sim/slicing/slice_mesh.h"

namespace ocelli {

TriangleStrips::TriangleStrips() : ranges_(static_cast<size_t>(latticePattern(3)) + 1) {
  for (int foot = 0; foot <= kFootSteps / 2; ++foot) {
    for (int strips = 1; strips <= kMaxStrips; ++strips) {
      for (int pieces = 1; pieces <= kMaxPieces; ++pieces) {
        Range& range = ranges_[static_cast<size_t>(pattern(strips, pieces, foot))];
        range.first = static_cast<uint32_t>(weightsOfB_.size());
        for (int strip = 0; strip < strips; ++strip) {
          addStrip(strip, strips, pieces, static_cast<double>(foot) / kFootSteps);
        }
        range.count = static_cast<uint32_t>(weightsOfB_.size()) - range.first;
      }
    }
  }
  addLattice(2);
  addLattice(3);
  weightsOfB_.resize(weightsOfB_.size() + SliceMesh::kPadding);
  weightsOfC_.resize(weightsOfC_.size() + SliceMesh::kPadding);
}

void TriangleStrips::addLattice(int parts) {
  Range& range = ranges_[static_cast<size_t>(latticePattern(parts))];
  range.first = static_cast<uint32_t>(weightsOfB_.size());
  for (int b = 0; b <= parts; ++b) {
    for (int c = 0; b + c <= parts; ++c) {
      const bool isCorner = b == parts || c == parts || b + c == 0;
      if (!isCorner) {
        weightsOfB_.push_back(static_cast<float>(b) / static_cast<float>(parts));
        weightsOfC_.push_back(static_cast<float>(c) / static_cast<float>(parts));
      }
    }
  }
  range.count = static_cast<uint32_t>(weightsOfB_.size()) - range.first;
}

void TriangleStrips::addStrip(int strip, int strips, int pieces, double foot) {
  const double lower = static_cast<double>(strip) / strips;
  const double height = 1.0 / strips;
  const double length = 1 - lower;
  const int count = (pieces * (strips - strip) + strips - 1) / strips;
  // The strip is as high as this from `first` to `last`, and falls to 0 at its ends.
  const double first = foot * height;
  const double last = length - (1 - foot) * height;
  const auto heightAt = [&](double s) { return s < first ? s / foot : s > last ? (length - s) / (1 - foot) : height; };
  for (int i = 0; i < count; ++i) {
    const double begin = length * i / count;
    const double end = length * (i + 1) / count;
    const double highest = heightAt(std::clamp(first, begin, end));
    const double t = lower + highest / 2;
    const double s = foot * lower + (begin + end) / 2;
    weightsOfB_.push_back(static_cast<float>(s - foot * t));
    weightsOfC_.push_back(static_cast<float>(t));
  }
}

}  // namespace ocelli
