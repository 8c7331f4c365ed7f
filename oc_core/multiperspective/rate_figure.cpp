#include "oc_core/multiperspective/rate_figure.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "oc_core/drawing/color_scale.h"
#include "oc_core/image/color.h"

namespace ocelli {
namespace {

constexpr double kRateMargin = 24;
constexpr double kRateTitle = 34;
constexpr double kRateLegend = 250;
constexpr double kRateText = 14;
constexpr double kRateBar = 18;
constexpr double kSceneShare = 0.35;  ///< of the scene's brightness in the colours; the rest is the rate
constexpr int kMaxHeatPixels = 1200;  ///< longer side of the map: an SVG holds it as it is

constexpr Paint kRateInk = paintOf(page_color::kText);

/// From the least to the greatest rate there is, on a scale of equal factors.
class RateScale {
 public:
  explicit RateScale(const RateSummary& summary)
      : least_(std::log2(std::min(summary.leastAnywhere, 0.999))),
        greatest_(std::log2(std::max(summary.greatest, 1.001))) {}

  double share(double rate) const { return (std::log2(rate) - least_) / (greatest_ - least_); }
  double rateAt(double share) const { return std::exp2(least_ + share * (greatest_ - least_)); }

 private:
  double least_;
  double greatest_;
};

uint32_t packed(const Paint& paint) {
  const auto byte = [](double value) { return static_cast<uint32_t>(std::lround(255 * std::clamp(value, 0.0, 1.0))); };
  return byte(paint.red) << 16 | byte(paint.green) << 8 | byte(paint.blue);
}

class RateDrawing {
 public:
  RateDrawing(const GpcCamera& camera, const Image<glm::vec3>& seen, const RateFigureOptions& options)
      : camera_(camera),
        seen_(seen),
        options_(options),
        summary_(summarizeRates(camera)),
        colors_(summary_),
        scale_(options.imagePixels / static_cast<double>(std::max(camera.width(), camera.height()))),
        box_{kRateMargin, top(), kRateMargin + camera.width() * scale_, top() + camera.height() * scale_} {}

  Figure figure() {
    Figure figure;
    figure.title = options_.title.empty() ? "Sampling rate of a general pinhole camera" : options_.title;
    figure.description = fmt::format(
        "Sampling rate over an image of {} by {} pixels with {} regions, from {:.3f} to {:.3f} samples for "
        "each one of a pinhole.",
        camera_.width(), camera_.height(), camera_.map().zones().size(), summary_.leastAnywhere, summary_.greatest);
    figure.width = box_.right + 2 * kRateMargin + kRateLegend;
    figure.height = std::max(box_.bottom, top() + 300) + kRateMargin;
    if (!options_.title.empty()) {
      drawing_.text("title", {kRateMargin, kRateMargin + 16}, options_.title, look(19));
    }
    heat();
    for (const GpcZone& zone : camera_.map().zones()) {
      outline(zone);
    }
    drawing_.box("frame", box_, std::nullopt, Pen{paintOf(page_color::kSoft), 1});
    legend(box_.right + kRateMargin, box_.top);
    figure.drawing = std::move(drawing_);
    return figure;
  }

 private:
  double top() const { return kRateMargin + (options_.title.empty() ? 0 : kRateTitle); }
  static TextLook look(double size, const Paint& paint = kRateInk) {
    TextLook look;
    look.size = size;
    look.paint = paint;
    return look;
  }
  PlotPoint at(const glm::dvec2& pixel) const { return {box_.left + pixel.x * scale_, box_.top + pixel.y * scale_}; }
  PlotBox around(const glm::dvec2& center, const glm::dvec2& half) const {
    const PlotPoint a = at(center - half);
    const PlotPoint b = at(center + half);
    return {a.x, a.y, b.x, b.y};
  }

  double brightness(const glm::dvec2& pixel) const {
    if (seen_.empty()) {
      return 1;
    }
    const glm::vec3& c = seen_(std::min(static_cast<int>(pixel.x), seen_.width() - 1),
                               std::min(static_cast<int>(pixel.y), seen_.height() - 1));
    if (c == glm::vec3(0)) {
      return 1;  // nothing is seen
    }
    return static_cast<double>(srgbFromLinear(std::clamp(0.2126f * c.x + 0.7152f * c.y + 0.0722f * c.z, 0.0f, 1.0f)));
  }

  void heat() {
    const double longest = std::max(camera_.width(), camera_.height());
    const double step = std::max(longest / kMaxHeatPixels, 1.0);
    Pixels pixels{
        static_cast<int>(std::ceil(camera_.width() / step)), static_cast<int>(std::ceil(camera_.height() / step)), {}};
    for (int y = 0; y < pixels.height; ++y) {
      for (int x = 0; x < pixels.width; ++x) {
        const glm::dvec2 pixel = (glm::dvec2(x, y) + 0.5) * step;
        const Paint rate = scaleColor(colors_.share(camera_.map().rateAt(pixel)));
        const double light = 1 - kSceneShare + kSceneShare * brightness(pixel);
        pixels.values.push_back(packed({rate.red * light, rate.green * light, rate.blue * light}));
      }
    }
    drawing_.image("rate", box_, std::move(pixels));
  }

