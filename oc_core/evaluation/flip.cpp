#include "oc_core/evaluation/flip.h"

#include <algorithm>
#include <cmath>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include "oc_core/base/conventions.h"
#include "oc_core/base/parallel.h"
#include "oc_core/evaluation/separable_filter.h"
#include "oc_core/image/color.h"

namespace ocelli {
namespace {

constexpr size_t kGrain = 1 << 13;

// Table 1: the contrast sensitivity of a channel as a sum of Gaussians a sqrt(pi / b) exp(-pi^2 x^2 / b), x in degrees.
struct SensitivityTerm {
  double a, b;
};
constexpr SensitivityTerm kLuminance{1, 0.0047};
constexpr SensitivityTerm kRedGreen{1, 0.0053};
constexpr SensitivityTerm kBlueYellow1{34.1, 0.04};
constexpr SensitivityTerm kBlueYellow2{13.5, 0.025};

constexpr double kFeatureWidthDegrees = 0.082;  // w: peak to trough of the edge detector
constexpr float kColorExponent = 0.7f;          // q_c
constexpr float kFeatureExponent = 0.5f;        // q_f
constexpr float kKnee = 0.4f;                   // p_c, of the largest distance
constexpr float kKneeValue = 0.95f;             // p_t

// Columns: what red, green and blue of linear sRGB add to X, Y and Z under D65.
const glm::mat3 kXyzFromRgb(0.4123865f, 0.2126368f, 0.0193306f, 0.3575915f, 0.7151830f, 0.1191972f, 0.1804505f,
                            0.0721802f, 0.9503726f);

/// Linear RGB to XYZ, relative to white.
glm::vec3 whiteRelative(const glm::vec3& rgb) {
  static const glm::vec3 white = kXyzFromRgb * glm::vec3(1);
  return kXyzFromRgb * rgb / white;
}

/// Luminance, red-green, blue-yellow: L*a*b* without its curve.
glm::vec3 opponentFromRgb(const glm::vec3& rgb) {
  const glm::vec3 t = whiteRelative(rgb);
  return {116 * t.y - 16, 500 * (t.x - t.y), 200 * (t.y - t.z)};
}

glm::vec3 rgbFromOpponent(const glm::vec3& opponent) {
  static const glm::vec3 white = kXyzFromRgb * glm::vec3(1);
  static const glm::mat3 rgbFromXyz = glm::inverse(kXyzFromRgb);
  const float y = (opponent.x + 16) / 116;
  return rgbFromXyz * (glm::vec3(y + opponent.y / 500, y, y - opponent.z / 200) * white);
}

float labCurve(float t) {
  constexpr float kDelta = 6.0f / 29;
  return t > kDelta * kDelta * kDelta ? std::cbrt(t) : t / (3 * kDelta * kDelta) + 4.0f / 29;
}

/// L*a*b*, its chroma scaled with lightness (the Hunt effect: dark colours look less colourful).
glm::vec3 huntLabFromRgb(const glm::vec3& rgb) {
  const glm::vec3 t = whiteRelative(rgb);
  const float y = labCurve(t.y);
  const float lightness = 116 * y - 16;
  return {lightness, 0.01f * lightness * 500 * (labCurve(t.x) - y), 0.01f * lightness * 200 * (y - labCurve(t.z))};
}

/// The HyAB distance to the power of q_c.
float colorDistance(const glm::vec3& a, const glm::vec3& b) {
  const float hyab = std::abs(a.x - b.x) + std::hypot(a.y - b.y, a.z - b.z);
  return std::pow(hyab, kColorExponent);
}

/// Distances up to the knee take most of [0, 1].
float redistributed(float distance) {
  static const float most = colorDistance(huntLabFromRgb({0, 1, 0}), huntLabFromRgb({0, 0, 1}));
  const float knee = kKnee * most;
  return distance < knee ? kKneeValue / knee * distance
                         : kKneeValue + (distance - knee) / (most - knee) * (1 - kKneeValue);
}

Kernel sensitivityKernel(const SensitivityTerm& term, int radius, double pixelsPerDegree) {
  // exp(-pi^2 x^2 / b) has sigma = sqrt(b / 2) / pi degrees.
  return gaussianKernel(static_cast<float>(std::sqrt(term.b / 2) / kPi * pixelsPerDegree), radius);
}

double sum(const Kernel& kernel) {
  double total = 0;
  for (const float weight : kernel) {
    total += weight;
  }
  return total;
}

Image<float> filterBoth(const Image<float>& image, const Kernel& kernel) {
  return filterColumns(filterRows(image, kernel), kernel);
}

/// Filters whose shapes depend on the viewing distance alone.
class FlipFilters {
 public:
  explicit FlipFilters(double pixelsPerDegree) {
    const int radius = static_cast<int>(std::ceil(3 * std::sqrt(kBlueYellow1.b / 2) / kPi * pixelsPerDegree));
    luminance_ = sensitivityKernel(kLuminance, radius, pixelsPerDegree);
    redGreen_ = sensitivityKernel(kRedGreen, radius, pixelsPerDegree);
    blueYellow1_ = sensitivityKernel(kBlueYellow1, radius, pixelsPerDegree);
    blueYellow2_ = sensitivityKernel(kBlueYellow2, radius, pixelsPerDegree);
    // The two terms are added in two dimensions before they are made to sum to 1.
    const auto volume = [&](const SensitivityTerm& term) {
      Kernel samples;
      for (int i = -radius; i <= radius; ++i) {
        const double x = i / pixelsPerDegree;
        samples.push_back(static_cast<float>(std::exp(-kPi * kPi * x * x / term.b)));
      }
      return term.a * std::sqrt(kPi / term.b) * sum(samples) * sum(samples);
    };
    blueYellowShare1_ = static_cast<float>(volume(kBlueYellow1) / (volume(kBlueYellow1) + volume(kBlueYellow2)));
    makeFeatureKernels(static_cast<float>(0.5 * kFeatureWidthDegrees * pixelsPerDegree));
  }

