// A key that a subject pressed or released on a device.
#pragma once

#include <cstdint>

#include "oc_core/base/input_event.h"

namespace ocelli {

struct KeyChange {
  Key key = Key::kSpace;
  bool pressed = true;
  int64_t nanoseconds = 0;  ///< when it came, of the steady clock
  Modifiers modifiers{};
};

}  // namespace ocelli
