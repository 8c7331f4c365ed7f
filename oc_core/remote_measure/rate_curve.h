// What a codec's bytes buy: the error of a stream at several qualities, and between them the bytes that a wanted error
// takes.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace ocelli {

struct RatePoint {
  double rateFactor = 0;
  double bytes = 0;  ///< on the wire
  double flip = 0;   ///< mean over the frames that are judged, without latency
};

/// The bytes at which a stream has this error: between two points along a straight line of the logarithms of both.
/// Nothing where no point is as good, or all are better: then the bytes are more than those of the best, or less than
/// those of the worst one.
std::optional<double> bytesAtFlip(std::vector<RatePoint> curve, double flip);

}  // namespace ocelli
