// What `ocelli study check` tells of a protocol: the schedule of a subject's session, its length, the balance of the
// design over subjects, and warnings.
#pragma once

#include <string>

#include "oc_core/base/progress.h"
#include "study/protocol/protocol.h"

namespace ocelli {

struct CheckOptions {
  int slot = 0;  ///< of the subject whose schedule is told
  int session = 1;
  int subjects = 24;      ///< over which the balance is counted
  bool answers = false;   ///< of each trial
  bool coverage = false;  ///< of the views: takes seconds
  bool asJson = false;
};

std::string checkReport(const Protocol& protocol, const CheckOptions& options, const Progress& progress = {});

}  // namespace ocelli
