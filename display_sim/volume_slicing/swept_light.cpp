#include "display_sim/volume_slicing/swept_light.h"

#include <cmath>
#include <glm/common.hpp>

#include "display_sim/dither/even_light.h"
#include "oc_core/base/check.h"
#include "oc_core/base/parallel.h"
#include "oc_core/volume/transfer_integral.h"

namespace ocelli {
namespace {

/// No display has thinner cells, in display radii: 2^-kThinnestOctaves.
constexpr int kThinnestOctaves = 26;
constexpr int kThickestOctaves = 2;
constexpr int kShifts = 16;
constexpr size_t kOpacityEntries =
    kSweptLogMask + 1 + static_cast<size_t>(kSweptLogSteps) * (kThinnestOctaves + kThickestOctaves);

/// By the logarithm of the optical thickness x, 1 - exp(-x), times 2^wanted. What would exceed 1 is never asked for.
const std::vector<uint16_t>& sweptOpacities(int wanted) {
  static const std::vector<std::vector<uint16_t>> tables = [] {
    std::vector<std::vector<uint16_t>> made(kShifts, std::vector<uint16_t>(kOpacityEntries));
    constexpr double kFull = 1 << kSweptOpacityBits;
    for (size_t i = 0; i < kOpacityEntries; ++i) {
      const double octaves = static_cast<double>(i) / kSweptLogSteps - kSweptLogOctaves - kThinnestOctaves;
      const double opacity = -std::expm1(-std::exp2(octaves));
      for (int shift = 0; shift < kShifts; ++shift) {
        made[static_cast<size_t>(shift)][i] =
            static_cast<uint16_t>(std::min(std::round(std::ldexp(opacity * kFull, shift)), kFull));
      }
    }
    return made;
  }();
  return tables[static_cast<size_t>(wanted)];
}

SweptColumn columnOf(double thickness, double maxExtinction) {
  const double octaves = std::clamp(std::log2(thickness), double{-kThinnestOctaves}, double{kThickestOctaves});
  const auto offset = static_cast<size_t>(std::lround((octaves + kThinnestOctaves) * kSweptLogSteps));
  // A step of the logarithm more than the greatest, as both logarithms are rounded.
  const double opacity = -std::expm1(-maxExtinction * thickness * std::exp2(1.5 / kSweptLogSteps));
  const int shift = opacity > 0 ? std::clamp(static_cast<int>(-std::log2(opacity)), 0, kShifts - 1) : 0;
  return {sweptOpacities(shift).data() + offset, shift};
}

SweptEntry entryOf(const glm::dvec3& color, double extinction) {
  const double log = extinction > 0 ? std::round((std::log2(extinction) + kSweptLogOctaves) * kSweptLogSteps) : 0;
  if (log < 1) {
    return 0;
  }
  constexpr double kFullColor = 1 << kSweptColorBits;
  const glm::dvec3 steps = glm::round(glm::clamp(color, 0.0, 1.0) * kFullColor);
  return static_cast<SweptEntry>(steps.x) | static_cast<SweptEntry>(steps.y) << kSweptFieldBits |
         static_cast<SweptEntry>(steps.z) << (2 * kSweptFieldBits) |
         static_cast<SweptEntry>(std::min(log, double{kSweptLogMask})) << kSweptLogShift;
}

/// Slicers take eight columns at once.
size_t paddedColumns(const SweepGeometry& sweep) {
  return (static_cast<size_t>(sweep.width()) + 7) / 8 * 8;
}

/// Integrals over the values of the range, from its least one, at equal steps.
class EmissionSums {
 public:
  EmissionSums(const TransferFunction& transfer, const ValueRange& range, const SweptLightOptions& options)
      : sums_(kSteps + 1) {
    for (size_t i = 0; i < kSteps; ++i) {
      const auto valueOf = [&](double step) { return std::lerp(range.least, range.greatest, step / kSteps); };
      const auto step = static_cast<double>(i);
      maxExtinction_ = std::max(maxExtinction_, sampleAt(transfer, valueOf(step + 0.5), options).extinction);
      const glm::dvec4 mean = meanBetween(transfer, valueOf(step), valueOf(step + 1), options);
      sums_[i + 1].extinction = sums_[i].extinction + mean.x / kSteps;
      sums_[i + 1].emission = sums_[i].emission + glm::dvec3(mean.y, mean.z, mean.w) / double{kSteps};
    }
  }

