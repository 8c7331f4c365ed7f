#include "display_sim/volume_slicing/swept_samples.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "display_sim/volume_slicing/cell_share.h"
#include "display_sim/volume_slicing/swept_field.h"
#include "display_sim/volume_slicing/swept_light.h"
#include "display_sim/volume_slicing/swept_outline.h"
#include "display_sim/volume_slicing/swept_range.h"
#include "oc_core/base/check.h"
#include "oc_core/base/parallel.h"
#include "oc_core/volume/gradient_light.h"
#include "oc_core/volume/volume_levels.h"

namespace ocelli {
namespace {

/// Voxels of the volume a column, beyond which the volume is made coarser first.
constexpr double kMaxVoxelsAColumn = 2;

glm::ivec3 coarserFactor(const glm::dmat4& sceneFromIndex, const glm::ivec3& size, double cellSide) {
  glm::ivec3 factor(1);
  for (int axis = 0; axis < 3; ++axis) {
    const double spacing = glm::length(glm::dvec3(sceneFromIndex[axis]));
    const double wanted = std::ceil(cellSide / spacing / kMaxVoxelsAColumn);
    factor[axis] = static_cast<int>(std::clamp(wanted, 1.0, double(size[axis])));
  }
  return factor;
}

/// Of the longest step along an index axis.
int pointsFor(const glm::dvec3& indexStep) {
  const glm::dvec3 steps = glm::abs(indexStep);
  // What is a rounding error more than a voxel is a voxel.
  return std::max(static_cast<int>(std::ceil(std::max({steps.x, steps.y, steps.z}) - 1e-6)), 1);
}

/// What gradients do to light. Specular light depends on the eye, and is left out.
struct Weighing {
  bool shaded = false;
  GradientLight<float> light{};
  float fullGradient = 0;  ///< 0: every gradient gives full light

  bool isNeeded() const { return shaded || fullGradient > 0; }

  float weightOf(const glm::vec3& indexGradient) const {
    float weight = shaded ? light.factorAt(indexGradient) : 1;
    if (fullGradient > 0) {
      weight *= std::min(glm::length(light.worldFromIndexGradient * indexGradient) / fullGradient, 1.0f);
    }
    return std::clamp(weight, 0.0f, 1.0f);
  }
};

/// What the points of a cell say together.
struct CellMoments {
  float mean = 0;
  float variance = 0;  ///< of the points
  glm::vec3 gradient{0};
};

enum class CellState : char { kOutside, kBeside, kInVolume };

/// Less of full light than this counts as none.
constexpr float kMinWeight = 0.5f / 255;

uint8_t roundedWeight(float weight) {
  return static_cast<uint8_t>(weight * 255 + 0.5f);
}

/// Cells of a slice that are sampled, with one more on each side, and which of them were.
struct SlicePatch {
  int firstColumn = 0;
  int firstRow = 0;
  int columns = 0;
  int rows = 0;
  std::vector<float> means;
  std::vector<float> variances;
  std::vector<float> weights;
  std::vector<CellState> states;

  explicit SlicePatch(const SweptSlice& slice)
      : firstColumn(slice.firstBrickColumn * kSweptBrickSide - 1),
        firstRow(slice.firstBrickRow * kSweptBrickSide - 1),
        columns(slice.brickColumns * kSweptBrickSide + 2),
        rows(slice.brickRows * kSweptBrickSide + 2) {
    const size_t cells = static_cast<size_t>(columns) * static_cast<size_t>(rows);
    means.resize(cells);
    variances.resize(cells);
    weights.resize(cells);
    states.resize(cells, CellState::kOutside);
  }

  /// The change of the mean over one cell: to both neighbours, or to the one that there is.
  float slope(size_t at, size_t stride) const {
    const size_t before = at - stride;
    const size_t after = at + stride;
    const bool hasBefore = states[before] != CellState::kOutside;
    const bool hasAfter = states[after] != CellState::kOutside;
    return hasBefore && hasAfter ? (means[after] - means[before]) / 2
           : hasAfter            ? means[after] - means[at]
           : hasBefore           ? means[at] - means[before]
                                 : 0;
  }
};

/// One volume on one display while it is sampled.
template <class Field>
class SweptSampler {
 public:
  SweptSampler(const Field& field, const glm::dvec3& upper, const glm::dmat4& indexFromScene,
               const SweepGeometry& sweep, const ValueRange& range, const Weighing& weighing)
      : field_(field),
        upper_(upper),
        indexFromScene_(indexFromScene),
        sweep_(sweep),
        least_(static_cast<float>(range.least)),
        byRange_(range.greatest > range.least ? static_cast<float>(1 / (range.greatest - range.least)) : 0),
        weighing_(weighing) {}

