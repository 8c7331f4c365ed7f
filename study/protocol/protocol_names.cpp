#include "study/protocol/protocol.h"

namespace ocelli {

const char* nameOf(TrialOrder order) {
  return order == TrialOrder::kAlternating ? "alternating" : "balanced";
}

const char* nameOf(ResumePolicy policy) {
  switch (policy) {
    case ResumePolicy::kNextTrial:
      return "next_trial";
    case ResumePolicy::kRestartBlock:
      return "restart_block";
    case ResumePolicy::kStop:
      return "stop";
  }
  return "";
}

}  // namespace ocelli