  /// Over [first, last], shares of the range, first < last.
  OpticalSample meanOf(double first, double last) const {
    const Sum from = at(first);
    const Sum to = at(last);
    const double extinction = to.extinction - from.extinction;
    if (!(extinction > 0)) {
      return {};
    }
    return {(to.emission - from.emission) / extinction, extinction / (last - first)};
  }

  double maxExtinction() const { return maxExtinction_; }

  static OpticalSample sampleAt(const TransferFunction& transfer, double value, const SweptLightOptions& options) {
    if (options.shown && (value < options.shown->least || value > options.shown->greatest)) {
      return {};
    }
    return transfer.at(value);
  }

 private:
  /// Of what is shown between two values, however thin its peaks: extinction, and colours times it.
  static glm::dvec4 meanBetween(const TransferFunction& transfer, double first, double last,
                                const SweptLightOptions& options) {
    if (!(first < last)) {
      const OpticalSample sample = sampleAt(transfer, first, options);
      return glm::dvec4(1, sample.color) * sample.extinction;
    }
    const double from = options.shown ? std::max(first, options.shown->least) : first;
    const double to = options.shown ? std::min(last, options.shown->greatest) : last;
    return from < to ? transferIntegral(transfer, from, to) / (last - first) : glm::dvec4(0);
  }

  static constexpr size_t kSteps = 8 * (kSweptMeans - 1);
  struct Sum {
    double extinction = 0;
    glm::dvec3 emission{0};
  };

  Sum at(double share) const {
    const double step = share * kSteps;
    const size_t below = std::min(static_cast<size_t>(step), kSteps - 1);
    const double part = step - static_cast<double>(below);
    return {std::lerp(sums_[below].extinction, sums_[below + 1].extinction, part),
            glm::mix(sums_[below].emission, sums_[below + 1].emission, part)};
  }

