#include "display_sim/dither_score/light_evenness.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "display_sim/dither/even_light.h"
#include "display_sim/slicing/exact_slicer.h"
#include "oc_core/base/check.h"

namespace ocelli {
namespace {

constexpr int kBins = 24;
constexpr double kWallDistance = 0.2;

void addQuad(Mesh& mesh, const glm::vec3& corner, const glm::vec3& a, const glm::vec3& b) {
  const auto first = static_cast<uint32_t>(mesh.positions.size());
  for (const glm::vec3& p : {corner, corner + a, corner + a + b, corner + b}) {
    mesh.positions.push_back(p);
  }
  mesh.triangles.emplace_back(first, first + 1, first + 2);
  mesh.triangles.emplace_back(first, first + 2, first + 3);
}

/// Measures one display. Areas are in display radii squared; bins are of columns away from the axis.
class EvennessMeter {
 public:
  EvennessMeter(const DisplayProfile& profile, const SliceOptions& options, float grey)
      : profile_(profile), options_(options), grey_(grey), sweep_(profile) {
    unit_ = std::min(litCellsPerArea(sweep_, {1, 0, 0}, 1), litCellsPerArea(sweep_, {0, 1, 0}, 1));
    columnsPerBin_ = std::max(1, profile.width / 2 / kBins);
    // Upright surfaces cover these rows wholly, and some of those next to them, which don't count.
    firstRow_ = profile.height / 4;
    lastRow_ = profile.height - 1 - firstRow_;
    top_ = static_cast<float>(sweep_.rowCenterY(firstRow_ - 1));
    height_ = static_cast<float>(sweep_.rowCenterY(lastRow_ + 1)) - top_;
    countedHeight_ = (lastRow_ - firstRow_ + 1) * sweep_.rowHeight();
  }

  std::vector<LightSample> take() {
    addFloor();
    addCylinders();
    addWall();
    addFin();
    return std::move(samples_);
  }

 private:
  /// Light of a mesh's voxels in the columns at k and k + 1 columns from the axis, on both sides; in full voxels, a
  /// volume of a whole turn counting half.
  std::vector<double> lightOfColumns(Mesh mesh, int firstRow, int lastRow) const {
    mesh.colors.assign(mesh.positions.size(), glm::vec3(grey_));
    const Volume volume = sliceExactly(mesh, profile_, options_);
    std::vector<double> light(static_cast<size_t>(profile_.width + 1) / 2);
    const double share = 1.0 / volume.fullLevel() / 3 * sweep_.slicesPerHalfTurn() / volume.slices();
    for (int slice = 0; slice < volume.slices(); ++slice) {
      forEachLevel(volume, slice, [&](int column, int row, const Rgb8& levels) {
        if (row >= firstRow && row <= lastRow) {
          const double away = std::abs(column + 0.5 - profile_.width / 2.0);
          light[std::min(static_cast<size_t>(away), light.size() - 1)] += share * (levels.r + levels.g + levels.b);
        }
      });
    }
    return light;
  }

  /// Where a column begins, counted from the axis; in an odd number of columns the first has the axis in its middle.
  double radiusOf(int column) const {
    return std::max(column - (profile_.width % 2 == 0 ? 0.0 : 0.5), 0.0) * sweep_.columnWidth();
  }

  /// `cells`: lit for the area, by the formula and without weights.
  void addSample(TestSurface surface, double radius, double light, double area, double cells) {
    samples_.push_back({surface, radius, light / area / unit_, grey_ * weighed(cells) / unit_});
  }

  double weighed(double cells) const {
    double even = cells;
    if (options_.evenLightRadius > 0) {
      for (const glm::dvec3& n : {glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0), glm::dvec3(0, 0, 1)}) {
        even = std::min(even, litCellsPerArea(sweep_, n, options_.evenLightRadius));
      }
    }
    return even;
  }

  /// Calls `add(inner, outer, light)` for each bin beyond a radius.
  template <class Add>
  void forEachBin(const std::vector<double>& light, double from, Add&& add) {
    for (int first = 0; first + columnsPerBin_ <= profile_.width / 2; first += columnsPerBin_) {
      if (radiusOf(first) >= from) {
        double sum = 0;
        for (int i = first; i < first + columnsPerBin_; ++i) {
          sum += light[static_cast<size_t>(i)];
        }
        add(radiusOf(first), radiusOf(first + columnsPerBin_), sum);
      }
    }
  }

