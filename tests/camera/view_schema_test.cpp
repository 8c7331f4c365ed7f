// view.schema.json says what view.cpp reads.
#include <gtest/gtest.h>

#include "oc_core/base/error.h"
#include "oc_core/base/json_fields.h"
#include "oc_core/camera/view.h"
#include "tests/base/schema_agreement.h"

namespace ocelli {
namespace {

const nlohmann::json& schema() {
  static const nlohmann::json schema = readJsonFile(OCELLI_VIEW_SCHEMA);
  return schema;
}

std::string errorOf(const std::string& text) {
  try {
    viewFromJsonText(text, "text");
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(ViewSchema, agreesWithTheReader) {
  test::SchemaAgreement{schema(), errorOf}.check();
}

TEST(ViewSchema, defaultsAreTheReaders) {
  for (const auto& [name, property] : schema().at("properties").items()) {
    if (name != "$schema" && name != "comment") {
      EXPECT_EQ(viewFromJsonText(nlohmann::json{{name, property.at("default")}}.dump(), "text"), View{}) << name;
    }
  }
}

}  // namespace
}  // namespace ocelli
