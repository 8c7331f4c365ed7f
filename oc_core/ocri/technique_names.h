// The ways to draw a reference image by name: `ocelli render --method`, and `method` of the Python package.
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "oc_core/ocri/camera_choice.h"

namespace ocelli {

struct TechniqueName {
  const char* name;
  Technique technique;
};
inline constexpr std::array<TechniqueName, 3> kTechniqueNames{
    {{"points", Technique::kPoints}, {"hybrid", Technique::kHybrid}, {"raycast", Technique::kRaycast}}};

/// Nothing for other names, such as "raster": with that, a camera builds its image in its own way.
constexpr std::optional<Technique> techniqueNamed(std::string_view name) {
  for (const TechniqueName& each : kTechniqueNames) {
    if (each.name == name) {
      return each.technique;
    }
  }
  return std::nullopt;
}

}  // namespace ocelli
