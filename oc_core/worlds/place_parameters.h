// What the built-in places for seas of images have in common.
#pragma once

#include <vector>

#include "oc_core/scene/builtin_parameters.h"

namespace ocelli {

inline constexpr float kInch = 0.0254f;         ///< metres
inline constexpr float kPlaceEyeHeight = 1.6f;  ///< metres

inline std::vector<BuiltinParameter> placeParameters() {
  return {{"texel", "metres between the vertices that carry the textures, where an eye comes near",
           BuiltinParameter::Kind::kNumber, "0.012", 0.008, 0.2},
          {"seed", "of the random numbers", BuiltinParameter::Kind::kInteger, "1", 0, 1000000}};
}

}  // namespace ocelli
