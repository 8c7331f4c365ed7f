#include "display_sim/dither_score/dither_images.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

#include "display_sim/dither_score/dither_score.h"
#include "oc_core/base/check.h"

namespace ocelli {
namespace {

constexpr int kGap = 4;

/// The light of a field's pixel in the first slice.
template <class Light>
Image<Rgb8> tile(const DitherField& field, Light&& light) {
  Image<glm::vec3> image(field.columns, field.rows);
  for (int row = 0; row < field.rows; ++row) {
    for (int column = 0; column < field.columns; ++column) {
      image(column, row) = glm::clamp(glm::vec3(light(column, row)), 0.0f, 1.0f);
    }
  }
  return srgbFromLinear(image);
}

void paste(Image<Rgb8>& image, const Image<Rgb8>& part, int left, int top) {
  for (int y = 0; y < part.height(); ++y) {
    for (int x = 0; x < part.width(); ++x) {
      image(left + x, top + y) = part(x, y);
    }
  }
}

// ---- plots

constexpr int kPlotWidth = 300;
constexpr int kOctaveHeight = 32;
constexpr double kMinOctave = -1;
constexpr double kLastOctave = 6;
constexpr int kPlotHeight = static_cast<int>(kLastOctave - kMinOctave) * kOctaveHeight;

Rgb8 colorOf(TestSurface surface) {
  switch (surface) {
    case TestSurface::kFloor:
      return {200, 40, 40};
    case TestSurface::kCylinder:
      return {30, 140, 60};
    case TestSurface::kWall:
      return {40, 80, 210};
    case TestSurface::kFin:
      return {20, 20, 20};
  }
  OC_CHECK(false, "no such surface");
}

struct PlotPlace {
  double x;
  double y;
};

PlotPlace placeOf(const LightSample& sample) {
  const double octave = std::clamp(std::log2(std::max(sample.lightPerArea, 1e-9)), kMinOctave, kLastOctave);
  return {std::min(sample.radius, 1.0) * (kPlotWidth - 1), (kLastOctave - octave) * kOctaveHeight};
}

void dot(Image<Rgb8>& plot, const PlotPlace& place, int size, const Rgb8& color) {
  const int left = static_cast<int>(std::lround(place.x)) - size / 2;
  const int top = static_cast<int>(std::lround(place.y)) - size / 2;
  for (int y = top; y < top + size; ++y) {
    for (int x = left; x < left + size; ++x) {
      if (plot.contains(x, y)) {
        plot(x, y) = color;
      }
    }
  }
}

Image<Rgb8> plotOf(const std::vector<LightSample>& samples) {
  Image<Rgb8> plot(kPlotWidth, kPlotHeight + 1, Rgb8(255));
  for (int i = 0; i <= 10; ++i) {
    for (int y = 0; y < plot.height(); ++y) {
      plot(i * (kPlotWidth - 1) / 10, y) = Rgb8(i % 5 == 0 ? 190 : 225);
    }
  }
  for (int y = 0; y < plot.height(); y += kOctaveHeight) {
    for (int x = 0; x < kPlotWidth; ++x) {
      plot(x, y) = Rgb8(y == static_cast<int>(kLastOctave) * kOctaveHeight ? 150 : 225);
    }
  }
  for (const TestSurface surface : kTestSurfaces) {
    const LightSample* last = nullptr;
    for (const LightSample& sample : samples) {
      if (sample.surface != surface) {
        continue;
      }
      const PlotPlace to = placeOf(sample);
      if (last != nullptr) {
        const PlotPlace from = placeOf(*last);
        const int steps = static_cast<int>(std::abs(to.x - from.x) + std::abs(to.y - from.y)) + 1;
        for (int i = 0; i <= steps; ++i) {
          const double t = static_cast<double>(i) / steps;
          dot(plot, {from.x + (to.x - from.x) * t, from.y + (to.y - from.y) * t}, 2, colorOf(surface));
        }
      }
      dot(plot, to, 4, colorOf(surface));
      last = &sample;
    }
  }
  return plot;
}

}  // namespace

Image<Rgb8> ditherImage(const DitherField& field, std::span<const NamedDither> dithers, int bitsPerChannel) {
  const int across = field.columns + kGap;
  const int down = field.rows + kGap;
  Image<Rgb8> image(4 * across - kGap, static_cast<int>(dithers.size()) * down - kGap, Rgb8(255));
  const std::vector<glm::vec3> wanted = wantedLight(field);
  const std::vector<glm::dvec3> wantedMeans = blockMeans(field, wanted);
  const auto blockOf = [&](int column, int row) {
    return static_cast<size_t>(row / kBlockRows * (field.columns / kBlockColumns) + column / kBlockColumns);
  };
  int top = 0;
  for (const NamedDither& dither : dithers) {
    const std::vector<glm::vec3> shown = shownLight(field, dither.colors, bitsPerChannel);
    const std::vector<glm::dvec3> means = blockMeans(field, shown);
    paste(image, tile(field, [&](int x, int y) { return wanted[field.index(x, y, 0)]; }), 0, top);
    paste(image, tile(field, [&](int x, int y) { return shown[field.index(x, y, 0)]; }), across, top);
    paste(image, tile(field, [&](int x, int y) { return means[blockOf(x, y)]; }), 2 * across, top);
    constexpr double kGrey = 0.2;
    const auto error = [&](int x, int y) { return kGrey + 32.0 * (means[blockOf(x, y)] - wantedMeans[blockOf(x, y)]); };
    paste(image, tile(field, error), 3 * across, top);
    top += down;
  }
  return image;
}

Image<Rgb8> evennessImage(const std::vector<std::vector<LightSample>>& measured) {
  constexpr int kSpace = 12;
  const int plots = static_cast<int>(measured.size());
  Image<Rgb8> image(plots * (kPlotWidth + kSpace) - kSpace, kPlotHeight + 1, Rgb8(255));
  for (int i = 0; i < plots; ++i) {
    paste(image, plotOf(measured[static_cast<size_t>(i)]), i * (kPlotWidth + kSpace), 0);
  }
  return image;
}

}  // namespace ocelli
