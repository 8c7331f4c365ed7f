// Times for people, as databases and logs hold them: "2026-01-31T09:30:00.000Z".
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace ocelli {

/// By the clock of this computer, which may jump.
std::string utcNow();
/// Of a time in milliseconds since 1970.
std::string utcText(int64_t milliseconds);
/// The other way round; nothing for what is no such text.
std::optional<int64_t> millisecondsOfUtc(const std::string& text);

}  // namespace ocelli
