#include "display_sim/solidity/solidity_report.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/display_sim_slicing/test_profiles.h"

namespace ocelli {
namespace {

SolidityOptions someOptions() {
  return {.profile = test::smallProfile(12, 16, 20), .groups = {{"reference", {{0, 0, 10}}}, {"edges", {{1, 2, 9}}}}};
}

std::vector<SolidityFigures> someFigures() {
  const SolidityErrors exact{.eyes = 1, .light = 8, .hiddenLight = 0, .squaredError = 0, .ssim = 1, .flip = 0};
  const SolidityErrors wrong{.eyes = 2, .light = 8, .hiddenLight = 2, .squaredError = 0.02, .ssim = 1, .flip = 0.5};
  return {{"a \"name\"", 12, 345, 0.25, {exact, wrong}}};
}

TEST(SolidityReport, jsonHasTheMeansOfEachGroup) {
  const auto json = nlohmann::json::parse(solidityJson("builtin:room", someOptions(), someFigures()));
  EXPECT_EQ(json["scene"], "builtin:room");
  EXPECT_EQ(json["image_side"], 20);
  EXPECT_EQ(json["eyes"]["edges"], nlohmann::json::parse("[[1, 2, 9]]"));
  const nlohmann::json& row = json["representations"][0];
  EXPECT_EQ(row["name"], "a \"name\"");
  EXPECT_EQ(row["triangles"], 12);
  EXPECT_EQ(row["lit_voxels"], 345);
  EXPECT_EQ(row["gain"], 0.25);
  EXPECT_TRUE(row["reference"]["psnr_db"].is_null());
  EXPECT_NEAR(row["edges"]["psnr_db"], 20, 1e-9);  // of 0.01
  EXPECT_EQ(row["edges"]["hidden_light"], 0.25);
  EXPECT_EQ(row["edges"]["ssim"], 0.5);
  EXPECT_EQ(row["edges"]["flip"], 0.25);
}

TEST(SolidityReport, tableNamesEachGroupAndRow) {
  const std::string table = solidityTable(someOptions(), someFigures());
  EXPECT_EQ(std::count(table.begin(), table.end(), '\n'), 3);
  for (const char* text : {"reference", "edges", "a \"name\"", "25.00 %", "345", " inf "}) {
    EXPECT_NE(table.find(text), std::string::npos) << text;
  }
}

}  // namespace
}  // namespace ocelli
