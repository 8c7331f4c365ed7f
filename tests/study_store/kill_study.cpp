#include "tests/study_store/kill_study.h"

#include <fmt/format.h>

#include "oc_core/base/sha256.h"
#include "tests/study_session/session_harness.h"

namespace ocelli::test {

Protocol killProtocol() {
  Protocol protocol = smallProtocol();
  protocol.name = "kills";
  protocol.text = "{\"name\": \"kills\"}";
  protocol.sha256 = sha256(protocol.text);
  protocol.sessions = 2;
  for (ProtocolBlock& block : protocol.blocks) {
    block.task = digitTask(9);
  }
  return protocol;
}

std::string lineOf(const AcknowledgedTrial& trial) {
  return fmt::format("stored {} {} {} {} \"{}\" {:016x}", trial.plan, trial.attempt, trial.practice ? 1 : 0,
                     trial.ending, trial.answer, trial.digest);
}

}  // namespace ocelli::test
