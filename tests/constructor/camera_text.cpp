#include "tests/constructor/camera_text.h"

#include <algorithm>

#include "oc_core/base/error.h"
#include "oc_core/base/json_fields.h"

namespace ocelli::test {

void readText(std::string text, const std::function<void(JsonFields&)>& read) {
  std::replace(text.begin(), text.end(), '\'', '"');
  const nlohmann::json json = parseJson(text, "camera.json");
  JsonFields fields(json, "camera.json");
  fields.has("camera");
  read(fields);
  fields.rejectUnknown();
}

std::string errorOfText(const std::string& text, const std::function<void(JsonFields&)>& read) {
  try {
    readText(text, read);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

}  // namespace ocelli::test
