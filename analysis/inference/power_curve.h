// How many subjects suffice, from simulated studies of several sizes: which share of them found what was looked for.
// Power grows with subjects, so shares that fall by chance are pooled first (pool adjacent violators: Barlow,
// Bartholomew, Bremner, Brunk 1972, Statistical Inference under Order Restrictions), and lines join the sizes.
#pragma once

#include <string>
#include <vector>

#include "analysis/inference/binomial_test.h"

namespace ocelli {

struct PowerPoint {
  int subjects = 0;
  Share found;  ///< studies that found it, of all that were simulated: 1 or more
};

/// As far as the simulated sizes tell.
struct NeededSubjects {
  enum class Place {
    kAtMost,   ///< the smallest size is enough already
    kAbout,    ///< between two sizes, or one of them
    kMoreThan  ///< the largest size is not enough
  };
  Place place = Place::kMoreThan;
  double subjects = 0;  ///< by interpolation where kAbout; else the smallest or largest size
};

struct SubjectsForPower {
  NeededSubjects estimate;
  // What the chance of the simulation leaves open: from where exact intervals of `level` at each size reach the power,
  // to where all of them have.
  NeededSubjects fewest;
  NeededSubjects most;
};

/// `power` is between 0 and 1. Throws InputError for no points, sizes that do not rise, and sizes without studies.
SubjectsForPower subjectsForPower(const std::vector<PowerPoint>& points, double power, double level = 0.95);

/// "about 26", "at most 10", "not reached with 50": whole subjects, rounded up.
std::string describe(const NeededSubjects& needed);

}  // namespace ocelli
