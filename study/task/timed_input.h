// Input with the time when it came.
#pragma once

#include <cstdint>

#include "oc_core/base/input_event.h"

namespace ocelli {

struct TimedInput {
  InputEvent event;
  int64_t nanoseconds = 0;  ///< when it came, of a clock that never jumps
};

}  // namespace ocelli