  /// `codes` and `reaches` are those of the first brick of the slice.
  void sample(int slice, const SweptSlice& place, uint16_t* codes, SweptReach* reaches,
              SweptWeights::Some& weights) const {
    if (place.brickColumns == 0) {
      return;
    }
    SlicePatch patch(place);
    const SweptPlane plane(indexFromScene_, sweep_, slice);
    const int pointsAColumn = pointsFor(plane.byRadius * sweep_.columnWidth());
    const int pointsARow = pointsFor(plane.byHeight * sweep_.rowHeight());
    std::vector<ColumnPoints> columns;
    for (int x = 0; x < patch.columns; ++x) {
      columns.push_back(pointsOf(plane, patch.firstColumn + x, pointsAColumn, pointsARow));
    }
    // Neighbours of the volume's outermost cells are no farther from them.
    const glm::dvec3 beside =
        glm::abs(plane.byRadius) * sweep_.columnWidth() + glm::abs(plane.byHeight) * sweep_.rowHeight();
    for (int y = 0; y < patch.rows; ++y) {
      const glm::dvec3 rowShift = plane.byHeight * sweep_.rowCenterY(patch.firstRow + y);
      for (int x = 0; x < patch.columns; ++x) {
        const ColumnPoints& column = columns[static_cast<size_t>(x)];
        const glm::dvec3 center = column.center + rowShift;
        if (!isIn(center, column.reach + beside)) {
          continue;
        }
        const float share = shareInBox(center, column);
        const CellMoments moments = momentsOf(column.points, glm::vec3(rowShift), share < 1);
        const size_t at = static_cast<size_t>(y) * static_cast<size_t>(patch.columns) + static_cast<size_t>(x);
        patch.means[at] = moments.mean;
        patch.variances[at] = moments.variance;
        patch.states[at] = share > kMinWeight ? CellState::kInVolume : CellState::kBeside;
        patch.weights[at] = weighing_.isNeeded() ? share * weighing_.weightOf(moments.gradient) : share;
      }
    }
    encode(place, patch, columns, pointsAColumn, pointsARow, codes, reaches, weights);
  }

 private:
  /// Of the cells of a column, in index coordinates at the height 0.
  struct ColumnPoints {
    glm::dvec3 center{0};
    std::vector<glm::vec3> points{};
    float line = 1;  ///< the variance of a line by that of the points on it
    // How far half a cell reaches along each index axis, by its width, its height, its thickness and by all of them.
    glm::dvec3 byColumn{0};
    glm::dvec3 byRow{0};
    glm::dvec3 byAcross{0};
    glm::dvec3 reach{0};
  };

  ColumnPoints pointsOf(const SweptPlane& plane, int column, int pointsAColumn, int pointsARow) const {
    const double radius = sweep_.columnRadius(column);
    const double thickness = 2 * std::abs(radius) * sweep_.tanHalfStep();
    const int across = thickness > sweep_.columnWidth() ? std::max(pointsFor(plane.byAcross * thickness), 2) : 1;
    ColumnPoints made{.center = plane.origin + plane.byRadius * radius,
                      .byColumn = glm::abs(plane.byRadius) * (sweep_.columnWidth() / 2),
                      .byRow = glm::abs(plane.byHeight) * (sweep_.rowHeight() / 2),
                      .byAcross = glm::abs(plane.byAcross) * (thickness / 2)};
    made.reach = made.byColumn + made.byRow + made.byAcross;
    for (int c = 0; c < pointsAColumn; ++c) {
      const double r = radius + ((c + 0.5) / pointsAColumn - 0.5) * sweep_.columnWidth();
      for (int a = 0; a < across; ++a) {
        const double s = ((a + 0.5) / across - 0.5) * 2 * r * sweep_.tanHalfStep();
        for (int v = 0; v < pointsARow; ++v) {
          const double y = ((v + 0.5) / pointsARow - 0.5) * sweep_.rowHeight();
          made.points.emplace_back(plane.origin + plane.byRadius * r + plane.byAcross * s + plane.byHeight * y);
        }
      }
    }
    // n points spread evenly over a line have 1 - 1 / n^2 of its variance.
    made.line = across > 1 ? static_cast<float>(across * across) / static_cast<float>(across * across - 1) : 1;
    return made;
  }

