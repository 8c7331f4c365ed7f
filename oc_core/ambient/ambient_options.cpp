#include "oc_core/ambient/ambient_options.h"

#include <cmath>

#include "oc_core/base/error.h"

namespace ocelli {

void validate(const AmbientOptions& options) {
  if (!(options.radius >= 0) || !std::isfinite(options.radius)) {
    throw InputError("the radius of ambient occlusion is negative or not finite", "ambient light",
                     "give 0 or more, in world units");
  }
}

}  // namespace ocelli
