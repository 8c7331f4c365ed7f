#include "display_sim/dither_score/dither_score.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <glm/common.hpp>
#include <numbers>

#include "oc_core/base/check.h"

namespace ocelli {
namespace {

double meanOfChannels(const glm::dvec3& v) {
  return (v.x + v.y + v.z) / 3;
}

double bandingOf(const DitherField& field, const std::vector<glm::dvec3>& errors) {
  std::vector<glm::dvec3> sums(static_cast<size_t>(field.columns), glm::dvec3(0));
  for (size_t i = 0; i < errors.size(); ++i) {
    sums[i % sums.size()] += errors[i];
  }
  double squares = 0;
  for (const glm::dvec3& sum : sums) {
    const glm::dvec3 mean = sum / static_cast<double>(field.rows * field.slices);
    squares += meanOfChannels(mean * mean);
  }
  return std::sqrt(squares / field.columns);
}

using Wave = std::vector<std::complex<double>>;

/// Waves of 0 to `most` periods in `count` places.
std::vector<Wave> wavesOf(int most, int count) {
  std::vector<Wave> waves;
  for (int periods = 0; periods <= most; ++periods) {
    Wave& wave = waves.emplace_back();
    for (int i = 0; i < count; ++i) {
      wave.push_back(std::polar(1.0, -2 * std::numbers::pi * periods * i / count));
    }
  }
  return waves;
}

/// The power of images at long waves.
class LongWaves {
 public:
  LongWaves(int columns, int rows)
      : across_(wavesOf(columns / kShortest, columns)), down_(wavesOf(rows / kShortest, rows)) {}

  /// Mean over the frequencies, of which the constant is none; 1 for white noise of variance 1.
  double power(const std::vector<double>& image) const {
    double power = 0;
    int frequencies = 0;
    const size_t columns = across_[0].size();
    Wave sums(down_[0].size());
    for (size_t i = 0; i < across_.size(); ++i) {
      for (size_t y = 0; y < sums.size(); ++y) {
        sums[y] = 0;
        for (size_t x = 0; x < columns; ++x) {
          sums[y] += image[y * columns + x] * across_[i][x];
        }
      }
      // Opposite frequencies have the same power: those to the right are enough, and of the upright ones the downward.
      for (size_t k = i == 0 ? 1 : 0; k < down_.size(); ++k) {
        std::complex<double> downward = 0;
        std::complex<double> upward = 0;
        for (size_t y = 0; y < sums.size(); ++y) {
          downward += sums[y] * down_[k][y];
          upward += sums[y] * std::conj(down_[k][y]);
        }
        power += std::norm(downward);
        ++frequencies;
        if (i > 0 && k > 0) {
          power += std::norm(upward);
          ++frequencies;
        }
      }
    }
    return power / frequencies / static_cast<double>(image.size());
  }

 private:
  static constexpr int kShortest = 16;
  std::vector<Wave> across_;
  std::vector<Wave> down_;
};

double blotchesOf(const DitherField& field, const std::vector<glm::dvec3>& errors) {
  const auto size = static_cast<size_t>(field.columns * field.rows);
  const LongWaves waves(field.columns, field.rows);
  double low = 0;
  double all = 0;
  std::vector<double> slice(size);
  for (int i = 0; i < field.slices; ++i) {
    for (int channel = 0; channel < 3; ++channel) {
      for (size_t k = 0; k < size; ++k) {
        slice[k] = errors[static_cast<size_t>(i) * size + k][channel];
        all += slice[k] * slice[k] / static_cast<double>(size);
      }
      low += waves.power(slice);
    }
  }
  return all > 0 ? low / all : 0;
}

}  // namespace

std::vector<glm::vec3> wantedLight(const DitherField& field) {
  std::vector<glm::vec3> light(field.voxels());
  for (int slice = 0; slice < field.slices; ++slice) {
    for (int row = 0; row < field.rows; ++row) {
      for (int column = 0; column < field.columns; ++column) {
        light[field.index(column, row, slice)] = field.color(column, row, slice);
      }
    }
  }
  return light;
}

std::vector<glm::dvec3> blockMeans(const DitherField& field, const std::vector<glm::vec3>& light) {
  OC_CHECK(light.size() == field.voxels() && field.columns % kBlockColumns == 0 && field.rows % kBlockRows == 0 &&
               field.slices % kBlockSlices == 0,
           "a field has whole blocks");
  const int across = field.columns / kBlockColumns;
  const int down = field.rows / kBlockRows;
  std::vector<glm::dvec3> means(static_cast<size_t>(across * down * (field.slices / kBlockSlices)), glm::dvec3(0));
  for (int slice = 0; slice < field.slices; ++slice) {
    for (int row = 0; row < field.rows; ++row) {
      for (int column = 0; column < field.columns; ++column) {
        const int block = (slice / kBlockSlices * down + row / kBlockRows) * across + column / kBlockColumns;
        means[static_cast<size_t>(block)] += glm::dvec3(light[field.index(column, row, slice)]) /
                                             static_cast<double>(kBlockColumns * kBlockRows * kBlockSlices);
      }
    }
  }
  return means;
}

DitherScore scoreDither(const DitherField& field, const std::vector<glm::vec3>& shown) {
  const std::vector<glm::vec3> wanted = wantedLight(field);
  const std::vector<glm::dvec3> shownMeans = blockMeans(field, shown);
  const std::vector<glm::dvec3> wantedMeans = blockMeans(field, wanted);
  DitherScore score;
  glm::dvec3 sum(0);
  for (size_t i = 0; i < shownMeans.size(); ++i) {
    const glm::dvec3 error = shownMeans[i] - wantedMeans[i];
    const glm::dvec3 size = glm::abs(error);
    sum += error;
    score.meanBlockError += meanOfChannels(size);
    score.worstBlockError = std::max({score.worstBlockError, size.x, size.y, size.z});
  }
  score.meanBlockError /= static_cast<double>(shownMeans.size());
  score.bias = meanOfChannels(sum) / static_cast<double>(shownMeans.size());
  std::vector<glm::dvec3> errors(shown.size());
  std::ranges::transform(shown, wanted, errors.begin(),
                         [](const glm::vec3& a, const glm::vec3& b) { return glm::dvec3(a) - glm::dvec3(b); });
  score.banding = bandingOf(field, errors);
  score.blotches = blotchesOf(field, errors);
  return score;
}

}  // namespace ocelli
