// One random script of faults against a stream of volumes over an emulated USB, and what must hold whatever it does.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace ocelli {

struct FaultRunResult {
  std::vector<std::string> problems;  ///< what did not hold; empty: all did
  size_t faults = 0;
  size_t framesSubmitted = 0;
  size_t framesAcknowledged = 0;
  size_t reconnections = 0;
  /// From the end of each fault to the next acknowledged frame, in rotations of the screen; not of faults that another
  /// one followed before that.
  std::vector<double> rotationsToReturn;
};

/// Needs a process that sees emulated devices.
FaultRunResult runRandomFaults(uint64_t seed);

/// What this process holds now.
struct Holdings {
  size_t threads = 0;
  size_t descriptors = 0;
  size_t transfers = 0;

  bool exceed(const Holdings& others) const {
    return threads > others.threads || descriptors > others.descriptors || transfers > others.transfers;
  }
};
Holdings holdingsOfThisProcess();

}  // namespace ocelli