  std::vector<Sum> sums_;
  double maxExtinction_ = 0;
};

/// Whether there is light between one step of the mean and the next.
std::vector<char> litSegments(const TransferFunction& transfer, const ValueRange& range,
                              const SweptLightOptions& options) {
  std::vector<char> lit(kSweptMeans - 1, 0);
  const double width = range.greatest - range.least;
  const auto valueOf = [&](int step) { return range.least + width * step / (kSweptMeans - 1); };
  for (int i = 0; i + 1 < kSweptMeans; ++i) {
    const double first = valueOf(i);
    const double last = valueOf(i + 1);
    const bool isShown = !options.shown || (options.shown->least <= last && options.shown->greatest >= first);
    lit[static_cast<size_t>(i)] =
        static_cast<char>(isShown && (transfer.at(first).extinction > 0 || transfer.at(last).extinction > 0 ||
                                      std::ranges::any_of(transfer.points(), [&](const TransferPoint& point) {
                                        return point.opacity > 0 && point.value >= first && point.value <= last;
                                      })));
  }
  return lit;
}

template <size_t kCount>
void countBefore(const std::vector<char>& lit, std::array<int, kCount>& counts) {
  counts[0] = 0;
  for (size_t i = 0; i < lit.size(); ++i) {
    counts[i + 1] = counts[i] + lit[i];
  }
}

/// `make(mean, halfSpread)` for all codes but that of nothing.
template <class Make>
void fillEntries(std::vector<SweptEntry>& entries, const Make& make) {
  constexpr size_t kGrain = 64;
  parallelFor(kSweptMeans, kGrain, [&](size_t begin, size_t end) {
    for (size_t mean = begin; mean < end; ++mean) {
      for (size_t spread = 0; spread < kSweptSpreads - 1; ++spread) {
        const auto code = static_cast<uint16_t>(mean << kSweptSpreadBits | spread);
        entries[code] = make(sweptMeanOf(code), sweptHalfSpreadOf(code));
      }
    }
  });
}

}  // namespace

double sweptThickness(const SweepGeometry& sweep, int column) {
  return 2 * double{EvenLight::columnRadius(sweep, column)} * sweep.tanHalfStep();
}

SweptLight::SweptLight(const TransferFunction& transfer, const ValueRange& range, double sceneLengthOfUnit,
                       const SweepGeometry& sweep, const SweptLightOptions& options)
    : SweptLight() {
  OC_CHECK(sceneLengthOfUnit > 0 && options.gain > 0, "lengths and gains are positive");
  const EmissionSums sums(transfer, range, options);
  const double gain = options.gain / sceneLengthOfUnit;
  const double width = range.greatest - range.least;
  fillEntries(entries_, [&](double mean, double halfSpread) {
    const OpticalSample sample = halfSpread > 0
                                     ? sums.meanOf(std::max(mean - halfSpread, 0.0), std::min(mean + halfSpread, 1.0))
                                     : EmissionSums::sampleAt(transfer, range.least + mean * width, options);
    return entryOf(sample.color, sample.extinction * gain);
  });
  countBefore(litSegments(transfer, range, options), litSteps_);
  double maxExtinction = sums.maxExtinction();
  for (const TransferPoint& point : transfer.points()) {
    maxExtinction = std::max(maxExtinction, transfer.at(point.value).extinction);
  }
  for (size_t column = 0; column < paddedColumns(sweep); ++column) {
    addColumn(columnOf(sweptThickness(sweep, static_cast<int>(column)), maxExtinction * gain));
  }
}

SweptLight SweptLight::ofSurface(double value, const glm::dvec3& color, const ValueRange& range,
                                 const SweepGeometry& sweep) {
  const double width = range.greatest - range.least;
  const double wanted = width > 0 ? (value - range.least) / width : value == range.least ? 0 : -1;
  SweptLight light;
  constexpr double kHalfStep = 0.5 / (kSweptMeans - 1);
  // What passes for full light: the opacity rounds to 1.
  constexpr double kOpaque = 16;
  fillEntries(light.entries_, [&](double mean, double halfSpread) -> SweptEntry {
    const double s = 1 - std::abs(mean - wanted) / (2 * std::max(halfSpread, kHalfStep));
    if (s <= 0) {
      return 0;
    }
    return entryOf(color, std::min(-std::log1p(-(3 - 2 * s) * s * s), kOpaque));
  });
  std::vector<char> lit(kSweptMeans - 1, 0);
  if (wanted >= 0 && wanted <= 1) {
    const double step = wanted * (kSweptMeans - 1);
    lit[std::min(static_cast<size_t>(step), lit.size() - 1)] = 1;
    lit[static_cast<size_t>(std::max(std::ceil(step) - 1, 0.0))] = 1;
  }
  countBefore(lit, light.litSteps_);
  for (size_t column = 0; column < paddedColumns(sweep); ++column) {
    light.addColumn(columnOf(1, kOpaque));
  }
  return light;
}

void SweptLight::addColumn(const SweptColumn& column) {
  if (columns_.size() % 8 == 0) {
    shifted_.push_back(0);
  }
  shifted_.back() = static_cast<char>(shifted_.back() | static_cast<char>(column.shift > 0));
  columns_.push_back(column);
}

glm::vec3 SweptLight::lightOf(uint16_t code, int column) const {
  const SweptEntry entry = entries_[code];
  const SweptColumn& at = this->column(column);
  const auto opacity = static_cast<float>(at.opacity[entry >> kSweptLogShift & kSweptLogMask]);
  const auto part = [&](int channel) {
    return static_cast<float>(entry >> (channel * kSweptFieldBits) & 0x1ff) * opacity *
           std::ldexp(1.0f, -kSweptLightBits - at.shift);
  };
  return {part(0), part(1), part(2)};
}

}  // namespace ocelli
