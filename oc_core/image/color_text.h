// Colours as people write them.
#pragma once

#include <glm/vec3.hpp>
#include <optional>
#include <string_view>

namespace ocelli {

/// Linear RGB of "#rrggbb", hexadecimal digits of sRGB bytes in either case; nothing for other texts.
std::optional<glm::vec3> linearFromColorText(std::string_view text);

}  // namespace ocelli
