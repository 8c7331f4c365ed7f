#include "oc_core/drawing/color_scale.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace ocelli {
namespace {

using Triple = std::array<double, 3>;

constexpr Triple kWhitePoint{0.95047, 1, 1.08883};
constexpr double kEdge = 6.0 / 29;
constexpr LabColor kLittle{95, -6, 22};
constexpr LabColor kBetween{57, -46, -10};
constexpr LabColor kMuch{19, 20, -40};

double linearFromSrgb(double value) {
  return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
}

double srgbFromLinear(double value) {
  const double held = std::clamp(value, 0.0, 1.0);
  return held <= 0.0031308 ? 12.92 * held : 1.055 * std::pow(held, 1 / 2.4) - 0.055;
}

double labRoot(double value) {
  return value > kEdge * kEdge * kEdge ? std::cbrt(value) : value / (3 * kEdge * kEdge) + 4.0 / 29;
}

double labCube(double value) {
  return value > kEdge ? value * value * value : 3 * kEdge * kEdge * (value - 4.0 / 29);
}

Paint paintOf(const LabColor& color) {
  const double middle = (color.lightness + 16) / 116;
  const double x = kWhitePoint[0] * labCube(middle + color.a / 500);
  const double y = kWhitePoint[1] * labCube(middle);
  const double z = kWhitePoint[2] * labCube(middle - color.b / 200);
  return {srgbFromLinear(3.2404542 * x - 1.5371385 * y - 0.4985314 * z),
          srgbFromLinear(-0.9692660 * x + 1.8760108 * y + 0.0415560 * z),
          srgbFromLinear(0.0556434 * x - 0.2040259 * y + 1.0572252 * z)};
}

/// A parabola from the first over near the second to the third.
double bent(double first, double second, double third, double t) {
  return (1 - t) * (1 - t) * first + 2 * t * (1 - t) * second + t * t * third;
}

}  // namespace

LabColor labOf(const Paint& paint) {
  const double red = linearFromSrgb(paint.red);
  const double green = linearFromSrgb(paint.green);
  const double blue = linearFromSrgb(paint.blue);
  const double x = labRoot((0.4124564 * red + 0.3575761 * green + 0.1804375 * blue) / kWhitePoint[0]);
  const double y = labRoot((0.2126729 * red + 0.7151522 * green + 0.0721750 * blue) / kWhitePoint[1]);
  const double z = labRoot((0.0193339 * red + 0.1191920 * green + 0.9503041 * blue) / kWhitePoint[2]);
  return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

Paint scaleColor(double share) {
  const double t = std::clamp(share, 0.0, 1.0);
  return paintOf({std::lerp(kLittle.lightness, kMuch.lightness, t), bent(kLittle.a, kBetween.a, kMuch.a, t),
                  bent(kLittle.b, kBetween.b, kMuch.b, t)});
}

}  // namespace ocelli