  /// The inner edge, the outer one dashed, and the zoom; white below, so that they show on every colour.
  void outline(const GpcZone& zone) {
    const PlotBox inner = around(zone.center(), zone.half());
    const PlotBox outer = around(zone.center(), zone.outerHalf());
    constexpr Paint kWhite{1, 1, 1};
    drawing_.box("inner edge", inner, std::nullopt, Pen{kWhite, 4});
    drawing_.box("inner edge", inner, std::nullopt, Pen{kRateInk, 1.6});
    drawing_.box("outer edge", outer, std::nullopt, Pen{kWhite, 3});
    drawing_.box("outer edge", outer, std::nullopt, Pen{kRateInk, 1.2, {6, 4}});
    TextLook middle = look(16, kWhite);
    middle.across = Across::kMiddle;
    middle.down = Down::kMiddle;
    const std::string text = fmt::format("{:.3g}x", zone.profile().zoom());
    const double width = 10.0 * static_cast<double>(text.size()) + 8;
    drawing_.box("zoom",
                 {inner.middleX() - width / 2, inner.middleY() - 12, inner.middleX() + width / 2, inner.middleY() + 12},
                 kRateInk.faded(0.75));
    drawing_.text("zoom", {inner.middleX(), inner.middleY()}, text, middle);
  }

  void legend(double x, double y) {
    drawing_.text("legend", {x, y + 12}, "samples for each one of a pinhole,", look(kRateText));
    drawing_.text("legend", {x, y + 30}, "in the direction with fewest", look(kRateText));
    const PlotBox bar{x, y + 44, x + kRateBar, y + 204};
    constexpr int kBands = 80;
    for (int i = 0; i < kBands; ++i) {
      const double share = (i + 0.5) / kBands;
      const double height = bar.height() / kBands;
      const double bottom = bar.bottom - i * height;
      drawing_.box("scale", {bar.left, bottom - height - 0.3, bar.right, bottom}, scaleColor(share).faded(1));
    }
    drawing_.box("scale", bar, std::nullopt, Pen{paintOf(page_color::kSoft), 1});
    double last = 1e9;
    const auto tick = [&](double rate) {
      const double height = bar.bottom - colors_.share(rate) * bar.height();
      if (std::abs(height - last) >= kRateText) {
        drawing_.line("tick", {bar.right, height}, {bar.right + 5, height}, Pen{kRateInk, 1});
        drawing_.text("tick", {bar.right + 10, height + 5}, fmt::format("{:.3g}", rate), look(kRateText));
        last = height;
      }
    };
    constexpr int kTicks = 4;
    for (int i = 0; i <= kTicks; ++i) {
      tick(colors_.rateAt(static_cast<double>(i) / kTicks));
    }
    const std::array<std::string, 5> lines{
        fmt::format("sampling: {}", camera_.map().layout().sampling->name),
        fmt::format("least along the axes: {:.4f}", summary_.leastAlongAxes),
        fmt::format("  (linear would have {:.4f})", summary_.highestLeastRate),
        fmt::format("least in any direction: {:.4f}", summary_.leastAnywhere),
        fmt::format("pixels in regions {:.1f} %, around {:.1f} %", 100 * summary_.pixelsInRegions,
                    100 * summary_.pixelsInTransitions)};
    double line = bar.bottom + 30;
    for (const std::string& text : lines) {
      drawing_.text("legend", {x, line}, text, look(kRateText));
      line += 20;
    }
  }

  const GpcCamera& camera_;
  const Image<glm::vec3>& seen_;
  const RateFigureOptions& options_;
  RateSummary summary_;
  RateScale colors_;
  double scale_;
  PlotBox box_;
  Drawing drawing_;
};

}  // namespace

RateSummary summarizeRates(const GpcCamera& camera) {
  RateSummary summary;
  for (const GpcZone& zone : camera.map().zones()) {
    const GpcProfile& profile = zone.profile();
    summary.leastAlongAxes = std::min(summary.leastAlongAxes, profile.leastRate());
    summary.greatest = std::max(summary.greatest, profile.greatestRate());
    summary.highestLeastRate = std::min(summary.highestLeastRate, highestLeastRate(profile.zoom(), profile.outer()));
  }
  summary.leastAnywhere = summary.leastAlongAxes;
  size_t inRegions = 0;
  size_t inTransitions = 0;
  for (int y = 0; y < camera.height(); ++y) {
    for (int x = 0; x < camera.width(); ++x) {
      const glm::dvec2 pixel = glm::dvec2(x, y) + 0.5;
      if (const GpcZone* zone = camera.map().zoneAt(pixel)) {
        summary.leastAnywhere = std::min(summary.leastAnywhere, 1 / singularValues(zone->jacobian(pixel)).x);
        (zone->distance(pixel) <= 1 ? inRegions : inTransitions) += 1;
      }
    }
  }
  const double pixels = static_cast<double>(camera.width()) * camera.height();
  summary.pixelsInRegions = static_cast<double>(inRegions) / pixels;
  summary.pixelsInTransitions = static_cast<double>(inTransitions) / pixels;
  return summary;
}

Figure rateFigure(const GpcCamera& camera, const Image<glm::vec3>& seen, const RateFigureOptions& options) {
  return RateDrawing(camera, seen, options).figure();
}

}  // namespace ocelli
