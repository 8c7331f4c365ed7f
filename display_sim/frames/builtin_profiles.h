// The JSON text of the compiled-in profiles; display_profile.h is the interface to them.
#pragma once

#include <string>
#include <vector>

namespace ocelli {

struct BuiltinProfile {
  std::string name;
  std::string json;
};

const std::vector<BuiltinProfile>& builtinProfiles();

}  // namespace ocelli