  bool isIn(const glm::dvec3& index, const glm::dvec3& margin) const {
    for (int axis = 0; axis < 3; ++axis) {
      if (index[axis] < -0.5 - margin[axis] || index[axis] > upper_[axis] + margin[axis]) {
        return false;
      }
    }
    return true;
  }

  /// How much of a cell lies in the volume's box: exact where one pair of its faces cuts the cell.
  float shareInBox(const glm::dvec3& center, const ColumnPoints& column) const {
    if (isIn(center, -column.reach)) {
      return 1;
    }
    double share = 1;
    for (int axis = 0; axis < 3; ++axis) {
      const glm::dvec3 reaches(column.byColumn[axis], column.byRow[axis], column.byAcross[axis]);
      const double above = shareOfBlock(center[axis] + 0.5, reaches);
      const double below = shareOfBlock(upper_[axis] - center[axis], reaches);
      share *= std::max(above + below - 1, 0.0);
    }
    return static_cast<float>(share);
  }

  /// Of a cell that is cut by faces only of the points in the volume's box; of all, which have the field of the nearest
  /// place there, where no point is in it.
  CellMoments momentsOf(const std::vector<glm::vec3>& points, const glm::vec3& shift, bool isCut) const {
    const auto isInBox = [&](const glm::vec3& point) { return isIn(glm::dvec3(point + shift), glm::dvec3(0)); };
    const bool leavesOut = isCut && std::ranges::any_of(points, isInBox);
    CellMoments moments;
    float count = 0;
    // From the first value on, so that single precision does.
    float first = 0;
    float sum = 0;
    float squares = 0;
    for (const glm::vec3& point : points) {
      if (leavesOut && !isInBox(point)) {
        continue;
      }
      glm::vec3 gradient(0);
      const glm::vec3 at = point + shift;
      const float field = weighing_.isNeeded() ? field_.at(at, gradient) : field_.at(at);
      const float value = std::clamp((field - least_) * byRange_, 0.0f, 1.0f);
      first = count == 0 ? value : first;
      count += 1;
      sum += value - first;
      squares += (value - first) * (value - first);
      moments.gradient += gradient;
    }
    moments.mean = first + sum / count;
    moments.gradient /= count;
    moments.variance = std::max(squares - sum * sum / count, 0.0f) / count;
    return moments;
  }

  void encode(const SweptSlice& place, const SlicePatch& patch, const std::vector<ColumnPoints>& columns,
              int pointsAColumn, int pointsARow, uint16_t* codes, SweptReach* reaches,
              SweptWeights::Some& weights) const {
    // Of the variance 1 / 12 of a line of the length 1 the part that n points spread evenly over it have.
    const auto part = [](int n) { return (1 - 1.0f / static_cast<float>(n * n)) / 12; };
    const float columnPart = part(pointsAColumn);
    const float rowPart = part(pointsARow);
    const auto stride = static_cast<size_t>(patch.columns);
    size_t brick = place.firstBrick;
    for (int brickRow = 0; brickRow < place.brickRows; ++brickRow) {
      for (int brickColumn = 0; brickColumn < place.brickColumns; ++brickColumn, ++reaches, ++brick) {
        SweptWeights::Brick brickWeights;
        brickWeights.fill(255);
        auto* weight = brickWeights.data();
        float first = kSweptMeans;
        float last = -1;
        for (int y = 0; y < kSweptBrickSide; ++y) {
          size_t at = static_cast<size_t>(brickRow * kSweptBrickSide + y + 1) * stride +
                      static_cast<size_t>(brickColumn * kSweptBrickSide + 1);
          for (int x = 0; x < kSweptBrickSide; ++x, ++at, ++weight) {
            uint16_t code = kNothingSwept;
            // The last bricks may reach beyond the screen.
            const bool isOnScreen = (place.firstBrickColumn + brickColumn) * kSweptBrickSide + x < sweep_.width() &&
                                    (place.firstBrickRow + brickRow) * kSweptBrickSide + y < sweep_.height();
            if (isOnScreen && patch.states[at] == CellState::kInVolume) {
              const float byColumn = patch.slope(at, 1);
              const float byRow = patch.slope(at, stride);
              const float squares = byColumn * byColumn / 12 + byRow * byRow / 12;
              const float byPoints = byColumn * byColumn * columnPart + byRow * byRow * rowPart;
              const size_t column = static_cast<size_t>(brickColumn * kSweptBrickSide + x + 1);
              const float across = std::max(patch.variances[at] - byPoints, 0.0f) * columns[column].line;
              const float variance = squares + across;
              code = sweptCode(patch.means[at], std::sqrt(3 * variance));
              *weight = roundedWeight(patch.weights[at]);
              const float step = sweptMeanOf(code) * (kSweptMeans - 1);
              const float reach = sweptReach(sweptHalfSpreadOf(code));
              first = std::min(first, step - reach);
              last = std::max(last, step + reach);
            }
            *codes++ = code;
          }
        }
        weights.add(brick, brickWeights);
        if (last >= 0) {
          reaches->first = static_cast<uint16_t>(std::max(std::floor(first), 0.0f));
          reaches->last = static_cast<uint16_t>(std::min(std::ceil(last), float{kSweptMeans - 1}));
        }
      }
    }
  }

