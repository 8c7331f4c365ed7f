#include "study/protocol/protocol.h"

namespace ocelli {

std::vector<const ProtocolForm*> formsOf(const Protocol& protocol) {
  std::vector<const ProtocolForm*> forms;
  const auto add = [&](const std::vector<ProtocolForm>& list) {
    for (const ProtocolForm& form : list) {
      forms.push_back(&form);
    }
  };
  if (protocol.demographics) {
    forms.push_back(&*protocol.demographics);
  }
  add(protocol.before);
  for (const ProtocolBlock& block : protocol.blocks) {
    add(block.after);
  }
  add(protocol.after);
  if (protocol.survey) {
    forms.push_back(&*protocol.survey);
  }
  return forms;
}

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
