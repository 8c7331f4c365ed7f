// Which events of a session the experimenter's page tells of, and in which words. Details of events are left out: some
// of them were typed by a person.
#pragma once

#include <string>
#include <string_view>

namespace ocelli {

/// Nothing for events that are no warning.
std::string_view warningOf(std::string_view event);

}  // namespace ocelli
