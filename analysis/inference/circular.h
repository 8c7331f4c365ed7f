// Directions, which go around: what they have in common, and tests. Angles are in radians here; the mean of a sample is
// that of its unit vectors.
//
//   Fisher 1993, Statistical Analysis of Circular Data, chapter 2: mean direction, mean resultant length, deviation
//   Mardia, Jupp 2000, Directional Statistics, section 6.3: tests of uniformity (Rayleigh; V)
//   Hotelling 1931; Batschelet 1981, Circular Statistics in Biology, chapters 7 and 10: mean vectors of subjects, and
//   of conditions in pairs
//
// Several directions of one subject are not independent: each subject counts once, with its mean vector, whose length
// tells how much its directions agree (two-step analysis, Batschelet 1981, section 10.1).
#pragma once

#include <vector>

#include "analysis/base/estimable.h"
#include "analysis/base/estimate.h"

namespace ocelli {

/// The mean of unit vectors: inside of the unit circle.
struct MeanVector {
  double cosine = 0;
  double sine = 0;

  double length() const;
  double direction() const;  ///< -pi to pi; says nothing where the length is 0
};

/// Of one or more angles. Throws InputError where there are none, or one is not finite.
MeanVector meanVector(const std::vector<double>& angles);
/// Each counts alike, whatever its length.
MeanVector meanVector(const std::vector<MeanVector>& vectors);

/// sqrt(-2 log(length)), radians; infinite where the length is 0 (Fisher 1993, equation 2.12).
double circularDeviation(double length);

/// What subjects have in common, with intervals for other subjects of their kind.
struct CircularMean {
  MeanVector mean{};
  /// Fieller's interval: the directions from which the mean component across is not told by Student's t. It is exact
  /// where mean vectors are normal. Within pi/2 of the value, and so perhaps beyond pi. Impossible where the mean
  /// vector is not clear of the centre: then any direction may be it.
  Estimable<Estimate> direction = Estimable<Estimate>::impossible("");
  /// Of the length, Student's interval of the components along the mean direction, cut at 0 and 1.
  Estimable<Estimate> length = Estimable<Estimate>::impossible("");
};
/// One mean vector a subject. Impossible for fewer than 3, or where all are alike.
Estimable<CircularMean> circularMean(const std::vector<MeanVector>& subjects, double level = 0.95);

/// By how much a second condition is turned from a first one, of the same subjects in the same order. Linearised: the
/// components across each mean, over its length, differ by subject (delta method), with Student's t of n - 1 degrees of
/// freedom. Impossible for fewer than 3 subjects, and where either mean vector is not clear of the centre.
Estimable<Estimate> directionDifference(const std::vector<MeanVector>& first, const std::vector<MeanVector>& second,
                                        double level = 0.95);
/// Of lengths of the mean vectors, second less first, likewise.
Estimable<Estimate> lengthDifference(const std::vector<MeanVector>& first, const std::vector<MeanVector>& second,
                                     double level = 0.95);
/// Hotelling's test of whether mean vectors differ, in direction or length: statistic F, of 2 and n - 2 degrees of
/// freedom (`degreesOfFreedom` has the second). Impossible for fewer than 4 subjects, and where differences have no
/// spread in some direction.
Estimable<Estimate> hotellingDifference(const std::vector<MeanVector>& first, const std::vector<MeanVector>& second);

/// Whether independent angles prefer some direction: value and statistic are the mean resultant length and n times its
/// square. The p value is Wilkie's approximation (1983, Appl. Stat. 32(3); Zar 2010, equation 27.4), which is off by
/// less than 0.002 from 5 angles on. Impossible for fewer than 5.
Estimable<Estimate> rayleighTest(const std::vector<double>& angles);
/// Whether they prefer `expected`: value is the component of the mean vector along it, statistic u; one-sided, by the
/// expansion of Mardia, Jupp 2000 (equation 6.3.7), which R's package circular has too. Impossible for fewer than 5.
Estimable<Estimate> vTest(const std::vector<double>& angles, double expected);

}  // namespace ocelli