  void addFloor() {
    Mesh mesh;
    const auto y = static_cast<float>(sweep_.rowCenterY(profile_.height / 2));
    addQuad(mesh, {-2, y, -2}, {4, 0, 0}, {0, 0, 4});
    forEachBin(lightOfColumns(mesh, 0, profile_.height - 1), 0, [&](double inner, double outer, double light) {
      const double area = std::numbers::pi * (outer * outer - inner * inner);
      // The mean of 1 / r over the ring's area is that at the middle of its radii.
      addSample(TestSurface::kFloor, (inner + outer) / 2, light, area,
                litCellsPerArea(sweep_, {0, 1, 0}, (inner + outer) / 2));
    });
  }

  /// In the middle of columns, so that no facet leaves them.
  void addCylinders() {
    std::vector<int> columns;
    for (int i = std::max(columnsPerBin_ / 2, profile_.width % 2); i < profile_.width / 2; i += columnsPerBin_) {
      columns.push_back(i);
    }
    const int facets = 4 * sweep_.sectors();
    Mesh mesh;
    for (const int column : columns) {
      const double radius = radiusOf(column) + sweep_.columnWidth() / 2;
      for (int i = 0; i < facets; ++i) {
        const auto point = [&](int k) {
          const double angle = 2 * std::numbers::pi * (k % facets) / facets;
          return glm::vec3(radius * std::cos(angle), top_, radius * std::sin(angle));
        };
        addQuad(mesh, point(i), point(i + 1) - point(i), {0, height_, 0});
      }
    }
    const std::vector<double> light = lightOfColumns(mesh, firstRow_, lastRow_);
    for (const int column : columns) {
      const double radius = radiusOf(column) + sweep_.columnWidth() / 2;
      addSample(TestSurface::kCylinder, radius, light[static_cast<size_t>(column)],
                2 * std::numbers::pi * radius * countedHeight_, litCellsPerArea(sweep_, {1, 0, 0}, radius));
    }
  }

  void addWall() {
    Mesh mesh;
    addQuad(mesh, {-1, top_, kWallDistance}, {2, 0, 0}, {0, height_, 0});
    const auto along = [](double radius) { return std::sqrt(radius * radius - kWallDistance * kWallDistance); };
    forEachBin(lightOfColumns(mesh, firstRow_, lastRow_), kWallDistance, [&](double inner, double outer, double light) {
      const double length = along(outer) - along(inner);
      // The formula's integral along the wall: a cell for each column and for each sector that it crosses.
      const double turned = std::acos(kWallDistance / outer) - std::acos(kWallDistance / inner);
      const double crossed = (outer - inner) / sweep_.columnWidth() + turned / sweep_.stepRadians();
      addSample(TestSurface::kWall, (inner + outer) / 2, light, 2 * length * countedHeight_,
                crossed / length / sweep_.rowHeight());
    });
  }

  void addFin() {
    Mesh mesh;
    const double angle = 10.3 * sweep_.stepRadians();  // within a sector
    addQuad(mesh, {0, top_, 0}, {std::cos(angle), 0, std::sin(angle)}, {0, height_, 0});
    forEachBin(lightOfColumns(mesh, firstRow_, lastRow_), radiusOf(1), [&](double inner, double outer, double light) {
      addSample(TestSurface::kFin, (inner + outer) / 2, light, (outer - inner) * countedHeight_,
                litCellsPerArea(sweep_, {0, 0, 1}, (inner + outer) / 2));
    });
  }

  DisplayProfile profile_;
  SliceOptions options_;
  float grey_;
  SweepGeometry sweep_;
  double unit_;
  int columnsPerBin_;
  int firstRow_;
  int lastRow_;
  float top_;
  float height_;
  double countedHeight_;
  std::vector<LightSample> samples_;
};

}  // namespace

std::string_view nameOf(TestSurface surface) {
  switch (surface) {
    case TestSurface::kFloor:
      return "floor";
    case TestSurface::kCylinder:
      return "cylinder";
    case TestSurface::kWall:
      return "wall";
    case TestSurface::kFin:
      return "fin";
  }
  OC_CHECK(false, "no such surface");
}

std::vector<LightSample> measureEvenness(const DisplayProfile& profile, const SliceOptions& options, float grey) {
  return EvennessMeter(profile, options, grey).take();
}

EvennessScore scoreEvenness(std::span<const LightSample> samples, double radius) {
  double sum = 0;
  double squares = 0;
  double least = std::numeric_limits<double>::infinity();
  double largest = 0;
  double count = 0;
  for (const LightSample& sample : samples) {
    if (sample.radius <= radius) {
      sum += sample.lightPerArea;
      squares += sample.lightPerArea * sample.lightPerArea;
      least = std::min(least, sample.lightPerArea);
      largest = std::max(largest, sample.lightPerArea);
      ++count;
    }
  }
  if (count == 0 || sum == 0) {
    return {};
  }
  const double mean = sum / count;
  return {largest / least, std::sqrt(std::max(0.0, squares / count - mean * mean)) / mean, mean};
}

}  // namespace ocelli
