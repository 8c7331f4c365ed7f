#include "oc_core/render/rasterize_spans.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

#include "oc_core/base/conventions.h"
#include "oc_core/base/parallel.h"
#include "oc_core/render/line_projection.h"
#include "oc_core/render/rasterize.h"

namespace ocelli {
namespace {

constexpr int kBandRows = 16;
constexpr size_t kChunks = 32;

/// Draws those of `count` triangles, `triangleAt(i)`, that `touches(piece, range)` accepts: `draw(triangle, piece,
/// span)` for each span, in `rows` rows. Returns the triangles that were accepted.
template <class TriangleAt, class Touches, class Draw>
std::vector<uint32_t> drawSpans(int rows, const LineProjection& projection, size_t count, const TriangleAt& triangleAt,
                                const Touches& touches, const Draw& draw) {
  const auto bands = static_cast<size_t>((rows + kBandRows - 1) / kBandRows);
  std::vector<std::vector<uint32_t>> bins(kChunks * bands);  // by chunk, then by band
  std::array<std::vector<uint32_t>, kChunks> accepted;
  parallelChunks(count, kChunks, [&](size_t chunk, size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      const uint32_t triangle = triangleAt(i);
      projection.forPieces(triangle, [&](const LineTriangle& piece) {
        const LineRows range = projection.rowsOf(piece);
        if (range.first > range.last || !touches(piece, range)) {
          return;
        }
        if (accepted[chunk].empty() || accepted[chunk].back() != triangle) {
          accepted[chunk].push_back(triangle);
        }
        for (int row = range.first; row <= range.last;) {
          const int band = projection.row(row) / kBandRows;
          std::vector<uint32_t>& bin = bins[chunk * bands + static_cast<size_t>(band)];
          if (bin.empty() || bin.back() != triangle) {
            bin.push_back(triangle);
          }
          row += std::min(kBandRows * (band + 1), rows) - projection.row(row);
        }
      });
    }
  });
  parallelFor(bands, 1, [&](size_t firstBand, size_t lastBand) {
    for (size_t band = firstBand; band < lastBand; ++band) {
      const int begin = static_cast<int>(band) * kBandRows;
      const int end = std::min(begin + kBandRows, rows);
      LineSpan span;
      for (size_t chunk = 0; chunk < kChunks; ++chunk) {
        for (const uint32_t triangle : bins[chunk * bands + band]) {
          projection.forPieces(triangle, [&](const LineTriangle& piece) {
            const LineRows range = projection.rowsOf(piece);
            for (int i = range.first; i <= range.last; ++i) {
              const int row = projection.row(i);
              if (row >= begin && row < end && projection.cut(piece, row, span)) {
                draw(triangle, piece, span);
              }
            }
          });
        }
      }
    }
  });
  std::vector<uint32_t> all;
  for (const std::vector<uint32_t>& part : accepted) {
    all.insert(all.end(), part.begin(), part.end());
  }
  return all;
}

/// Keeps the sample at `t` of the way along a span where it is the closest at its pixel.
void keep(Fragment& fragment, uint32_t triangle, const LineTriangle& piece, const LineSpan& span, double t) {
  const glm::dvec3 weights = glm::max(span.from.weights + (span.to.weights - span.from.weights) * t, 0.0);
  const double inverseZ = LineProjection::inverseZ(piece, weights);
  const auto z = static_cast<float>(1 / inverseZ);
  if (!fragment.covered() || z < fragment.t || (z == fragment.t && triangle < fragment.triangle)) {
    glm::dvec2 b(0);
    for (int i = 0; i < 3; ++i) {
      const LineCorner& corner = piece[static_cast<size_t>(i)];
      b += glm::dvec2(corner.b1, corner.b2) * (weights[i] * static_cast<double>(corner.vertex.inverseZ) / inverseZ);
    }
    fragment = {z, triangle, static_cast<float>(b.x), static_cast<float>(b.y)};
  }
}

/// The base pixels whose centres lie in [from, to).
LineRows centresWithin(double from, double to, int length) {
  return {static_cast<int>(std::clamp(std::ceil(from - 0.5), 0.0, static_cast<double>(length))),
          static_cast<int>(std::clamp(std::ceil(to - 0.5), 0.0, static_cast<double>(length))) - 1};
}

/// Draws what lies in the disocclusions of a camera.
class DisocclusionRasterizer {
 public:
  DisocclusionRasterizer(const EpipolarCamera& camera, FragmentImage& fragments)
      : camera_(camera),
        lines_(camera.lines()),
        fragments_(fragments),
        tops_(lines_.longest() + 1, lines_.rowCount(), 0),
        tileTops_((tops_.width() >> kTileBits) + 1, (tops_.height() >> kTileBits) + 1, 0) {
    parallelFor(static_cast<size_t>(lines_.rowCount()), 16, [&](size_t begin, size_t end) {
      for (size_t row = begin; row < end; ++row) {
        for (int cell = 0; cell < camera.cellCount(static_cast<int>(row)); ++cell) {
          tops_(cell, static_cast<int>(row)) = disocclusionTop(static_cast<int>(row), cell);
        }
      }
    });
    parallelFor(static_cast<size_t>(tileTops_.height()), 1, [&](size_t begin, size_t end) {
      for (size_t tileRow = begin; tileRow < end; ++tileRow) {
        const int first = static_cast<int>(tileRow) << kTileBits;
        for (int row = first; row < std::min(first + (1 << kTileBits), tops_.height()); ++row) {
          for (int cell = 0; cell < tops_.width(); ++cell) {
            float& top = tileTops_(cell >> kTileBits, static_cast<int>(tileRow));
            top = std::max(top, tops_(cell, row));
          }
        }
      }
    });
  }

