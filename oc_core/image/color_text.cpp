#include "oc_core/image/color_text.h"

#include <charconv>
#include <cstdint>

#include "oc_core/image/color.h"

namespace ocelli {

std::optional<glm::vec3> linearFromColorText(std::string_view text) {
  constexpr size_t kLength = 7;
  uint32_t rgb = 0;
  const char* end = text.data() + text.size();
  if (text.size() != kLength || text.front() != '#' || std::from_chars(text.data() + 1, end, rgb, 16).ptr != end) {
    return std::nullopt;
  }
  return glm::vec3(linearFromSrgbByte(static_cast<uint8_t>(rgb >> 16U)),
                   linearFromSrgbByte(static_cast<uint8_t>(rgb >> 8U)), linearFromSrgbByte(static_cast<uint8_t>(rgb)));
}

}  // namespace ocelli
