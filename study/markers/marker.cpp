#include "study/markers/marker.h"

#include <fmt/format.h>

#include "oc_core/base/csv.h"

namespace ocelli {

std::string lineOf(const Marker& marker) {
  return fmt::format("{},{},{},{},{},{},{}", marker.sequence, marker.nanoseconds, marker.code.code, marker.code.name,
                     marker.trial < 0 ? "" : fmt::format("{}", marker.trial), csvText(marker.condition),
                     csvText(marker.answer));
}

}  // namespace ocelli
