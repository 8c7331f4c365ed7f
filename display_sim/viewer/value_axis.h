// The values of a volume that the transfer function's pane shows, from left to right: all of them, or a part.
#pragma once

namespace ocelli {

struct ValueAxis {
  double least = 0;
  double greatest = 1;

  double width() const { return greatest - least; }
  /// From 0 at the left end to 1 at the right one, and beyond.
  double shareOf(double value) const { return (value - least) / width(); }
  double valueAt(double share) const { return least + share * width(); }
  bool operator==(const ValueAxis&) const = default;
};

/// An axis that holds both values; where they are the same, some more around them.
ValueAxis axisBetween(double least, double greatest);
/// `factor` above 1 shows less; what is at `value` stays where it is, and nothing beyond `whole` shows.
ValueAxis zoomedAxis(const ValueAxis& axis, const ValueAxis& whole, double value, double factor);
/// Moved by a share of its width, within `whole`.
ValueAxis pannedAxis(const ValueAxis& axis, const ValueAxis& whole, double share);
/// How much of `whole` shows at least, as a share.
inline constexpr double kMinAxisShare = 1e-4;

/// A round number, 1, 2 or 5 times a power of ten, such that about `count` of its multiples lie on the axis.
double tickStep(const ValueAxis& axis, int count);

}  // namespace ocelli
