#include "oc_core/evaluation/flip.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>

#include "tests/evaluation/test_images.h"

namespace ocelli {
namespace {

using test::plain;
using Color = std::array<double, 3>;

const Rgb8 kBlack(0, 0, 0);
const Rgb8 kWhite(255, 255, 255);

/// The published equations one by one, with whole two-dimensional filters, in double precision.
class SlowFlip {
 public:
  explicit SlowFlip(double pixelsPerDegree) : ppd_(pixelsPerDegree) {}

  double mean(const Image<Rgb8>& a, const Image<Rgb8>& b) const {
    double total = 0;
    for (int y = 0; y < a.height(); ++y) {
      for (int x = 0; x < a.width(); ++x) {
        const double color = redistribute(distance(seen(a, x, y), seen(b, x, y)));
        const double edges = std::abs(feature(a, x, y, false) - feature(b, x, y, false));
        const double points = std::abs(feature(a, x, y, true) - feature(b, x, y, true));
        total += std::pow(color, 1 - std::sqrt(std::max(edges, points) / std::sqrt(2.0)));
      }
    }
    return total / static_cast<double>(a.size());
  }

 private:
  static double linear(double encoded) {
    return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
  }
  static Color relativeXyz(const Color& c) {
    const std::array<Color, 3> rows{{{10135552.0 / 24577794, 8788810.0 / 24577794, 4435075.0 / 24577794},
                                     {2613072.0 / 12288897, 8788810.0 / 12288897, 887015.0 / 12288897},
                                     {1425312.0 / 73733382, 8788810.0 / 73733382, 70074185.0 / 73733382}}};
    Color xyz{};
    for (size_t i = 0; i < 3; ++i) {
      xyz[i] = (rows[i][0] * c[0] + rows[i][1] * c[1] + rows[i][2] * c[2]) / (rows[i][0] + rows[i][1] + rows[i][2]);
    }
    return xyz;
  }
  static Color opponent(const Image<Rgb8>& image, int x, int y) {
    const Rgb8& c = image(std::clamp(x, 0, image.width() - 1), std::clamp(y, 0, image.height() - 1));
    const Color t = relativeXyz({linear(c.x / 255.0), linear(c.y / 255.0), linear(c.z / 255.0)});
    return {116 * t[1] - 16, 500 * (t[0] - t[1]), 200 * (t[1] - t[2])};
  }
  static double sensitivity(size_t channel, double degrees2) {
    const auto term = [&](double a, double b) {
      return a * std::sqrt(M_PI / b) * std::exp(-M_PI * M_PI * degrees2 / b);
    };
    return channel == 0 ? term(1, 0.0047) : channel == 1 ? term(1, 0.0053) : term(34.1, 0.04) + term(13.5, 0.025);
  }
  Color seen(const Image<Rgb8>& image, int x, int y) const {
    const int radius = static_cast<int>(std::ceil(3 * std::sqrt(0.04 / (2 * M_PI * M_PI)) * ppd_));
    Color sums{}, weights{};
    for (int v = -radius; v <= radius; ++v) {
      for (int u = -radius; u <= radius; ++u) {
        const Color c = opponent(image, x + u, y + v);
        for (size_t i = 0; i < 3; ++i) {
          const double weight = sensitivity(i, (u * u + v * v) / (ppd_ * ppd_));
          sums[i] += weight * c[i];
          weights[i] += weight;
        }
      }
    }
    const double ty = (sums[0] / weights[0] + 16) / 116;
    const Color t{ty + sums[1] / weights[1] / 500, ty, ty - sums[2] / weights[2] / 200};
    // The published inverse of the matrix above.
    const std::array<Color, 3> rows{{{3.241003275, -1.537398934, -0.498615861},
                                     {-0.969224334, 1.875930071, 0.041554224},
                                     {0.055639423, -0.204011202, 1.057148933}}};
    const Color xyz{t[0] * 0.950428545, t[1], t[2] * 1.088900371};
    Color rgb{};
    for (size_t i = 0; i < 3; ++i) {
      rgb[i] = std::clamp(rows[i][0] * xyz[0] + rows[i][1] * xyz[1] + rows[i][2] * xyz[2], 0.0, 1.0);
    }
    return huntLab(rgb);
  }
  static Color huntLab(const Color& rgb) {
    const auto curve = [](double t) {
      return t > std::pow(6.0 / 29, 3) ? std::cbrt(t) : t * 29 * 29 / (3 * 36) + 4.0 / 29;
    };
    const Color t = relativeXyz(rgb);
    const double lightness = 116 * curve(t[1]) - 16;
    return {lightness, 0.01 * lightness * 500 * (curve(t[0]) - curve(t[1])),
            0.01 * lightness * 200 * (curve(t[1]) - curve(t[2]))};
  }
  static double distance(const Color& a, const Color& b) {
    return std::pow(std::abs(a[0] - b[0]) + std::hypot(a[1] - b[1], a[2] - b[2]), 0.7);
  }
  static double redistribute(double value) {
    const double most = distance(huntLab({0, 1, 0}), huntLab({0, 0, 1}));
    const double knee = 0.4 * most;
    return value < knee ? 0.95 / knee * value : 0.95 + (value - knee) / (most - knee) * 0.05;
  }
  double feature(const Image<Rgb8>& image, int x, int y, bool point) const {
    const double sigma = 0.5 * 0.082 * ppd_;
    const int radius = static_cast<int>(std::ceil(3 * sigma));
    const auto weight = [&](int along, int across) {
      const double gauss = std::exp(-(along * along + across * across) / (2 * sigma * sigma));
      return gauss * (point ? along * along / (sigma * sigma) - 1 : -along);
    };
    double positive = 0, negative = 0;
    for (int v = -radius; v <= radius; ++v) {
      for (int u = -radius; u <= radius; ++u) {
        positive += std::max(weight(u, v), 0.0);
        negative += std::max(-weight(u, v), 0.0);
      }
    }
    double alongU = 0, alongV = 0;
    for (int v = -radius; v <= radius; ++v) {
      for (int u = -radius; u <= radius; ++u) {
        const double value = (opponent(image, x + u, y + v)[0] + 16) / 116;
        alongU += value * weight(u, v) / (weight(u, v) > 0 ? positive : negative);
        alongV += value * weight(v, u) / (weight(v, u) > 0 ? positive : negative);
      }
    }
    return std::hypot(alongU, alongV);
  }

