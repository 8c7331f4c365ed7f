#include "oc_core/shade/shade_report.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>

#include "oc_core/shade/shade_page.h"

namespace ocelli {
namespace {

using testing::HasSubstr;

/// An effect with a column of each kind.
Effect smallEffect() {
  Effect effect{};
  effect.name = "glow";
  effect.title = "Glow";
  effect.mapNote = "";
  effect.columns = {{"rays", nullptr, "hidden", 0, 1},
                    {"psnr_db", "PSNR dB", "of all", 2, 1},
                    {"lost", "lost %", "of a hundred", 2, 100}};
  effect.legend = {{{1, 2, 3}, "a < b"}};
  effect.terms = {{"Term", "What it means."}};
  return effect;
}

struct TwoWays {
  Effect effect = smallEffect();
  ShadeReport report{.scene = "s",
                     .effect = effect,
                     .facts = {{"light", "[1, 2]", "A light."}},
                     .ways = {{.name = "traced", .figures = {200, std::numeric_limits<double>::infinity(), {}}},
                              {.name = "a, b", .figures = {200, 31.25, 0.1}}}};
};

TEST(ShadeReport, jsonHasAFieldAColumnAndAFact) {
  const TwoWays two;
  const auto json = nlohmann::json::parse(shadeJson(two.report));
  EXPECT_EQ(json["effect"], "glow");
  EXPECT_EQ(json["light"][1], 2);
  ASSERT_EQ(json["by"].size(), 2u);
  EXPECT_TRUE(json["by"][0]["psnr_db"].is_null()) << "infinity has no JSON form";
  EXPECT_TRUE(json["by"][0]["lost"].is_null()) << "it has none";
  EXPECT_EQ(json["by"][1]["lost"], 0.1);
  EXPECT_EQ(json["by"][1]["rays"], 200);
}

TEST(ShadeReport, csvHasALineAWay) {
  const TwoWays two;
  EXPECT_EQ(shadeCsv(two.report), "name,rays,psnr_db,lost\ntraced,200,inf,\n\"a, b\",200,31.25,0.1\n");
}

TEST(ShadeReport, theTableSaysRatiosInPercentAndHidesColumnsWithoutHeading) {
  const TwoWays two;
  const std::string table = shadeTable(two.report);
  EXPECT_THAT(table, HasSubstr("10.00"));
  EXPECT_THAT(table, HasSubstr("inf           -\n"));
  EXPECT_THAT(table, testing::Not(HasSubstr("200")));
}

TEST(ShadeReport, theTableLeavesOutColumnsOfWhichNoWayHasAFigure) {
  TwoWays two;
  EXPECT_THAT(shadeTable(two.report), HasSubstr("lost %"));
  two.report.ways[1].figures[2].reset();
  EXPECT_THAT(shadeTable(two.report), testing::Not(HasSubstr("lost %")));
  EXPECT_THAT(shadePage(two.report), testing::Not(HasSubstr("lost %")));
  EXPECT_THAT(shadeCsv(two.report), HasSubstr("lost")) << "files have all columns";
}

TEST(ShadePage, showsEachWayWithItsMapsAndEscapesNames) {
  TwoWays two;
  two.report.ways[1].name = "<x>";
  two.report.ways[1].maps = {{"errors", "what is <wrong>", {}}};
  EXPECT_TRUE(shadeImageNames(two.report.ways[0], 0).maps.empty());
  EXPECT_EQ(shadeImageNames(two.report.ways[1], 1).maps, std::vector<std::string>{"1--x--errors.png"});
  const std::string page = shadePage(two.report);
  EXPECT_THAT(page, HasSubstr("&lt;x&gt;: what is &lt;wrong&gt;"));
  EXPECT_THAT(page, testing::Not(HasSubstr("<x>")));
  EXPECT_THAT(page, HasSubstr("1--x--errors.png"));
  EXPECT_THAT(page, HasSubstr("#010203"));
  EXPECT_THAT(page, HasSubstr("a &lt; b"));
  EXPECT_THAT(page, HasSubstr("A light."));
  EXPECT_THAT(page, HasSubstr("<dt>Term</dt><dd>What it means.</dd>"));
}

}  // namespace
}  // namespace ocelli
