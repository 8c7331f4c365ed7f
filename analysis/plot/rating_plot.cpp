#include "analysis/plot/rating_plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "analysis/plot/chart_text.h"
#include "oc_core/base/error.h"

namespace ocelli {
namespace {

constexpr double kBarHeight = 15;
constexpr double kRatingRowHeight = 24;
constexpr double kMeanWidth = 78;

// From the colour of one view over grey to that of the other; lightness falls to both ends.
constexpr Paint kFirstPaint{0.78, 0.33, 0.0};
constexpr Paint kMiddlePaint{0.90, 0.90, 0.89};
constexpr Paint kSecondPaint{0.0, 0.40, 0.66};
// Of scales that do not compare views: one hue that darkens.
constexpr Paint kLittlePaint{0.90, 0.90, 0.90};
constexpr Paint kMuchPaint{0.22, 0.24, 0.27};

Paint mixed(const Paint& from, const Paint& to, double share) {
  return {from.red + share * (to.red - from.red), from.green + share * (to.green - from.green),
          from.blue + share * (to.blue - from.blue)};
}

/// From -1 at the first step to 1 at the last.
double offMiddle(size_t step, size_t steps) {
  return steps < 2 ? 0 : 2 * static_cast<double>(step) / static_cast<double>(steps - 1) - 1;
}

Paint paintOf(const RatingPlot& plot, size_t step) {
  const double off = offMiddle(step, plot.steps.size());
  if (!plot.parted) {
    return mixed(kLittlePaint, kMuchPaint, (off + 1) / 2);
  }
  const bool second = (off > 0) == plot.lastIsOther;
  return mixed(kMiddlePaint, second ? kSecondPaint : kFirstPaint, std::abs(off));
}

/// White on dark grounds.
Paint inkOn(const Paint& paint) {
  const double light =
      0.2126 * paint.red * paint.red + 0.7152 * paint.green * paint.green + 0.0722 * paint.blue * paint.blue;
  return light < 0.25 ? kWhite : kTextPaint;
}

size_t totalOf(const RatingPlot::Question& question) {
  return std::accumulate(question.counts.begin(), question.counts.end(), size_t{0});
}

/// Shares of all answers left and right of the middle of the scale; answers at the middle stand half on either side.
struct Sides {
  double left = 0;
  double right = 0;
};

Sides sidesOf(const RatingPlot& plot, const RatingPlot::Question& question) {
  const auto total = static_cast<double>(totalOf(question));
  Sides sides;
  for (size_t i = 0; i < question.counts.size(); ++i) {
    const double share = static_cast<double>(question.counts[i]) / total;
    const double off = offMiddle(i, question.counts.size());
    const double left = !plot.parted || off > 1e-9 ? 0 : off < -1e-9 ? share : share / 2;
    sides.left += left;
    sides.right += share - left;
  }
  return sides;
}

void drawBar(Drawing& drawing, const RatingPlot& plot, const RatingPlot::Question& question, double zero,
             double pointsPerShare, double middle) {
  const auto total = static_cast<double>(totalOf(question));
  double left = zero - pointsPerShare * sidesOf(plot, question).left;
  for (size_t i = 0; i < question.counts.size(); ++i) {
    const double width = pointsPerShare * static_cast<double>(question.counts[i]) / total;
    if (question.counts[i] > 0) {
      const Paint paint = paintOf(plot, i);
      const PlotBox box{left, middle - kBarHeight / 2, left + width, middle + kBarHeight / 2};
      drawing.box(fmt::format("answer {}", i + 1), box, paint, Pen{kWhite, kThinLine});
      const std::string count = fmt::format("{}", question.counts[i]);
      if (textWidth(count, Face::kSans, kTextSize) + 3 < width) {
        drawing.text("count", {box.middleX(), middle}, count,
                     {.paint = inkOn(paint), .across = Across::kMiddle, .down = Down::kMiddle});
      }
    }
    left += width;
  }
}

double drawKey(Drawing& drawing, const RatingPlot& plot, double width) {
  double swatch = 14;
  for (const std::string& step : plot.steps) {
    swatch = std::max(swatch, textWidth(step, Face::kSans, kTextSize) + 5);
  }
  swatch = std::min(swatch, 0.5 * width / static_cast<double>(plot.steps.size()));
  const double keyWidth = static_cast<double>(plot.steps.size()) * swatch;
  const double textRoom = (width - keyWidth - 16) / 2;
  const double left = width / 2 - keyWidth / 2;
  for (size_t i = 0; i < plot.steps.size(); ++i) {
    const double x = left + swatch * static_cast<double>(i);
    const Paint paint = paintOf(plot, i);
    drawing.box("key", {x, 1, x + swatch, 12}, paint, Pen{kWhite, kThinLine});
    drawing.text("key answer", {x + swatch / 2, 6.5}, shortened(plot.steps[i], Face::kSans, kTextSize, swatch),
                 {.paint = inkOn(paint), .across = Across::kMiddle, .down = Down::kMiddle});
  }
  drawing.text("lowest", {left - 6, 6.5}, shortened(plot.lowest, Face::kSans, kTextSize, textRoom),
               {.paint = kTextPaint, .across = Across::kRight, .down = Down::kMiddle});
  drawing.text("highest", {left + keyWidth + 6, 6.5}, shortened(plot.highest, Face::kSans, kTextSize, textRoom),
               {.paint = kTextPaint, .down = Down::kMiddle});
  return 20;
}

std::string endText(const std::string& step, const std::string& meaning) {
  return meaning.empty() ? step : fmt::format("{} ({})", step, meaning);
}

std::string describe(const RatingPlot& plot, const RatingPlot::Question& question) {
  std::string text = fmt::format(" {}:", question.text);
  for (size_t i = 0; i < question.counts.size(); ++i) {
    text += fmt::format("{} {} of {}", i == 0 ? "" : ",", question.counts[i], plot.steps[i]);
  }
  return fmt::format("{}; mean {}.", text, numberText(question.mean, 2));
}

}  // namespace

Figure ratingFigure(const RatingPlot& plot) {
  std::vector<RatingPlot::Question> questions;
  for (const RatingPlot::Question& question : plot.questions) {
    if (question.counts.size() != plot.steps.size()) {
      throw InputError(
          fmt::format("a question has {} counts, but the scale {} steps", question.counts.size(), plot.steps.size()),
          question.text, "one count a step");
    }
    if (totalOf(question) > 0) {
      questions.push_back(question);
    }
  }
  if (questions.empty()) {
    return emptyFigure(plot.title, plot.widthMillimetres, "no question was answered");
  }
  Figure figure{plot.title,
                fmt::format("Answers from {} to {}.", endText(plot.steps.front(), plot.lowest),
                            endText(plot.steps.back(), plot.highest)),
                plot.widthMillimetres * kPointsPerMillimetre,
                0,
                {}};
  Sides most;
  for (const RatingPlot::Question& question : questions) {
    const Sides sides = sidesOf(plot, question);
    most = {std::max(most.left, sides.left), std::max(most.right, sides.right)};
  }
  const double labels = 0.3 * figure.width;
  const double barsLeft = labels + 8;
  const double barsRight = figure.width - kMeanWidth;
  const double pointsPerShare = (barsRight - barsLeft) / (most.left + most.right);
  const double zero = barsLeft + pointsPerShare * most.left;
  double top = drawKey(figure.drawing, plot, figure.width);
  figure.drawing.text("mean title", {figure.width, top}, "n, mean",
                      {.paint = kSoftTextPaint, .across = Across::kRight, .down = Down::kBottom});
  const double bottom = top + kRatingRowHeight * static_cast<double>(questions.size());
  if (plot.parted) {
    figure.drawing.line("middle", {zero, top}, {zero, bottom}, {kReferencePaint, kThinLine, {2, 2}});
  }
  for (const RatingPlot::Question& question : questions) {
    const double middle = top + kRatingRowHeight / 2;
    const std::vector<std::string> lines = brokenLines(question.text, Face::kSans, kTextSize, labels);
    const size_t shown = std::min<size_t>(lines.size(), 2);
    for (size_t i = 0; i < shown; ++i) {
      const std::string line = i + 1 == shown && shown < lines.size() ? lines[i] + " \u2026" : lines[i];
      const double y = middle + kLineHeight * (static_cast<double>(i) - (static_cast<double>(shown) - 1) / 2);
      figure.drawing.text("question", {labels, y}, shortened(line, Face::kSans, kTextSize, labels),
                          {.paint = kTextPaint, .across = Across::kRight, .down = Down::kMiddle});
    }
    drawBar(figure.drawing, plot, question, zero, pointsPerShare, middle);
    figure.drawing.text("mean", {figure.width, middle},
                        fmt::format("{}, {}", totalOf(question), numberText(question.mean, 2)),
                        {.paint = kTextPaint, .across = Across::kRight, .down = Down::kMiddle});
    figure.description += describe(plot, question);
    top += kRatingRowHeight;
  }
  figure.height = top + 2;
  return figure;
}

}  // namespace ocelli
