#include "tests/study_outline/outline_text.h"

#include "oc_core/base/json_fields.h"

namespace ocelli::test {

void withFieldsOf(const std::string& text, ProtocolReading reading,
                  const std::function<void(JsonFields& fields, ProtocolReading reading)>& read) {
  const JsonDocument document(text, "p.json");
  JsonFields fields(document,
                    reading == ProtocolReading::kByStudy ? UnknownFields::kRejected : UnknownFields::kIgnored);
  read(fields, reading);
}

std::string outlineErrorOf(const std::string& text, ProtocolReading reading,
                           const std::function<void(JsonFields& fields, ProtocolReading reading)>& read) {
  try {
    withFieldsOf(text, reading, read);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

}  // namespace ocelli::test
