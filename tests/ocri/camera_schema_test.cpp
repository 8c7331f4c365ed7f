// camera.schema.json and docs/cameras.md say what the rows of representations do, and camera_choice.cpp reads that.
#include "oc_core/ocri/camera_schema.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <regex>
#include <set>

#include "oc_core/base/error.h"
#include "oc_core/base/file_bytes.h"
#include "oc_core/base/json_fields.h"
#include "oc_core/ocri/representation_kind.h"
#include "tests/base/schema_agreement.h"
#include "tests/base/temporary_folder.h"

namespace ocelli {
namespace {

const nlohmann::json& schema() {
  static const nlohmann::json schema = readJsonFile(OCELLI_CAMERA_SCHEMA);
  return schema;
}

CameraChoice read(const std::string& text) {
  static const test::TemporaryFolder folder;
  return cameraChoice(folder.write("camera.json", text));
}

std::string schemaError(const std::string& text) {
  try {
    read(text);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

/// The names that a part of the schema lists one by one.
std::vector<std::string> listed(const nlohmann::json& part) {
  return part.contains("anyOf") ? part.at("anyOf").front().at("enum") : part.at("enum");
}

/// What the schema allows a camera to say, as {camera: names}.
std::map<std::string, std::set<std::string>> allowedNames() {
  std::map<std::string, std::set<std::string>> allowed;
  for (const nlohmann::json& rule : schema().at("allOf")) {
    for (const std::string& camera : listed(rule.at("if").at("properties").at("camera"))) {
      for (const nlohmann::json& name : rule.at("then").at("propertyNames").at("enum")) {
        allowed[camera].insert(name);
      }
    }
  }
  return allowed;
}

/// Where a file in the source tree is not what the toolkit would write: the text that belongs there.
std::string leftBeside(const char* name, const std::string& text) {
  const std::filesystem::path path = std::filesystem::temp_directory_path() / name;
  writeFile(path, text);
  return "it should be as in " + path.string();
}

TEST(CameraSchema, theFileIsWhatTheTableSays) {
  const std::string text = cameraSchemaText();
  EXPECT_TRUE(readFile(OCELLI_CAMERA_SCHEMA) == text) << leftBeside("camera.schema.json", text);
}

TEST(CameraSchema, theDocumentationHasTheTable) {
  const std::string table = cameraOptionTable();
  EXPECT_NE(readFile(OCELLI_CAMERA_DOCUMENTATION).find(table), std::string::npos)
      << leftBeside("camera_options.md", table);
}

TEST(CameraSchema, agreesWithTheReader) {
  for (const auto& [camera, names] : allowedNames()) {
    nlohmann::json ofCamera = schema();
    for (const auto& [name, property] : schema().at("properties").items()) {
      if (!names.contains(name)) {
        ofCamera.at("properties").erase(name);
      }
    }
    nlohmann::json base{{"camera", camera}};
    if (names.contains("regions")) {
      base["regions"] = schema().at("properties").at("regions").at("default");
    }
    test::SchemaAgreement{ofCamera, schemaError, base}.check();
  }
}

// What a region may say; that regions lie within the image and apart is for gpc_layout_test.cpp.
TEST(CameraSchema, agreesWithTheReaderOfRegions) {
  const auto errorOfRegion = [](const std::string& region) {
    return schemaError(R"({"camera": "gpc", "sampling": "linear", "regions": [)" + region + "]}");
  };
  test::SchemaAgreement{schema().at("properties").at("regions").at("items"), errorOfRegion}.check();
}

TEST(CameraSchema, eachCameraTakesOnlyWhatItSays) {
  for (const auto& [camera, names] : allowedNames()) {
    for (const auto& [name, property] : schema().at("properties").items()) {
      if (property.contains("default")) {
        const nlohmann::json document{{"camera", camera}, {name, property.at("default")}};
        EXPECT_EQ(schemaError(document.dump()).empty(), names.contains(name)) << camera << " " << name;
      }
    }
  }
}

TEST(CameraSchema, numbersInNamesHaveTheirRange) {
  for (const char* name : {"ldi-1", "ldi-9", "ldi-16"}) {
    EXPECT_EQ(schemaError(nlohmann::json{{"camera", name}}.dump()), "") << name;
  }
  for (const char* name : {"ldi-0", "ldi-17", "ldi-04", "ldi-", "ldi-4x", "ldi--4", "corners-5", "di-4"}) {
    EXPECT_NE(schemaError(nlohmann::json{{"camera", name}}.dump()), "") << name;
  }
  std::vector<std::string> patterns;
  for (const nlohmann::json& each : schema().at("properties").at("camera").at("anyOf")) {
    if (each.contains("pattern")) {
      patterns.push_back(each.at("pattern"));
    }
  }
  ASSERT_EQ(patterns.size(), 1u);
  const std::regex pattern(patterns[0]);
  for (int count = 0; count < 20; ++count) {
    const std::string name = "ldi-" + std::to_string(count);
    EXPECT_EQ(std::regex_match(name, pattern), schemaError(nlohmann::json{{"camera", name}}.dump()).empty()) << name;
  }
}

// What a name says comes before what a file adds to it.
TEST(CameraSchema, optionsChangeWhatTheyName) {
  EXPECT_EQ(read(R"({"camera": "spoc", "far_displacement_per_height": 0.25, "mask_pole": false})").spoc.maskPole,
            false);
  const CameraChoice eoc = read(R"({"camera": "eoc-v", "min_added_pixels": 2, "compact": false, "trim": false})");
  EXPECT_EQ(eoc.eoc.minAddedPixels, 2);
  EXPECT_FALSE(eoc.eoc.compact);
  EXPECT_FALSE(eoc.eoc.trim);
  EXPECT_EQ(eoc.segmentDirection, kVerticalSegment);
  const CameraChoice ddoc = read(R"({"camera": "ddoc", "constant_radius_pixels": 20, "cell_side_radii": 0.5})");
  EXPECT_EQ(ddoc.ddoc.radius, DdocOptions::Radius::kConstant);
  EXPECT_EQ(ddoc.ddoc.constantRadiusPixels, 20);
  // The side of the cell is one, for whoever builds with it and whoever draws it.
  EXPECT_EQ(ddoc.cellSideRadii, 0.5f);
  EXPECT_EQ(ddoc.ddoc.cellSideRadii, 0.5f);
  EXPECT_EQ(ddoc.cell.cell.sideRadii, 0.5f);
}

}  // namespace
}  // namespace ocelli
