#include "oc_core/shade/shade_tables.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>

#include "oc_core/shade/shade_page.h"

namespace ocelli {
namespace {

using testing::HasSubstr;

ShadeReport reportOfTwo() {
  ShadeFigures traced{.name = "traced", .rays = 200, .castRays = 50};
  traced.psnrDecibels = std::numeric_limits<double>::infinity();
  ShadeFigures image{.name = "a, b", .rays = 200, .castRays = 50};
  image.lost = 5;
  image.missing = 2;
  image.cost = {.nodes = 300, .cells = 500, .boxes = 4000, .triangles = 700};
  image.psnrDecibels = 31.25;
  return {.scene = "s", .effect = "reflection", .rows = {traced, image}};
}

TEST(ShadeTables, jsonHasAFieldAColumn) {
  const auto json = nlohmann::json::parse(shadeJson(reportOfTwo()));
  EXPECT_EQ(json["rays"], 200);
  EXPECT_EQ(json["cast_rays"], 50);
  ASSERT_EQ(json["by"].size(), 2u);
  for (const ShadeColumn& column : shadeColumns()) {
    EXPECT_TRUE(json["by"][1].contains(column.field)) << column.field;
  }
  EXPECT_TRUE(json["by"][0]["psnr_db"].is_null()) << "infinity has no JSON form";
  EXPECT_TRUE(json["by"][0]["steps_per_ray"].is_null()) << "no pyramid";
  EXPECT_EQ(json["by"][1]["lost"], 0.1);
  EXPECT_EQ(json["by"][1]["steps_per_ray"], 4.0);
  EXPECT_EQ(json["by"][1]["boxes_per_ray"], 20.0);
}

TEST(ShadeTables, csvHasALineARow) {
  const std::string csv = shadeCsv(reportOfTwo());
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 3);
  EXPECT_THAT(csv, HasSubstr("\"a, b\",200,50,31.25,0.1,0.04,"));
}

TEST(ShadeTables, theTableSaysRatiosInPercent) {
  EXPECT_THAT(shadeTable(reportOfTwo()), HasSubstr("10.00"));
}

TEST(ShadePage, showsEachRowAndEscapesNames) {
  ShadeReport report = reportOfTwo();
  report.rows[1].name = "<x>";
  std::vector<ShadeImages> images;
  for (size_t i = 0; i < report.rows.size(); ++i) {
    images.push_back(shadeImageNames(report.rows[i], i));
  }
  EXPECT_EQ(images[0].errors, "");
  EXPECT_EQ(images[1].errors, "1--x--errors.png");
  const std::string page = shadePage(report, images, 48);
  EXPECT_THAT(page, HasSubstr("&lt;x&gt;"));
  EXPECT_THAT(page, testing::Not(HasSubstr("<x>")));
  EXPECT_THAT(page, HasSubstr("1--x--steps.png"));
}

}  // namespace
}  // namespace ocelli