  const Field& field_;
  glm::dvec3 upper_;  ///< of the volume's box, in index coordinates
  const glm::dmat4& indexFromScene_;
  const SweepGeometry& sweep_;
  float least_;
  float byRange_;
  const Weighing& weighing_;
};

}  // namespace

bool isSameOnDisplay(const VolumeShading& a, const VolumeShading& b) {
  return a.isOn == b.isOn && (!a.isOn || (a.ambient == b.ambient && a.diffuse == b.diffuse));
}

SweptSamples::SweptSamples(const VolumeScene& scene, const DisplayProfile& profile, const SweptSampling& sampling,
                           const Progress& progress)
    : profile_(profile), sweep_(profile), sceneLengthOfUnit_(scene.sceneLengthOfUnit()) {
  const ValueRange common = commonValues(*scene.volume);
  std::vector<double> toldApart = valuesOfChange(scene.appearance.transfer);
  toldApart.insert(toldApart.end(), sampling.toldApart.begin(), sampling.toldApart.end());
  range_ = codedRange(valueRange(*scene.volume), common, toldApart);
  if (range_.greatest > range_.least) {
    commonSteps_ = (kSweptMeans - 1) * (common.greatest - common.least) / (range_.greatest - range_.least);
  }
  std::optional<ScalarVolume> coarser;
  const glm::ivec3 factor = coarserFactor(scene.worldFromIndex, scene.volume->grid().size,
                                          std::min(sweep_.columnWidth(), sweep_.rowHeight()));
  glm::dmat4 sceneFromIndex = scene.worldFromIndex;
  if (factor != glm::ivec3(1)) {
    report(progress, "making the volume coarser", 0);
    coarser = averagedInRange(*scene.volume, factor, range_);
    sceneFromIndex = sceneFromIndex * wholeFromLevelIndex(factor);
  }
  const ScalarVolume& volume = coarser ? *coarser : *scene.volume;
  const glm::dmat4 indexFromScene = glm::inverse(sceneFromIndex);
  // Where a coarser volume's last voxels cover fewer, its box reaches farther than the volume's.
  const glm::dvec3 upper = glm::dvec3(scene.volume->grid().size) / glm::dvec3(factor) - 0.5;

  size_t bricks = 0;
  for (int i = 0; i < sweep_.slicesPerHalfTurn(); ++i) {
    slices_.push_back(sweptOutline(SweptPlane(indexFromScene, sweep_, i), upper, sweep_));
    slices_.back().firstBrick = bricks;
    bricks += static_cast<size_t>(slices_.back().brickColumns) * static_cast<size_t>(slices_.back().brickRows);
  }
  codes_.assign(bricks * kSweptBrickVoxels, kNothingSwept);
  reaches_.resize(bricks);

  const VolumeShading& shading = scene.appearance.shading;
  // Gradients are told by the voxels of the volume, also where they are those of a coarser one.
  const double bySpacing = 1 / std::cbrt(double(factor.x) * factor.y * factor.z);
  const Weighing weighing{
      .shaded = sampling.shaded && shading.isOn,
      .light = singleLight(gradientLight(sceneFromIndex, shading, range_), bySpacing),
      .fullGradient = static_cast<float>((range_.greatest - range_.least) * sampling.fullLightGradient)};
  std::vector<SweptWeights::Some> weights(slices_.size());
  visitSweptField(volume, [&](const auto& field) {
    const SweptSampler sampler(field, upper, indexFromScene, sweep_, range_, weighing);
    parallelFor(slices_.size(), 1, [&](size_t begin, size_t end) {
      for (size_t i = begin; i < end; ++i) {
        const size_t at = slices_[i].firstBrick;
        sampler.sample(static_cast<int>(i), slices_[i], codes_.data() + at * kSweptBrickVoxels, reaches_.data() + at,
                       weights[i]);
      }
    });
  });
  sampledWeights_ = SweptWeights(bricks, weights);
  report(progress, "sampling the volume", 1);
}

size_t SweptSamples::bytes() const {
  return codes_.size() * sizeof(uint16_t) + sampledWeights_.bytes() + weights_.bytes() +
         reaches_.size() * sizeof(SweptReach);
}

std::optional<size_t> SweptSamples::placeOf(int slice, int column, int row) const {
  const SweptSlice& place = slices_[static_cast<size_t>(slice)];
  const int brickColumn = column / kSweptBrickSide - place.firstBrickColumn;
  const int brickRow = row / kSweptBrickSide - place.firstBrickRow;
  if (brickColumn < 0 || brickColumn >= place.brickColumns || brickRow < 0 || brickRow >= place.brickRows) {
    return std::nullopt;
  }
  const size_t brick = place.firstBrick + static_cast<size_t>(brickRow * place.brickColumns + brickColumn);
  return brick * kSweptBrickVoxels +
         static_cast<size_t>(row % kSweptBrickSide * kSweptBrickSide + column % kSweptBrickSide);
}

uint16_t SweptSamples::codeAt(int slice, int column, int row) const {
  const std::optional<size_t> place = placeOf(slice, column, row);
  return place ? codes_[*place] : kNothingSwept;
}

uint8_t SweptSamples::weightAt(int slice, int column, int row) const {
  const std::optional<size_t> place = placeOf(slice, column, row);
  const uint8_t* ofBrick = place ? weights().of(*place / kSweptBrickVoxels) : nullptr;
  return ofBrick != nullptr ? ofBrick[*place % kSweptBrickVoxels] : 255;
}

void SweptSamples::setPart(const Part& part, const Progress& progress) {
  hasPart_ = static_cast<bool>(part);
  weights_ = {};
  if (!part) {
    return;
  }
  report(progress, "weighing the voxels", 0);
  std::vector<SweptWeights::Some> weights(slices_.size());
  parallelFor(slices_.size(), 1, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      const SweptSlice& place = slices_[i];
      size_t brick = place.firstBrick;
      for (int brickRow = 0; brickRow < place.brickRows; ++brickRow) {
        for (int brickColumn = 0; brickColumn < place.brickColumns; ++brickColumn, ++brick) {
          SweptWeights::Brick made;
          made.fill(255);
          const uint8_t* sampled = sampledWeights_.of(brick);
          for (size_t k = 0; k < kSweptBrickVoxels; ++k) {
            if (codes_[brick * kSweptBrickVoxels + k] == kNothingSwept) {
              continue;
            }
            const int row = (place.firstBrickRow + brickRow) * kSweptBrickSide + static_cast<int>(k) / kSweptBrickSide;
            const int column =
                (place.firstBrickColumn + brickColumn) * kSweptBrickSide + static_cast<int>(k) % kSweptBrickSide;
            const double side = std::max({sweep_.columnWidth(), sweep_.rowHeight(), sweptThickness(sweep_, column)});
            const double share = std::clamp(part(sweep_.voxelCenter(static_cast<int>(i), column, row), side), 0.0, 1.0);
            made[k] = static_cast<uint8_t>((sampled != nullptr ? sampled[k] : 255) * share + 0.5);
          }
          weights[i].add(brick, made);
        }
      }
    }
  });
  weights_ = SweptWeights(bricks(), weights);
  report(progress, "weighing the voxels", 1);
}

}  // namespace ocelli
