// How long a session takes: its trials, practice, reading, forms and breaks.
#pragma once

#include <string>
#include <vector>

#include "study/protocol/schedule.h"

namespace ocelli {

struct Duration {
  double typicalSeconds = 0;
  double longestSeconds = 0;  ///< every trial to the end of its time, all practice; reading and breaks not hurried

  Duration& operator+=(const Duration& other) {
    typicalSeconds += other.typicalSeconds;
    longestSeconds += other.longestSeconds;
    return *this;
  }
};

struct PartLength {
  std::string name;  ///< "consent and forms", a block's name, "breaks"
  int trials = 0;
  Duration duration{};
};

/// The parts of a session, in their order.
std::vector<PartLength> partsOf(const Protocol& protocol, const SessionSchedule& schedule);
Duration durationOf(const std::vector<PartLength>& parts);

/// Breaks after trial `i` (from 0) of a block of the schedule: within it, or after it.
bool hasBreakAfter(const Protocol& protocol, const SessionSchedule& schedule, size_t trial);

}  // namespace ocelli
