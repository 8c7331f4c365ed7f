#include <fmt/format.h>

#include "oc_core/focus/focus_comparison.h"

namespace ocelli {
namespace {

std::string percent(double share) {
  return fmt::format("{:.2f}", 100 * share);
}
std::string twoDigits(double value) {
  return fmt::format("{:.2f}", value);
}
std::string threeDigits(double value) {
  return fmt::format("{:.3f}", value);
}
std::string milliseconds(double value) {
  return fmt::format("{:.1f}", value);
}

}  // namespace

const std::vector<FocusColumn>& focusColumns() {
  using Result = FocusResult;
  using Value = std::optional<double>;
  static const std::vector<FocusColumn> columns{
      {"focus_share", "focus, % of picture", "Share of the picture's pixels that show what is in focus",
       [](const Result& r) -> Value { return r.figures.focusShare; }, percent},
      {"least_focus_rate", "least zoom of focus",
       "Samples for each one of the plain view within the foci, where and in the direction in which there are fewest",
       [](const Result& r) -> Value { return r.figures.leastFocusRate; }, twoDigits},
      {"greatest_focus_rate", "greatest zoom of focus", "The same where and in the direction in which there are most",
       [](const Result& r) -> Value { return r.figures.greatestFocusRate; }, twoDigits},
      {"focus_bend", "bend in focus, %",
       "How far what is straight in the plain view, from border to border of a focus, lies off the line between its "
       "ends, "
       "as a share of that line's length: the greatest of lines along both axes, and both diagonals",
       [](const Result& r) -> Value { return r.figures.focusBend; }, percent},
      {"hidden_share", "context hidden, %", "Share of the context that the picture does not show",
       [](const Result& r) -> Value { return r.figures.hiddenShare; }, percent},
      {"sparse_share", "context below half, %",
       "Share of the context that it shows with less than half the plain view's samples, or does not show",
       [](const Result& r) -> Value { return r.figures.sparseShare; }, percent},
      {"least_context_rate", "least rate of context",
       "Samples for each one of the plain view in what it shows of the context, where and in the direction in which "
       "there are fewest",
       [](const Result& r) -> Value { return r.figures.leastContextRate; }, threeDigits},
      {"context_bend", "bend in context, %",
       "As the bend in the focus, of straight segments as long as an eighth of the height that lie in the context",
       [](const Result& r) -> Value { return r.figures.contextBend; }, percent},
      {"jump_pixels", "jump, pixels",
       "How far apart what lies side by side in the picture is in the plain view, at most: 0 where the picture is "
       "continuous",
       [](const Result& r) -> Value { return r.figures.isContinuous() ? 0 : r.figures.jumpPixels; }, twoDigits},
      {"rate_step", "rate jumps by factor",
       "The greatest factor between the sampling rates on both sides of a place of the picture: 1 where the rate is "
       "continuous",
       [](const Result& r) -> Value { return r.figures.rateStep; }, twoDigits},
      {"rays_milliseconds", "by rays, ms", "Time to draw the picture along its rays: the fastest of the runs",
       [](const Result& r) -> Value { return r.raysMilliseconds; }, milliseconds},
      {"raster_milliseconds", "by raster, ms", "The same by rasterisation, where there is one for it",
       [](const Result& r) { return r.rasterMilliseconds; }, milliseconds}};
  return columns;
}

}  // namespace ocelli
