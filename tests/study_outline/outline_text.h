// Reads a JSON text as a study or as an analysis does.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <type_traits>

#include "study/outline/protocol_reading.h"

namespace ocelli {
class JsonFields;
}

namespace ocelli::test {

inline constexpr ProtocolReading kBothReadings[] = {ProtocolReading::kByStudy, ProtocolReading::kByAnalysis};

/// Calls `read` with the fields of the text, which messages call p.json.
void withFieldsOf(const std::string& text, ProtocolReading reading,
                  const std::function<void(JsonFields& fields, ProtocolReading reading)>& read);

/// What `read` makes of the fields.
template <class Read>
auto readOutline(const std::string& text, ProtocolReading reading, const Read& read) {
  std::optional<std::invoke_result_t<const Read&, JsonFields&, ProtocolReading>> result;
  withFieldsOf(text, reading, [&](JsonFields& fields, ProtocolReading by) { result = read(fields, by); });
  return result.value();
}

/// What it says of them; empty where nothing is wrong.
std::string outlineErrorOf(const std::string& text, ProtocolReading reading,
                           const std::function<void(JsonFields& fields, ProtocolReading reading)>& read);

}  // namespace ocelli::test
