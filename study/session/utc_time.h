// The time of day for people: ISO 8601 in UTC with milliseconds.
#pragma once

#include <cstdint>
#include <string>

namespace ocelli {

/// "2026-03-01T12:00:00.000Z" for milliseconds since the beginning of 1970.
std::string utcText(int64_t milliseconds);
/// By the clock of the system.
std::string utcNow();

}  // namespace ocelli
