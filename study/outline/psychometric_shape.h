// How the share of right answers grows with the level of a stimulus, a row a shape: staircases choose levels by it, and
// an analysis fits it.
//
//   p(level) = guess + (1 - guess - lapse) * F(slope * (ln level - ln threshold))
//
// The greater a level, the easier. Levels are above 0.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace ocelli {

struct PsychometricShape {
  const char* name;  ///< in protocols
  /// F: from 0 to 1, rising.
  double (*value)(double z);
  const char* threshold;  ///< what F is at the threshold, in words
};

/// "weibull": F is 1 - 1/e at the threshold, p then is 1 - exp(-(level / threshold)^slope) (Watson 2017, QUEST+,
/// Journal of Vision 17(3):10); "logistic": a half, p then is 1 / (1 + (threshold / level)^slope).
std::span<const PsychometricShape> psychometricShapes();
/// "weibull, logistic".
std::string psychometricShapeNames();
/// Throws InputError, saying `where`, for another name.
const PsychometricShape& psychometricShape(std::string_view name, const std::string& where);

}  // namespace ocelli
