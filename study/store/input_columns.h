// Input events as the columns of the table `input`, and back.
#pragma once

#include <optional>
#include <string>

#include "oc_core/base/input_event.h"

namespace ocelli {

struct InputColumns {
  std::string kind;
  std::optional<std::string> what{};
  std::optional<bool> pressed{};
  std::optional<int> modifiers{};  ///< 1 shift + 2 control + 4 alt
  std::optional<double> x{};
  std::optional<double> y{};
  std::optional<std::string> moreJson{};
};

InputColumns columnsOf(const InputEvent& event);
/// Nothing for columns that no event has.
std::optional<InputEvent> eventOf(const InputColumns& columns);

}  // namespace ocelli