  /// Whether some of a triangle may lie in a disocclusion.
  bool touches(const LineProjection& projection, const LineTriangle& piece, const LineRows& range) const {
    const float farthest = std::min({piece[0].vertex.inverseZ, piece[1].vertex.inverseZ, piece[2].vertex.inverseZ});
    if (lines_.isParallel() && missesTiles(piece, range, farthest)) {
      return false;
    }
    constexpr int kMaxCells = 64;  // larger ones are few: take them
    int cells = 0;
    for (int i = range.first; i <= range.last; ++i) {
      const int row = projection.row(i);
      const glm::vec2 positions = projection.positionsOf(piece, row);
      if (!(positions.y >= 0) || !(positions.x < static_cast<float>(lines_.length(row)))) {
        continue;
      }
      const int first = EpipolarCamera::cellOf(std::max(positions.x, 0.0f));
      const int last = EpipolarCamera::cellOf(std::min(positions.y, static_cast<float>(lines_.length(row))));
      cells += last - first + 1;
      if (cells > kMaxCells) {
        return true;
      }
      for (int cell = first; cell <= last; ++cell) {
        if (farthest < tops_(cell, row)) {
          return true;
        }
      }
    }
    return false;
  }

  void draw(uint32_t triangle, const LineTriangle& piece, const LineSpan& span) {
    const int length = lines_.length(span.row);
    if (!(span.to.position >= 0) || !(span.from.position < length)) {
      return;
    }
    const LineRows centres = centresWithin(span.from.position, span.to.position, length);
    const double farthest = std::min(span.fromInverseZ, span.toInverseZ);
    const int first = EpipolarCamera::cellOf(std::max(span.from.position, 0.0));
    const int last = EpipolarCamera::cellOf(std::min(span.to.position, static_cast<double>(length)));
    for (int cell = first; cell <= last; ++cell) {
      if (farthest < static_cast<double>(tops_(cell, span.row))) {
        // A cell begins at the centre of the base pixel before it.
        if (cell - 1 >= centres.first && cell - 1 <= centres.last) {
          drawLeft(triangle, piece, span, cell - 1);
        }
        drawRight(triangle, piece, span, cell);
      }
    }
  }

 private:
  /// Whether a triangle, whose positions are the same in all rows, is nearer than the disocclusions of all tiles around
  /// it.
  bool missesTiles(const LineTriangle& piece, const LineRows& range, float farthest) const {
    const auto [least, most] = std::minmax({piece[0].vertex.u, piece[1].vertex.u, piece[2].vertex.u});
    const auto length = static_cast<float>(lines_.longest());
    const int firstTile = EpipolarCamera::cellOf(std::clamp(least, 0.0f, length)) >> kTileBits;
    const int lastTile = EpipolarCamera::cellOf(std::clamp(most, 0.0f, length)) >> kTileBits;
    for (int tileRow = range.first >> kTileBits; tileRow <= range.last >> kTileBits; ++tileRow) {
      for (int tile = firstTile; tile <= lastTile; ++tile) {
        if (farthest < tileTops_(tile, tileRow)) {
          return false;
        }
      }
    }
    return true;
  }

  /// The greatest 1/z of a disocclusion over a cell; 0 for none.
  float disocclusionTop(int row, int cell) const {
    const std::span<const uint32_t> over = camera_.disocclusionsOver(row, cell);
    if (over.empty()) {
      return 0;
    }
    const double xRight = camera_.disocclusions(row)[over.back()].xRight;
    double top = 0;
    for (const double border : {EpipolarCamera::cellBegin(cell), EpipolarCamera::cellBegin(cell + 1)}) {
      if (lines_.has(row, border)) {
        const double x = lines_.x(row, border);
        top = std::max(top, (x - xRight) / lines_.disparity() / lines_.inverseZScale(x));
      }
    }
    return static_cast<float>(top * 1.001);
  }

