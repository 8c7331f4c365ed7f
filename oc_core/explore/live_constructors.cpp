#include <algorithm>

#include "oc_core/base/check.h"
#include "oc_core/base/error.h"
#include "oc_core/explore/live_constructor_rows.h"

namespace ocelli {

const std::vector<LiveConstructorRow>& liveConstructors() {
  static const std::vector<LiveConstructorRow> rows{livePinhole(), livePortal(), liveOccluder(),      liveTarget(),
                                                    liveMaze(),    livePath(),   liveComprehensive(), liveDrawn()};
  return rows;
}

const LiveConstructorRow& findLiveConstructor(std::string_view name) {
  const auto& rows = liveConstructors();
  const auto found = std::find_if(rows.begin(), rows.end(), [&](const auto& row) { return name == row.name; });
  if (found == rows.end()) {
    std::string names;
    for (const LiveConstructorRow& row : rows) {
      names += names.empty() ? row.name : std::string(", ") + row.name;
    }
    throw InputError("there is no constructor \"" + std::string(name) + "\" to explore with", "explore",
                     "use one of: " + names);
  }
  return *found;
}

const LiveConstructorRow& liveConstructorForOthers() {
  const auto& rows = liveConstructors();
  const auto found = std::find_if(rows.begin(), rows.end(), [](const auto& row) { return row.showsOthers; });
  OC_CHECK(found != rows.end(), "a row shows cameras that were made elsewhere");
  return *found;
}

}  // namespace ocelli
