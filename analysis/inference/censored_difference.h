// The difference of two groups' means where some values are known only to be larger (Tobin 1958), by maximum
// likelihood: normal values with one standard deviation. Few enough operations to be repeated in each resample of a
// bootstrap.
#pragma once

#include <map>
#include <optional>

namespace ocelli {

struct CensoredSums {
  double count = 0;  ///< of values that are not censored
  double sum = 0;
  double squares = 0;
  std::map<double, double> above{};  ///< how many lie above each censored value

  void add(double value, bool censored);
};

/// Second less first. Nothing where a group has no value that is not censored, or where these do not vary.
std::optional<double> censoredMeanDifference(const CensoredSums& first, const CensoredSums& second);

}  // namespace ocelli
