// What every script of r_script.h begins with: functions that fit one model each, whatever the plan.
#pragma once

namespace ocelli {

extern const char* const kRFunctions;

}  // namespace ocelli