  /// The ray of L through the centre of base pixel j, where it lies in a disocclusion.
  void drawLeft(uint32_t triangle, const LineTriangle& piece, const LineSpan& span, int j) {
    const double t = (j + 0.5 - span.from.position) / (span.to.position - span.from.position);
    const double w = span.fromInverseZ + (span.toInverseZ - span.fromInverseZ) * t;
    const double x = lines_.x(span.row, j + 0.5);
    const double y = w * lines_.inverseZScale(x);
    const EpipolarCamera::Disocclusion* disocclusion =
        camera_.disocclusionOf(span.row, j + 1, x - lines_.disparity() * y);
    if (disocclusion != nullptr && y < disocclusion->yFar && j >= disocclusion->position - disocclusion->added) {
      keep(fragments_(j + disocclusion->shift, span.row), triangle, piece, span, t);
    }
  }

  /// Rays of R that cross the span over a cell.
  void drawRight(uint32_t triangle, const LineTriangle& piece, const LineSpan& span, int cell) {
    const double disparity = lines_.disparity();
    const double from = span.from.position;
    const double to = span.to.position;
    if (!(to > from)) {
      return;
    }
    // 1/z is linear over the span, so y = slope x + offset; R sees the span from minRight to maxRight.
    const double change = (span.toInverseZ - span.fromInverseZ) / (to - from);
    double slope = change;
    double offset = span.fromInverseZ - change * from;
    double sign = 0;
    if (!lines_.isParallel()) {
      sign = lines_.advance() > 0 ? 1 : -1;
      offset = -sign * change;
      slope = sign * (span.fromInverseZ - offset * lines_.radius(span.row, from));
    }
    const auto xRightAt = [&](double position, double inverseZ) {
      const double x = lines_.x(span.row, position);
      return lines_.isParallel() ? x - disparity * inverseZ : x * (1 - sign * disparity * inverseZ);
    };
    const auto [minRight, maxRight] = std::minmax({xRightAt(from, span.fromInverseZ), xRightAt(to, span.toInverseZ)});
    const double spread = 1 - disparity * slope;
    // The part over the cell.
    const double end = EpipolarCamera::cellBegin(cell + 1);
    const double x0 = lines_.x(span.row, std::max(from, EpipolarCamera::cellBegin(cell)));
    const double x1 = lines_.x(span.row, lines_.has(span.row, end) ? std::min(to, end) : to);
    const double right0 = x0 * spread - disparity * offset;
    const double right1 = x1 * spread - disparity * offset;
    const std::span<const EpipolarCamera::Disocclusion> disocclusions = camera_.disocclusions(span.row);
    for (const uint32_t index : camera_.disocclusionsOver(span.row, cell)) {
      const EpipolarCamera::Disocclusion& disocclusion = disocclusions[index];
      constexpr double kRounding = 1e-6;
      const double a = lines_.position(span.row, right0 + disparity * disocclusion.yFar);
      const double b = lines_.position(span.row, right1 + disparity * disocclusion.yFar);
      const double least = disocclusion.position - disocclusion.added;
      const double most = disocclusion.position - 1;
      const int first = static_cast<int>(std::clamp(std::ceil(std::min(a, b) - 0.5 - kRounding), least, most + 1));
      const int last = static_cast<int>(std::clamp(std::floor(std::max(a, b) - 0.5 + kRounding), least - 1, most));
      for (int column = first; column <= last; ++column) {
        const double xRight = lines_.x(span.row, column + 0.5) - disparity * disocclusion.yFar;
        if (xRight < minRight || xRight >= maxRight) {
          continue;
        }
        const double x = (xRight + disparity * offset) / spread;
        const double y = (x - xRight) / disparity;
        const double position = lines_.position(span.row, x);
        if (y >= disocclusion.yFar && EpipolarCamera::cellOf(position) == cell &&
            camera_.disocclusionOf(span.row, cell, xRight) == &disocclusion) {
          const double t = (position - from) / (to - from);
          keep(fragments_(column + disocclusion.shift, span.row), triangle, piece, span, std::clamp(t, 0.0, 1.0));
        }
      }
    }
  }

  const EpipolarCamera& camera_;
  const EpipolarLines& lines_;
  FragmentImage& fragments_;
  static constexpr int kTileBits = 3;
  Image<float> tops_;
  Image<float> tileTops_;  ///< the greatest of each square of them
};

}  // namespace

