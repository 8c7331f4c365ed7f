// What every script of r_script.h begins with: functions that fit one model each, whatever the plan. View conditions
// are marks (view_condition.h); after "_" they are parts of names of R.
#pragma once

namespace ocelli {

extern const char* const kRFunctions;

}  // namespace ocelli
