// Axes: from values to places, and round numbers to mark them with.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace ocelli {

struct AxisTick {
  double value = 0;
  std::string label;  ///< empty for a small one between labelled ones
};

enum class AxisScale { kLinear, kLog };

/// What is known of an axis before there is a place for it.
struct AxisRange {
  AxisScale scale = AxisScale::kLinear;
  double low = 0;
  double high = 1;
  /// Whether the ends move outwards to round values.
  bool roundLow = true;
  bool roundHigh = true;
  bool percent = false;  ///< values are shares, labels say "40 %"
  bool whole = false;    ///< only whole numbers are marked

  /// The range of all values that are finite (and positive, of a log scale), widened where they are all alike. 0 to 1
  /// where there are none, 1 to 10 of a log scale.
  static AxisRange of(const std::vector<double>& values, AxisScale scale = AxisScale::kLinear);
  /// Wide enough for `value` too.
  AxisRange with(double value) const;
  /// Values that are alike up to rounding get room on both sides.
  void widenIfNarrow();
};

class Axis {
 public:
  /// From `from` to `to` in points (of an upward axis, `to` is less). As many labels as fit beside each other:
  /// `labelLength` says how much of the axis a label takes. A range without width is widened.
  Axis(const AxisRange& range, double from, double to, const std::function<double(const std::string&)>& labelLength);

  /// Values beyond the ends are held at them.
  double at(double value) const;
  /// Whether the value is on the axis, ends included.
  bool holds(double value) const;
  double low() const { return low_; }
  double high() const { return high_; }
  double from() const { return from_; }
  double to() const { return to_; }
  AxisScale scale() const { return scale_; }
  const std::vector<AxisTick>& ticks() const { return ticks_; }

 private:
  bool fits(const std::function<double(const std::string&)>& labelLength) const;
  void layLinear(const AxisRange& range, int intervals);
  void layLog(const AxisRange& range, int step);

  AxisScale scale_;
  double low_ = 0;
  double high_ = 1;
  double from_;
  double to_;
  std::vector<AxisTick> ticks_;
};

/// With a true minus sign and groups of thousands; "\u2013" where it is no finite number.
std::string numberText(double value, int decimals);
/// To three digits or so: "0.0123", "1.23", "12.3", "1,230".
std::string shortNumberText(double value);
/// As shares: "43.6 %".
std::string percentText(double share, int decimals = 0);

}  // namespace ocelli
