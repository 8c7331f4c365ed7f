// Who reads a protocol. A study does before it runs: what it does not know, or what is out of range, is an error. An
// analysis does later, from a database that an older or a newer program may have written: it looks at no field that it
// does not need, and its limits are wide.
#pragma once

#include <cstddef>
#include <cstdint>

namespace ocelli {

enum class ProtocolReading : uint8_t { kByStudy, kByAnalysis };

inline constexpr size_t kMaxTitleCharacters = 200;
inline constexpr size_t kMaxParagraphCharacters = 4000;
inline constexpr size_t kMaxStoredCharacters = 1'000'000;  ///< of any text, to an analysis

/// Of a text that may have `ofStudy` characters in a study.
constexpr size_t maxCharacters(ProtocolReading reading, size_t ofStudy) {
  return reading == ProtocolReading::kByStudy ? ofStudy : kMaxStoredCharacters;
}

}  // namespace ocelli
