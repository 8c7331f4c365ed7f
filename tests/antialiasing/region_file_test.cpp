// Files of regions, and whether their schema says what the reader does.
#include "oc_core/antialiasing/region_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "oc_core/base/error.h"
#include "oc_core/base/json_fields.h"
#include "tests/base/schema_agreement.h"

namespace ocelli {
namespace {

constexpr const char* kGood =
    R"({"regions": [{"center": [0.5, 0.5], "extent": [0.1, 0.1]}, {"center": [0.25, 0.75], "extent": [0.5, 0.5], "samples_a_side": 24}]})";

std::string errorOf(const std::string& text) {
  try {
    regionsFromJsonText(text, "text");
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

std::string regionErrorOf(const std::string& region) {
  return errorOf(R"({"regions": [)" + region + "]}");
}

TEST(RegionFile, isRead) {
  const std::vector<RegionRequest> regions = regionsFromJsonText(kGood, "text");
  ASSERT_EQ(regions.size(), 2U);
  EXPECT_EQ(regions[0].side, 0);
  EXPECT_EQ(regions[1].center, glm::dvec2(0.25, 0.75));
  EXPECT_EQ(regions[1].side, 24);
}

TEST(RegionFile, schemaAgreesWithTheReader) {
  const nlohmann::json schema = readJsonFile(OCELLI_REGIONS_SCHEMA);
  test::SchemaAgreement{schema, errorOf, nlohmann::json::parse(kGood)}.check();
  const nlohmann::json region = {{"center", {0.5, 0.5}}, {"extent", {0.0001, 0.0001}}};
  const nlohmann::json& described = schema.at("properties").at("regions").at("items");
  test::SchemaAgreement{described, regionErrorOf, region}.check();
  const RegionRequest usual = regionsFromJsonText(R"({"regions": [{}]})", "text").front();
  EXPECT_EQ(described.at("properties").at("center").at("default"), nlohmann::json({usual.center.x, usual.center.y}));
  EXPECT_EQ(described.at("properties").at("extent").at("default"), nlohmann::json({usual.extent.x, usual.extent.y}));
}

TEST(RegionFile, refusesRegionsBeyondTheImage) {
  const std::string message = regionErrorOf(R"({"center": [0.9, 0.5], "extent": [0.3, 0.1]})");
  EXPECT_THAT(message, testing::HasSubstr("text:1"));
  EXPECT_THAT(message, testing::HasSubstr("reach from (0.75, 0.45) to (1.05, 0.55)"));
}

}  // namespace
}  // namespace ocelli
