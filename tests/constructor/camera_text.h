// Cameras from JSON texts, for tests.
#pragma once

#include <string>

#include "oc_core/base/error.h"
#include "oc_core/base/json_fields.h"
#include "tests/ocri/test_scenes.h"

namespace ocelli::test {

/// What `read` makes of the text, in which ' stands for ".
template <class Read>
auto fromText(std::string text, const Read& read) {
  std::replace(text.begin(), text.end(), '\'', '"');
  const nlohmann::json json = parseJson(text, "camera.json");
  JsonFields fields(json, "camera.json");
  fields.has("camera");
  auto camera = read(fields, smallCamera());
  fields.rejectUnknown();
  return camera;
}

/// The message of the InputError that it throws, empty for none.
template <class Read>
std::string errorOf(const std::string& text, const Read& read) {
  try {
    fromText(text, read);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

}  // namespace ocelli::test
