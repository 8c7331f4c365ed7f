// Files of transfer functions, whether their schema says what the reader does, and the presets.
#include "oc_core/volume/transfer_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "oc_core/base/error.h"
#include "oc_core/base/json_fields.h"
#include "oc_core/image/color.h"
#include "oc_core/volume/transfer_presets.h"
#include "tests/base/schema_agreement.h"

namespace ocelli {
namespace {

constexpr const char* kGoodTransfer = R"({"values": "range", "opacity_length": 2,
  "points": [{"value": 0, "opacity": 0}, {"value": 0.5, "color": [0.25, 0.5, 1], "opacity": 0.1},
             {"value": 0.5, "color": "#ff8000", "opacity": 0.2}],
  "shading": {"ambient": 0.5}})";

std::string transferErrorOf(const std::string& text) {
  try {
    transferFromJsonText(text, "text");
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

/// 101 voxels along a line: 0, 1, ... 100.
ScalarVolume hundredVolume() {
  VolumeGrid grid;
  grid.size = {101, 1, 1};
  grid.worldFromIndex = glm::dmat4(2.0);
  grid.worldFromIndex[3] = {0, 0, 0, 1};
  std::vector<float> values(grid.voxelCount());
  std::iota(values.begin(), values.end(), 0.0f);
  return {std::move(grid), std::move(values)};
}

TEST(TransferFile, isRead) {
  const TransferDescription read = transferFromJsonText(kGoodTransfer, "text");
  EXPECT_EQ(read.scale, "range");
  EXPECT_EQ(read.opacityLength, 2);
  ASSERT_EQ(read.points.size(), 3U);
  EXPECT_EQ(read.points[0].color, glm::dvec3(1));
  EXPECT_NEAR(read.points[1].color.y, linearFromSrgb(0.5f), 1e-6);
  EXPECT_EQ(read.points[2].color.y, linearFromSrgbByte(128));
  EXPECT_TRUE(read.shading.isOn);
  EXPECT_EQ(read.shading.ambient, 0.5);
  EXPECT_EQ(read.shading.diffuse, VolumeShading().diffuse);
  EXPECT_FALSE(transferFromJsonText(R"({"points": [{"value": 0, "opacity": 0}]})", "text").shading.isOn);
}

TEST(TransferFile, schemaAgreesWithTheReader) {
  const nlohmann::json schema = readJsonFile(OCELLI_TRANSFER_SCHEMA);
  const nlohmann::json good = nlohmann::json::parse(kGoodTransfer);
  test::SchemaAgreement{schema, transferErrorOf, good}.check();
  const nlohmann::json& properties = schema.at("properties");
  std::vector<std::string> scales;
  for (const TransferScale& scale : transferScales()) {
    scales.emplace_back(scale.name);
  }
  EXPECT_EQ(properties.at("values").at("enum"), nlohmann::json(scales));
  EXPECT_EQ(properties.at("values").at("default"), TransferDescription().scale);

  const auto pointErrorOf = [](const std::string& point) { return transferErrorOf(R"({"points": [)" + point + "]}"); };
  test::SchemaAgreement{properties.at("points").at("items"), pointErrorOf, {{"value", 0}, {"opacity", 0}}}.check();
  const auto shadingErrorOf = [](const std::string& shading) {
    return transferErrorOf(R"({"points": [{"value": 0, "opacity": 0}], "shading": )" + shading + "}");
  };
  const nlohmann::json& described = schema.at("$defs").at("shading");
  test::SchemaAgreement{described, shadingErrorOf}.check();
  const VolumeShading usual;
  const nlohmann::json& shading = described.at("properties");
  EXPECT_EQ(shading.at("ambient").at("default"), usual.ambient);
  EXPECT_EQ(shading.at("diffuse").at("default"), usual.diffuse);
  EXPECT_EQ(shading.at("specular").at("default"), usual.specular);
  EXPECT_EQ(shading.at("shininess").at("default"), usual.shininess);
}

TEST(TransferFile, refusesColoursAndOrdersThatAreWrong) {
  using testing::HasSubstr;
  const auto errorOfColor = [](const std::string& color) {
    return transferErrorOf(R"({"points": [{"value": 0, "opacity": 0, "color": )" + color + "}]}");
  };
  for (const char* bad :
       {R"("red")", R"("#12345")", R"("#1234567")", R"("#12345g")", R"("#+12345")", "[0, 0, 2]", "[0, 0]", "true"}) {
    EXPECT_THAT(errorOfColor(bad), HasSubstr("\"color\"")) << bad;
  }
  EXPECT_THAT(transferErrorOf("{\"points\": [{\"value\": 1, \"opacity\": 0},\n{\"value\": 0, \"opacity\": 0}]}"),
              testing::AllOf(HasSubstr("text:2"), HasSubstr("less than that of the point before")));
}

TEST(TransferFile, comesBackAsItWasWritten) {
  for (const TransferPreset& preset : transferPresets()) {
    const std::string text = transferToJsonText(preset.description);
    const TransferDescription back = transferFromJsonText(text, preset.name);
    EXPECT_EQ(transferToJsonText(back), text);
    ASSERT_EQ(back.points.size(), preset.description.points.size());
    for (size_t i = 0; i < back.points.size(); ++i) {
      EXPECT_EQ(back.points[i].value, preset.description.points[i].value);
      EXPECT_EQ(back.points[i].opacity, preset.description.points[i].opacity);
      EXPECT_EQ(back.points[i].color, preset.description.points[i].color) << text;
    }
    EXPECT_EQ(back.shading.isOn, preset.description.shading.isOn);
  }
  // No bytes of sRGB are this colour.
  const TransferDescription odd{.points = {{0.1 + 0.2, {0.1234, 0, 1}, 0.5}}, .opacityLength = 1e-7};
  const std::string text = transferToJsonText(odd);
  EXPECT_THAT(text, testing::HasSubstr("\"value\": 0.3,"));
  const TransferDescription back = transferFromJsonText(text, "text");
  // Six digits of sRGB.
  EXPECT_NEAR(back.points[0].color.x, 0.1234, 3e-6);
  EXPECT_EQ(back.opacityLength, 1e-7);
}

TEST(TransferFile, fitsItsVolume) {
  const ScalarVolume volume = hundredVolume();
  TransferDescription description{.scale = "range", .points = {{0.25, {}, 0}, {1.5, {}, 0.5}}};
  const VolumeAppearance byRange = appearanceOf(description, volume, 2);
  EXPECT_EQ(byRange.transfer.points()[0].value, 25);
  EXPECT_EQ(byRange.transfer.points()[1].value, 150);
  EXPECT_EQ(byRange.transfer.opacityLength(), 2);
  description.scale = "percentiles";
  description.opacityLength = 7;
  const VolumeAppearance byPercentiles = appearanceOf(description, volume, 2);
  // The second and the 100th of the 101 voxels are the first below which 1 % and 99 % of them are.
  EXPECT_EQ(byPercentiles.transfer.points()[0].value, 1 + 0.25 * 98);
  EXPECT_EQ(byPercentiles.transfer.opacityLength(), 7);
  const TransferDescription absolute = describe(byRange);
  EXPECT_EQ(absolute.scale, "absolute");
  EXPECT_EQ(absolute.points[1].value, 150);
  EXPECT_EQ(absolute.opacityLength, 2);
}

TEST(TransferFile, fitsAMaskOfFewVoxelsByItsRange) {
  VolumeGrid grid;
  grid.size = {1000, 1, 1};
  std::vector<float> values(grid.voxelCount(), 0);
  values[10] = 2;
  const TransferDescription description{.scale = "percentiles", .points = {{0.25, {}, 0}, {1, {}, 0.5}}};
  const ScalarVolume mask(grid, values);
  EXPECT_TRUE(hasScaleFor(description, mask));
  const VolumeAppearance appearance = appearanceOf(description, mask, 1);
  EXPECT_EQ(appearance.transfer.points()[0].value, 0.5);
  EXPECT_EQ(appearance.transfer.points()[1].value, 2);
  EXPECT_EQ(appearance.transfer.points()[1].opacity, 0.5);
}

TEST(TransferFile, showsNothingOfOneValueByARelativeScale) {
  VolumeGrid grid;
  grid.size = {8, 1, 1};
  const ScalarVolume flat(grid, std::vector<float>(grid.voxelCount(), 3));
  TransferDescription description{.points = {{0.25, {}, 0}, {1, {}, 0.5}}};
  for (const std::string scale : {"range", "percentiles"}) {
    description.scale = scale;
    EXPECT_FALSE(hasScaleFor(description, flat));
    const VolumeAppearance appearance = appearanceOf(description, flat, 1);
    for (const TransferPoint& point : appearance.transfer.points()) {
      EXPECT_EQ(point.opacity, 0) << scale;
    }
  }
  description.scale = "absolute";
  EXPECT_TRUE(hasScaleFor(description, flat));
  EXPECT_EQ(appearanceOf(description, flat, 1).transfer.points()[1].opacity, 0.5);
}

TEST(TransferPresets, areFoundByNameAndFitWhatIsKnownOfAVolume) {
  EXPECT_EQ(transferByName("ct-bone").points.size(), transferPresets().front().description.points.size());
  EXPECT_THROW(transferByName("no-such"), InputError);
  try {
    transferByName("no-such");
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("mr-brain"));
  }
  ScalarVolume volume = hundredVolume();
  EXPECT_EQ(presetFor(volume).name, "ramp");
  volume.setFacts({.modality = "MR"});
  EXPECT_EQ(presetFor(volume).name, "mr-default");
  volume.setFacts({.valueUnit = "HU"});
  EXPECT_EQ(presetFor(volume).name, "ct-bone");

  VolumeGrid patient;
  patient.size = {2, 1, 1};
  patient.isAnatomical = true;
  EXPECT_EQ(presetFor({patient, {-1024, 1500}}).name, "ct-bone");
  EXPECT_EQ(presetFor({patient, {0, 1500}}).name, "mr-default");
}

TEST(TransferPresets, growLighterWithDensity) {
  // What stands for more must be lighter, for people who see no hues: of those that are said to be ordered.
  for (const char* name : {"ct-bone", "mr-default", "mr-brain", "ramp", "hot", "cividis"}) {
    double before = -1;
    for (const TransferPoint& point : transferByName(name).points) {
      const double luminance = glm::dot(point.color, glm::dvec3(0.2126, 0.7152, 0.0722));
      EXPECT_GE(luminance, before) << name << " at " << point.value;
      before = luminance;
    }
  }
}

}  // namespace
}  // namespace ocelli