FragmentImage baseFragments(const EpipolarCamera& camera, const FragmentImage& baseImage) {
  const EpipolarLines& lines = camera.lines();
  OC_CHECK(baseImage.width() == lines.longest() && baseImage.height() == lines.rowCount(),
           "the base image holds the camera's epipolar lines");
  FragmentImage fragments(camera.width(), camera.height());
  parallelFor(static_cast<size_t>(lines.rowCount()), 8, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      const int row = static_cast<int>(i);
      const std::span<const EpipolarCamera::Disocclusion> disocclusions = camera.disocclusions(row);
      size_t edge = 0;
      int shift = 0;
      for (int j = 0; j < lines.length(row); ++j) {
        if (edge < disocclusions.size() && disocclusions[edge].position <= j) {
          shift = disocclusions[edge++].shift;
        }
        const Fragment& fragment = baseImage(j, row);
        if (!fragment.covered()) {
          continue;
        }
        const double x = lines.x(row, j + 0.5);
        const double y = lines.inverseZScale(x) / static_cast<double>(fragment.t);
        if (camera.disocclusionOf(row, j + 1, x - lines.disparity() * y) == nullptr) {
          fragments(j + shift, row) = fragment;
        }
      }
    }
  });
  return fragments;
}

struct LineDrawing::Impl {
  const EpipolarLines& lines;
  LineProjection projection;
  uint32_t triangles;
  std::vector<uint32_t> touched{};  ///< disocclusions, the last time

  FragmentImage allAlongLines() const {
    FragmentImage fragments(lines.longest(), lines.rowCount());
    drawSpans(
        fragments.height(), projection, triangles, [](size_t i) { return static_cast<uint32_t>(i); },
        [](const LineTriangle&, const LineRows&) { return true; },
        [&](uint32_t triangle, const LineTriangle& piece, const LineSpan& span) {
          const LineRows centres = centresWithin(span.from.position, span.to.position, lines.length(span.row));
          for (int j = centres.first; j <= centres.last; ++j) {
            keep(fragments(j, span.row), triangle, piece, span,
                 (j + 0.5 - span.from.position) / (span.to.position - span.from.position));
          }
        });
    return fragments;
  }

  template <class TriangleAt>
  FragmentImage inDisocclusions(const EpipolarCamera& camera, const FragmentImage& baseImage, size_t count,
                                const TriangleAt& triangleAt) {
    FragmentImage fragments = baseFragments(camera, baseImage);
    DisocclusionRasterizer renderer(camera, fragments);
    touched = drawSpans(
        fragments.height(), projection, count, triangleAt,
        [&](const LineTriangle& piece, const LineRows& range) { return renderer.touches(projection, piece, range); },
        [&](uint32_t triangle, const LineTriangle& piece, const LineSpan& span) {
          renderer.draw(triangle, piece, span);
        });
    return fragments;
  }
};

LineDrawing::LineDrawing(const PinholeCamera& base, const EpipolarLines& lines, const Mesh& mesh)
    : impl_(new Impl{lines, LineProjection(base, lines, mesh), static_cast<uint32_t>(mesh.triangles.size())}) {}

LineDrawing::~LineDrawing() = default;

FragmentImage LineDrawing::baseImage() const {
  return impl_->lines.isParallel() ? rasterize(impl_->projection.projected()) : impl_->allAlongLines();
}

FragmentImage LineDrawing::draw(const EpipolarCamera& camera, const FragmentImage& baseImage) {
  return impl_->inDisocclusions(camera, baseImage, impl_->triangles, [](size_t i) { return static_cast<uint32_t>(i); });
}

FragmentImage LineDrawing::drawAgain(const EpipolarCamera& camera, const FragmentImage& baseImage) {
  const std::vector<uint32_t> before = std::move(impl_->touched);
  return impl_->inDisocclusions(camera, baseImage, before.size(), [&](size_t i) { return before[i]; });
}

FragmentImage rasterizeLines(const PinholeCamera& base, const EpipolarLines& lines, const Mesh& mesh) {
  return LineDrawing(base, lines, mesh).baseImage();
}

FragmentImage rasterize(const EpipolarCamera& camera, const Mesh& mesh, const FragmentImage& baseImage) {
  return LineDrawing(camera.base(), camera.lines(), mesh).draw(camera, baseImage);
}

FragmentImage rasterize(const EpipolarCamera& camera, const Mesh& mesh) {
  LineDrawing drawing(camera.base(), camera.lines(), mesh);
  return drawing.draw(camera, drawing.baseImage());
}

}  // namespace ocelli
