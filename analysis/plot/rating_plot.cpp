#include "analysis/plot/rating_plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "analysis/plot/chart_text.h"

namespace ocelli {
namespace {

constexpr double kBarHeight = 15;
constexpr double kRowHeight = 24;
constexpr double kMeanWidth = 78;
constexpr size_t kNeutral = 2;

/// From the colour of one end over grey to that of the other; lightness falls to both ends.
constexpr std::array<Paint, 5> kAnswerPaints{
    {{0.78, 0.33, 0.0}, {0.96, 0.72, 0.48}, {0.88, 0.88, 0.87}, {0.55, 0.76, 0.92}, {0.0, 0.40, 0.66}}};

Paint inkOn(size_t answer) {
  return answer == 0 || answer == 4 ? kWhite : kTextPaint;
}

size_t totalOf(const RatingPlot::Question& question) {
  return std::accumulate(question.counts.begin(), question.counts.end(), size_t{0});
}

double meanOf(const RatingPlot::Question& question) {
  double sum = 0;
  for (size_t i = 0; i < question.counts.size(); ++i) {
    sum += static_cast<double>((i + 1) * question.counts[i]);
  }
  return sum / static_cast<double>(totalOf(question));
}

/// Shares of all answers left and right of the middle of the neutral ones.
std::array<double, 2> sidesOf(const RatingPlot::Question& question) {
  const auto total = static_cast<double>(totalOf(question));
  const double half = static_cast<double>(question.counts[kNeutral]) / 2;
  return {(static_cast<double>(question.counts[0] + question.counts[1]) + half) / total,
          (static_cast<double>(question.counts[3] + question.counts[4]) + half) / total};
}

void drawBar(Drawing& drawing, const RatingPlot::Question& question, double zero, double pointsPerShare,
             double middle) {
  const auto total = static_cast<double>(totalOf(question));
  double left = zero - pointsPerShare * sidesOf(question)[0];
  for (size_t i = 0; i < question.counts.size(); ++i) {
    const double width = pointsPerShare * static_cast<double>(question.counts[i]) / total;
    if (question.counts[i] > 0) {
      const PlotBox box{left, middle - kBarHeight / 2, left + width, middle + kBarHeight / 2};
      drawing.box(fmt::format("answer {}", i + 1), box, kAnswerPaints[i], Pen{kWhite, kThinLine});
      const std::string count = fmt::format("{}", question.counts[i]);
      if (textWidth(count, Face::kSans, kTextSize) + 3 < width) {
        drawing.text("count", {box.middleX(), middle}, count,
                     {.paint = inkOn(i), .across = Across::kMiddle, .down = Down::kMiddle});
      }
    }
    left += width;
  }
}

double drawKey(Drawing& drawing, const RatingPlot& plot, double width) {
  constexpr double kSwatch = 14;
  const double keyWidth = 5 * kSwatch;
  const double textRoom = (width - keyWidth - 16) / 2;
  const double left = width / 2 - keyWidth / 2;
  for (size_t i = 0; i < kAnswerPaints.size(); ++i) {
    const double x = left + kSwatch * static_cast<double>(i);
    drawing.box("key", {x, 1, x + kSwatch, 12}, kAnswerPaints[i], Pen{kWhite, kThinLine});
    drawing.text("key answer", {x + kSwatch / 2, 6.5}, fmt::format("{}", i + 1),
                 {.paint = inkOn(i), .across = Across::kMiddle, .down = Down::kMiddle});
  }
  drawing.text("lowest", {left - 6, 6.5}, shortened(plot.lowest, Face::kSans, kTextSize, textRoom),
               {.paint = kTextPaint, .across = Across::kRight, .down = Down::kMiddle});
  drawing.text("highest", {left + keyWidth + 6, 6.5}, shortened(plot.highest, Face::kSans, kTextSize, textRoom),
               {.paint = kTextPaint, .down = Down::kMiddle});
  return 20;
}

}  // namespace

Figure ratingFigure(const RatingPlot& plot) {
  std::vector<RatingPlot::Question> questions;
  for (const RatingPlot::Question& question : plot.questions) {
    if (totalOf(question) > 0) {
      questions.push_back(question);
    }
  }
  if (questions.empty()) {
    return emptyFigure(plot.title, plot.widthMillimetres, "no question was answered");
  }
  Figure figure{plot.title,
                fmt::format("Answers from 1 ({}) to 5 ({}).", plot.lowest, plot.highest),
                plot.widthMillimetres * kPointsPerMillimetre,
                0,
                {}};
  double left = 0;  // the most on either side of the middle
  double right = 0;
  for (const RatingPlot::Question& question : questions) {
    left = std::max(left, sidesOf(question)[0]);
    right = std::max(right, sidesOf(question)[1]);
  }
  const double labels = 0.3 * figure.width;
  const double barsLeft = labels + 8;
  const double barsRight = figure.width - kMeanWidth;
  const double pointsPerShare = (barsRight - barsLeft) / (left + right);
  const double zero = barsLeft + pointsPerShare * left;
  double top = drawKey(figure.drawing, plot, figure.width);
  figure.drawing.text("mean title", {figure.width, top}, "n, mean",
                      {.paint = kSoftTextPaint, .across = Across::kRight, .down = Down::kBottom});
  const double bottom = top + kRowHeight * static_cast<double>(questions.size());
  figure.drawing.line("middle", {zero, top}, {zero, bottom}, {kReferencePaint, kThinLine, {2, 2}});
  for (const RatingPlot::Question& question : questions) {
    const double middle = top + kRowHeight / 2;
    const std::vector<std::string> lines = brokenLines(question.text, Face::kSans, kTextSize, labels);
    const size_t shown = std::min<size_t>(lines.size(), 2);
    for (size_t i = 0; i < shown; ++i) {
      const std::string line = i + 1 == shown && shown < lines.size() ? lines[i] + " \u2026" : lines[i];
      const double y = middle + kLineHeight * (static_cast<double>(i) - (static_cast<double>(shown) - 1) / 2);
      figure.drawing.text("question", {labels, y}, shortened(line, Face::kSans, kTextSize, labels),
                          {.paint = kTextPaint, .across = Across::kRight, .down = Down::kMiddle});
    }
    drawBar(figure.drawing, question, zero, pointsPerShare, middle);
    figure.drawing.text("mean", {figure.width, middle},
                        fmt::format("{}, {}", totalOf(question), numberText(meanOf(question), 2)),
                        {.paint = kTextPaint, .across = Across::kRight, .down = Down::kMiddle});
    figure.description += fmt::format(" {}: {} of 1, {} of 2, {} of 3, {} of 4, {} of 5; mean {}.", question.text,
                                      question.counts[0], question.counts[1], question.counts[2], question.counts[3],
                                      question.counts[4], numberText(meanOf(question), 2));
    top += kRowHeight;
  }
  figure.height = top + 2;
  return figure;
}

}  // namespace ocelli
