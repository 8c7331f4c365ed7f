#include "display_sim/frames/svol_metadata.h"

#include <nlohmann/json.hpp>

#include "display_sim/frames/svol_format.h"
#include "oc_core/base/error.h"
#include "oc_core/base/json_fields.h"

namespace ocelli::svol {

void requireMetadata(const std::string& text, const std::string& where) {
  if (text.size() > kMaxMetadataBytes) {
    throw InputError("metadata of " + std::to_string(text.size()) + " bytes (at most 1048576 are allowed)", where,
                     "leave some of it out");
  }
  if (!parseJson(text, where).is_object()) {
    throw InputError("the metadata is no JSON object", where, "write the file again, or give another one");
  }
}

std::vector<std::pair<std::string, std::string>> metadataFields(const std::string& text) {
  std::vector<std::pair<std::string, std::string>> fields;
  const auto object = nlohmann::ordered_json::parse(text, nullptr, true, true);
  for (const auto& [name, value] : object.items()) {
    fields.emplace_back(name, value.is_string() ? value.get<std::string>() : textOfJson(value));
  }
  return fields;
}

std::string withField(const std::string& text, const std::string& name, const std::string& value) {
  auto object = nlohmann::ordered_json::parse(text, nullptr, true, true);
  object[name] = value;
  return textOfJson(object);
}

}  // namespace ocelli::svol
