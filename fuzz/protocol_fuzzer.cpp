// libFuzzer target: any bytes as a protocol. What is read is laid out for some subjects and told.
#include <cstdlib>
#include <string>

#include "oc_core/base/error.h"
#include "study/protocol/check_report.h"
#include "study/protocol/schedule.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  try {
    const ocelli::Protocol protocol = ocelli::protocolFromJsonText(std::string(data, data + size), "fuzz");
    for (int session = 1; session <= protocol.sessions; ++session) {
      for (int slot = 0; slot < 3; ++slot) {
        const ocelli::SessionSchedule schedule = ocelli::scheduleOf(protocol, slot, session, protocol.seed);
        if (schedule.trials.empty()) {
          std::abort();
        }
        ocelli::jsonText(schedule, protocol.conditions.names);
      }
    }
    ocelli::CheckOptions options;
    options.subjects = 3;
    ocelli::checkReport(protocol, options);
  } catch (const ocelli::InputError&) {
    // Any other exception is a finding.
  }
  return 0;
}
