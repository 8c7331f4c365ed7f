#include "display_sim/quilt/sample_lines.h"

#include <algorithm>
#include <limits>
#include <numeric>

#include "oc_core/base/parallel.h"
#include "oc_core/ocri/sample_join.h"

namespace ocelli {
namespace {

/// 1/z of empty points, of that of the farthest sample.
constexpr float kEmptyShare = 0.999f;
constexpr float kFarAside = 1e6f;  ///< pixels

/// What stands at a pixel of a row: a sample, or where its empty ray ends (t is 0), or nothing.
struct LinePixel {
  ImagePoint place;
  int column = 0;
  bool isEmpty = false;
};

float minInverseZ(const ReferenceImage& image) {
  float farthest = 0;
  for (size_t i = 0; i < image.t.size(); ++i) {
    farthest = image.holds(i) ? std::max(farthest, image.t[i]) : farthest;
  }
  return farthest > 0 ? 1 / farthest : 1;
}

class LineMaker {
 public:
  LineMaker(const ReferenceImage& image, const EmptyRays& empty, const ImageMeshOptions& options,
            const PinholeCamera& base, float emptyInverseZ)
      : image_(image),
        empty_(empty),
        options_(options),
        focal_(base.focalPixels()),
        baseWidth_(static_cast<float>(base.width())),
        emptyInverseZ_(emptyInverseZ) {}

  SampleLine line(int row) {
    findPixels(row);
    joins_.assign(pixels_.size(), 0);
    for (size_t i = 0; i + 1 < pixels_.size(); ++i) {
      joins_[i] = joinsNext(i);
    }
    SampleLine line;
    if (empty_.beyondBorders) {
      addEmpty(line, -kFarAside, 0);
    }
    for (size_t i = 0; i < pixels_.size(); ++i) {
      const bool begins = i == 0 || joins_[i - 1] == 0;
      const bool ends = joins_[i] == 0;
      const glm::vec3 color = pixels_[i].isEmpty ? glm::vec3(0) : image_.color(pixels_[i].column, row);
      if (begins) {
        addEnd(line, i, -1, color, true);
      }
      if (!pixels_[i].isEmpty) {  // what is empty is alike from end to end
        add(line, {pixels_[i].place.u, inverseZOf(i)}, color, true);
      }
      if (ends) {
        addEnd(line, i, 1, color, false);
      }
    }
    if (empty_.beyondBorders) {
      addEmpty(line, lastSurface().value_or(baseWidth_), baseWidth_ + kFarAside);
    }
    return line;
  }

 private:
  void findPixels(int row) {
    pixels_.clear();
    for (int x = 0; x < image_.width(); ++x) {
      if (image_.holds(x, row)) {
        pixels_.push_back({image_.undistorted(x, row), x, false});
      } else if (const std::optional<FarEnd> end = empty_.farEnd ? empty_.farEnd(x, row) : std::nullopt;
                 end && end->inverseZ <= emptyInverseZ_) {
        pixels_.push_back({{end->u, static_cast<float>(row) + 0.5f, 0}, x, true});
      }
    }
  }

  /// Where the last surface of the row begins. Beyond it there is nothing, and nothing behind it on the side that comes
  /// into view: columns that would hold it are taken out where they hold nothing (EocOptions::trim).
  std::optional<float> lastSurface() const {
    size_t i = pixels_.size();
    while (i > 0 && pixels_[i - 1].isEmpty) {
      --i;
    }
    if (i == 0) {
      return std::nullopt;
    }
    --i;
    while (i > 0 && joins_[i - 1] != 0) {
      --i;
    }
    return pixels_[i].place.u;
  }

  void addEmpty(SampleLine& line, float from, float to) const {
    add(line, {from, emptyInverseZ_}, glm::vec3(0), true);
    add(line, {to, emptyInverseZ_}, glm::vec3(0), false);
  }

  float inverseZOf(size_t i) const { return pixels_[i].isEmpty ? emptyInverseZ_ : 1 / pixels_[i].place.t; }

  bool joinsNext(size_t i) const {
    const LinePixel& a = pixels_[i];
    const LinePixel& b = pixels_[i + 1];
    if (b.column != a.column + 1 || a.isEmpty != b.isEmpty) {
      return false;
    }
    if (a.isEmpty) {
      return std::abs(b.place.u - a.place.u - 1) < 0.5f;
    }
    const auto place = [&](size_t k) { return k < pixels_.size() ? pixels_[k].place : ImagePoint{}; };
    return samplesJoin(place(i - 1), a.place, b.place, place(i + 2), true, focal_, 1, options_);
  }

  /// The end of a surface, to the left (-1) or right of its last sample.
  void addEnd(SampleLine& line, size_t i, int side, const glm::vec3& color, bool joins) const {
    const ImagePoint& at = pixels_[i].place;
    const float w = inverseZOf(i);
    const bool goesOn = side < 0 ? joins_[i] != 0 : i > 0 && joins_[i - 1] != 0;
    if (!goesOn) {
      add(line, {at.u + 0.5f * static_cast<float>(side), w}, color, joins);
      return;
    }
    const size_t other = side < 0 ? i + 1 : i - 1;
    const float u = at.u + (at.u - pixels_[other].place.u) / 2;
    add(line, {u, std::max(w + (w - inverseZOf(other)) / 2, w / 2)}, color, joins);
  }

  static void add(SampleLine& line, const glm::vec2& uw, const glm::vec3& color, bool joins) {
    line.u.push_back(uw.x);
    line.inverseZ.push_back(uw.y);
    line.color.push_back(color);
    line.joinsNext.push_back(joins ? 1 : 0);
  }

  const ReferenceImage& image_;
  const EmptyRays& empty_;
  const ImageMeshOptions& options_;
  float focal_;
  float baseWidth_;
  float emptyInverseZ_;
  std::vector<LinePixel> pixels_;
  std::vector<uint8_t> joins_;
};

}  // namespace

SampleLines sampleLines(const ReferenceImage& image, const EmptyRays& empty, const ImageMeshOptions& options) {
  OC_CHECK(!image.isPlaced(), "the rows of this image are no lines of a pinhole");
  SampleLines lines{image.reference(), std::vector<SampleLine>(static_cast<size_t>(image.height())),
                    kEmptyShare * minInverseZ(image), empty.farEnd != nullptr};
  parallelFor(lines.rows.size(), 8, [&](size_t begin, size_t end) {
    LineMaker maker(image, empty, options, lines.base, lines.emptyInverseZ);
    for (size_t row = begin; row < end; ++row) {
      lines.rows[row] = maker.line(static_cast<int>(row));
    }
  });
  return lines;
}

FarEndOf straightRays() {
  return [](int column, int) { return std::optional(FarEnd{static_cast<float>(column) + 0.5f, 0}); };
}

}  // namespace ocelli
