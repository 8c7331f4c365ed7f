#include "study/responses/key_map.h"

#include "oc_core/base/error.h"

namespace ocelli {

std::vector<KeyMapEntry> keyMapFromText(std::string_view text, const std::string& where) {
  std::vector<KeyMapEntry> map;
  while (!text.empty()) {
    const std::string_view entry = text.substr(0, text.find(','));
    text.remove_prefix(std::min(entry.size() + 1, text.size()));
    const size_t equals = entry.find('=');
    const bool isPair = equals != std::string_view::npos && equals > 0;
    std::string_view name = isPair ? entry.substr(equals + 1) : std::string_view();
    const bool releases = name.starts_with('-');
    name.remove_prefix(releases ? 1 : 0);
    const std::optional<Key> key = keyFromName(name);
    if (!isPair || !key) {
      throw InputError("\"" + std::string(entry) + "\" does not say which key stands for what", where,
                       "such as 1=1,a=Left,b=Enter: keys are A to Z, 0 to 9, Left, Right, Up, Down, Enter, Space, ...");
    }
    map.push_back({std::string(entry.substr(0, equals)), *key, releases});
  }
  return map;
}

}  // namespace ocelli
