#include "analysis/inference/power_curve.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "oc_core/base/error.h"

namespace ocelli {
namespace {

using Place = NeededSubjects::Place;

void check(const std::vector<PowerPoint>& points, double power) {
  const auto fail = [](const char* what) {
    throw InputError(what, "simulated power",
                     "rising numbers of subjects, with studies of each, and a power between 0 and 1");
  };
  if (points.empty()) {
    fail("there is no number of subjects");
  }
  if (!(power > 0 && power < 1)) {
    fail("this power is not between 0 and 1");
  }
  for (size_t i = 0; i < points.size(); ++i) {
    if (i > 0 && points[i].subjects <= points[i - 1].subjects) {
      fail("the numbers of subjects do not rise");
    }
    if (points[i].found.trials < 1) {
      fail("no study was simulated with one of the numbers of subjects");
    }
  }
}

/// Shares that nowhere fall: neighbours that do have their common share.
std::vector<double> risingShares(const std::vector<PowerPoint>& points) {
  struct Pool {
    double found = 0;
    double studies = 0;
    size_t points = 0;
  };
  std::vector<Pool> pools;
  for (const PowerPoint& point : points) {
    pools.push_back({static_cast<double>(point.found.successes), static_cast<double>(point.found.trials), 1});
    while (pools.size() > 1 && pools[pools.size() - 2].found * pools.back().studies >
                                   pools.back().found * pools[pools.size() - 2].studies) {
      const Pool last = pools.back();
      pools.pop_back();
      pools.back().found += last.found;
      pools.back().studies += last.studies;
      pools.back().points += last.points;
    }
  }
  std::vector<double> shares;
  for (const Pool& pool : pools) {
    shares.insert(shares.end(), pool.points, pool.found / pool.studies);
  }
  return shares;
}

/// Where the line from size `enough` - 1 to size `enough` passes the power; `enough` may be before or behind all.
NeededSubjects crossing(const std::vector<PowerPoint>& points, const std::vector<double>& shares, size_t enough,
                        double power) {
  if (enough == 0) {
    return {Place::kAtMost, static_cast<double>(points.front().subjects)};
  }
  if (enough == points.size()) {
    return {Place::kMoreThan, static_cast<double>(points.back().subjects)};
  }
  const double part = (power - shares[enough - 1]) / (shares[enough] - shares[enough - 1]);
  const double before = points[enough - 1].subjects;
  return {Place::kAbout, before + part * (points[enough].subjects - before)};
}

size_t firstAtLeast(const std::vector<double>& shares, double power) {
  return static_cast<size_t>(std::find_if(shares.begin(), shares.end(), [&](double s) { return s >= power; }) -
                             shares.begin());
}

/// From which size on all of them are.
size_t allAtLeast(const std::vector<double>& shares, double power) {
  return static_cast<size_t>(shares.rend() -
                             std::find_if(shares.rbegin(), shares.rend(), [&](double s) { return s < power; }));
}

bool isLess(const NeededSubjects& a, const NeededSubjects& b) {
  return a.place != b.place ? a.place < b.place : a.subjects < b.subjects;
}

}  // namespace

SubjectsForPower subjectsForPower(const std::vector<PowerPoint>& points, double power, double level) {
  check(points, power);
  std::vector<double> lower;
  std::vector<double> upper;
  for (const PowerPoint& point : points) {
    const Estimate share = clopperPearsonShare(point.found, level);
    lower.push_back(share.lower);
    upper.push_back(share.upper);
  }
  const std::vector<double> shares = risingShares(points);
  SubjectsForPower result;
  result.estimate = crossing(points, shares, firstAtLeast(shares, power), power);
  result.fewest = std::min(crossing(points, upper, firstAtLeast(upper, power), power), result.estimate, isLess);
  result.most = std::max(crossing(points, lower, allAtLeast(lower, power), power), result.estimate, isLess);
  return result;
}

std::string describe(const NeededSubjects& needed) {
  switch (needed.place) {
    case Place::kAtMost:
      return fmt::format("at most {:.0f}", needed.subjects);
    case Place::kAbout:
      return fmt::format("about {:.0f}", std::ceil(needed.subjects - 1e-9));
    case Place::kMoreThan:
      return fmt::format("not reached with {:.0f}", needed.subjects);
  }
  return "";
}

}  // namespace ocelli
