// camera.schema.json says what camera_choice.cpp reads.
#include <gtest/gtest.h>

#include <map>
#include <set>

#include "oc_core/base/error.h"
#include "oc_core/base/json_fields.h"
#include "oc_core/ocri/camera_choice.h"
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

/// What the schema allows a camera to say, as {camera: names}.
std::map<std::string, std::set<std::string>> allowedNames() {
  std::map<std::string, std::set<std::string>> allowed;
  for (const nlohmann::json& rule : schema().at("allOf")) {
    for (const nlohmann::json& camera : rule.at("if").at("properties").at("camera").at("enum")) {
      for (const nlohmann::json& name : rule.at("then").at("propertyNames").at("enum")) {
        allowed[camera].insert(name);
      }
    }
  }
  return allowed;
}

TEST(CameraSchema, agreesWithTheReader) {
  for (const auto& [camera, names] : allowedNames()) {
    nlohmann::json ofCamera = schema();
    for (const auto& [name, property] : schema().at("properties").items()) {
      if (!names.contains(name)) {
        ofCamera.at("properties").erase(name);
      }
    }
    test::SchemaAgreement{ofCamera, schemaError, {{"camera", camera}}}.check();
  }
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

TEST(CameraSchema, namesAreThoseOfTheList) {
  std::set<std::string> listed{"ppc"};  // another word for di
  for (const CameraName& camera : cameraNames()) {
    listed.insert(camera.name);
  }
  std::set<std::string> described;
  for (const nlohmann::json& name : schema().at("properties").at("camera").at("enum")) {
    described.insert(name);
    EXPECT_TRUE(allowedNames().contains(name)) << name;
  }
  EXPECT_EQ(described, listed);
}

TEST(CameraSchema, defaultsAreTheReaders) {
  const DdocOptions ddoc;
  const CellOptions cell;
  const std::map<std::string, double> defaults{
      {"cell_side_radii", ddoc.cellSideRadii},
      {"most_samples", cell.mostSamples},
      {"most_satellites", cell.mostSatellites},
      {"safety_factor", ddoc.safetyFactor},
      {"most_hidden_pixels", ddoc.mostHiddenPixels},
      {"room_per_hidden", ddoc.roomPerHidden},
      {"most_hidden_per_room", ddoc.mostHiddenPerRoom},
      {"steepest_band_growth", ddoc.steepestBandGrowth},
      {"smoothing_sigma_pixels", ddoc.smoothingSigmaPixels},
      {"feedback_rounds", ddoc.feedbackRounds},
      {"feedback_shrink", ddoc.feedbackShrink},
      {"harmless_per_hidden_pixel", ddoc.harmlessPerHiddenPixel},
      {"longest_edge_pixels", ddoc.subdivision.longestEdgePixels},
  };
  std::set<std::string> described;
  for (const auto& [name, property] : schema().at("properties").items()) {
    if (property.contains("default") && property.at("type") != "array") {
      described.insert(name);
      ASSERT_TRUE(defaults.contains(name)) << name;
      EXPECT_FLOAT_EQ(property.at("default").get<float>(), static_cast<float>(defaults.at(name))) << name;
    }
  }
  EXPECT_EQ(described.size(), defaults.size());
}

}  // namespace
}  // namespace ocelli