  double ppd_;
};

TEST(Flip, isThePublishedEquations) {
  const Image<Rgb8> noise = test::randomImage(24, 16, 1);
  const Image<Rgb8> otherNoise = test::randomImage(24, 16, 2);
  const Image<Rgb8> smooth = test::gradient(24, 16);
  for (const double pixelsPerDegree : {10.0, 30.0, 67.0}) {
    const SlowFlip slow(pixelsPerDegree);
    // Differences near 0 are raised to powers as low as 0.7: a rounding of 1e-6 grows to 6e-5.
    EXPECT_NEAR(flip(noise, otherNoise, pixelsPerDegree), slow.mean(noise, otherNoise), 2e-4) << pixelsPerDegree;
    EXPECT_NEAR(flip(smooth, test::withNoise(smooth, 30), pixelsPerDegree),
                slow.mean(smooth, test::withNoise(smooth, 30)), 2e-4)
        << pixelsPerDegree;
    EXPECT_NEAR(flip(smooth, noise, pixelsPerDegree), slow.mean(smooth, noise), 2e-4) << pixelsPerDegree;
  }
}

// On plain images nothing is blurred and there are no features: what is left is the distance of the colours.
TEST(Flip, ofPlainImagesFollowsFromTheirColours) {
  EXPECT_NEAR(flip(plain({0, 255, 0}), plain({0, 0, 255})), 1, 1e-5) << "the farthest pair of colours";
  // Green is L*a*b* (87.74, -86.18, 83.18) and blue (32.30, 79.19, -107.86). Chroma times L/100: (-75.61, 72.98) and
  // (25.58, -34.84), so HyAB is 55.44 + 147.87, and to the power of 0.7 it is 41.28. Black to white is 100^0.7 = 25.12,
  // above the knee of 16.51: 0.95 + 0.05 (25.12 - 16.51) / (41.28 - 16.51).
  EXPECT_NEAR(flip(plain(kBlack), plain(kWhite)), 0.9674, 1e-4);
  // Two greys of L* 53.585 and 53.194, 0.391 apart: 0.95 / 16.51 * 0.391^0.7.
  EXPECT_NEAR(flip(plain({128, 128, 128}), plain({127, 127, 127})), 0.0298, 2e-4);
}

TEST(Flip, ofEqualImagesIsZero) {
  for (const Image<Rgb8>& picture : {plain(kWhite), test::gradient(), test::randomImage(20, 30, 1)}) {
    EXPECT_EQ(flip(picture, picture), 0);
  }
}

TEST(Flip, isSymmetricAndGrowsWithNoise) {
  const Image<Rgb8> picture = test::gradient();
  double last = -1;
  for (const int amplitude : {0, 5, 10, 20, 40, 80}) {
    const Image<Rgb8> noisy = test::withNoise(picture, amplitude);
    const double error = flip(picture, noisy);
    EXPECT_GT(error, last) << amplitude;
    EXPECT_EQ(error, flip(noisy, picture));
    last = error;
  }
}

TEST(Flip, staysWithinItsRange) {
  for (const float error : flipMap(test::randomImage(40, 30, 1), test::randomImage(40, 30, 2))) {
    EXPECT_GE(error, 0);
    EXPECT_LE(error, 1);
  }
}

// From afar, a pattern of single pixels blurs to its mean.
TEST(Flip, finePatternsVanishWithDistance) {
  Image<Rgb8> pattern(40, 40);
  for (int y = 0; y < 40; ++y) {
    for (int x = 0; x < 40; ++x) {
      pattern(x, y) = Rgb8((x + y) % 2 == 0 ? 190 : 186);
    }
  }
  const Image<Rgb8> mean = plain({188, 188, 188}, 40, 40);
  double last = 1;
  for (const double pixelsPerDegree : {5.0, 20.0, 40.0, 80.0}) {
    const double error = flip(pattern, mean, pixelsPerDegree);
    EXPECT_LT(error, last) << pixelsPerDegree;
    last = error;
  }
  EXPECT_LT(last, 0.02);
}

TEST(Flip, takesASinglePixel) {
  EXPECT_NEAR(flip(plain(kBlack, 1, 1), plain(kWhite, 1, 1)), 0.9674, 1e-4);
}

TEST(FlipDeathTest, wantsImagesOfOneSize) {
  EXPECT_DEATH(flip(plain(kBlack, 4, 4), plain(kBlack, 5, 4)), "same size");
  EXPECT_DEATH(flip({}, {}), "pixels");
}

}  // namespace
}  // namespace ocelli