  /// Blurred as seen, clamped to what a screen can show, in Hunt-adjusted L*a*b*.
  Image<glm::vec3> seenColors(const Image<glm::vec3>& opponent) const {
    const Image<float> y = filterBoth(channel(opponent, 0), luminance_);
    const Image<float> cx = filterBoth(channel(opponent, 1), redGreen_);
    const Image<float> blueYellow = channel(opponent, 2);
    const Image<float> cz1 = filterBoth(blueYellow, blueYellow1_);
    const Image<float> cz2 = filterBoth(blueYellow, blueYellow2_);
    Image<glm::vec3> seen(opponent.width(), opponent.height());
    parallelFor(seen.size(), kGrain, [&](size_t begin, size_t end) {
      for (size_t i = begin; i < end; ++i) {
        const float cz = blueYellowShare1_ * cz1[i] + (1 - blueYellowShare1_) * cz2[i];
        seen[i] = huntLabFromRgb(glm::clamp(rgbFromOpponent({y[i], cx[i], cz}), 0.0f, 1.0f));
      }
    });
    return seen;
  }

  struct Features {
    Image<float> edges;
    Image<float> points;
  };

  /// The strength of edges and points of the luminance at each pixel.
  Features features(const Image<glm::vec3>& opponent) const {
    Image<float> y = channel(opponent, 0);
    for (float& value : y) {
      value = (value + 16) / 116;
    }
    const Image<float> smoothRows = filterRows(y, smooth_);
    const auto strength = [&](const Kernel& derivative) {
      const Image<float> alongU = filterColumns(filterRows(y, derivative), smooth_);
      Image<float> strengths = filterColumns(smoothRows, derivative);
      parallelFor(strengths.size(), kGrain, [&](size_t begin, size_t end) {
        for (size_t i = begin; i < end; ++i) {
          strengths[i] = std::sqrt(strengths[i] * strengths[i] + alongU[i] * alongU[i]);
        }
      });
      return strengths;
    };
    return {strength(edge_), strength(point_)};
  }

 private:
  void makeFeatureKernels(float sigma) {
    const int radius = static_cast<int>(std::ceil(3 * sigma));
    smooth_ = gaussianKernel(sigma, radius);
    for (int i = -radius; i <= radius; ++i) {
      const auto x = static_cast<float>(i);
      const float weight = smooth_[static_cast<size_t>(i + radius)];
      edge_.push_back(-x * weight);
      point_.push_back((x * x / (sigma * sigma) - 1) * weight);
    }
    for (Kernel* kernel : {&edge_, &point_}) {
      // Positive weights sum to 1, negative ones to -1.
      float positive = 0;
      float negative = 0;
      for (const float weight : *kernel) {
        (weight > 0 ? positive : negative) += std::abs(weight);
      }
      for (float& weight : *kernel) {
        weight /= weight > 0 ? positive : negative;
      }
    }
  }

  static Image<float> channel(const Image<glm::vec3>& image, int index) {
    Image<float> values(image.width(), image.height());
    for (size_t i = 0; i < image.size(); ++i) {
      values[i] = image[i][index];
    }
    return values;
  }

  Kernel luminance_, redGreen_, blueYellow1_, blueYellow2_;
  float blueYellowShare1_ = 0;
  Kernel smooth_, edge_, point_;
};

Image<glm::vec3> opponentImage(const Image<Rgb8>& image) {
  Image<glm::vec3> opponent(image.width(), image.height());
  for (size_t i = 0; i < image.size(); ++i) {
    const Rgb8& c = image[i];
    opponent[i] = opponentFromRgb({linearFromSrgbByte(c.x), linearFromSrgbByte(c.y), linearFromSrgbByte(c.z)});
  }
  return opponent;
}

}  // namespace

Image<float> flipMap(const Image<Rgb8>& a, const Image<Rgb8>& b, double pixelsPerDegree) {
  OC_CHECK(a.width() == b.width() && a.height() == b.height(), "images to compare have the same size");
  const FlipFilters filters(pixelsPerDegree);
  const Image<glm::vec3> opponentA = opponentImage(a);
  const Image<glm::vec3> opponentB = opponentImage(b);
  const Image<glm::vec3> seenA = filters.seenColors(opponentA);
  const Image<glm::vec3> seenB = filters.seenColors(opponentB);
  const FlipFilters::Features featuresA = filters.features(opponentA);
  const FlipFilters::Features featuresB = filters.features(opponentB);
  Image<float> errors(a.width(), a.height());
  parallelFor(errors.size(), kGrain, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      if (seenA[i] == seenB[i]) {
        continue;
      }
      const float color = redistributed(colorDistance(seenA[i], seenB[i]));
      const float feature = std::max(std::abs(featuresA.edges[i] - featuresB.edges[i]),
                                     std::abs(featuresA.points[i] - featuresB.points[i]));
      errors[i] = std::pow(color, 1 - std::pow(feature / std::sqrt(2.0f), kFeatureExponent));
    }
  });
  return errors;
}

double flip(const Image<Rgb8>& a, const Image<Rgb8>& b, double pixelsPerDegree) {
  OC_CHECK(!a.empty(), "images to compare have pixels");
  double total = 0;
  for (const float error : flipMap(a, b, pixelsPerDegree)) {
    total += static_cast<double>(error);
  }
  return total / static_cast<double>(a.size());
}

}  // namespace ocelli
