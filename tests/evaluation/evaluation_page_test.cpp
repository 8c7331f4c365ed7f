#include "oc_core/evaluation/evaluation_page.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <regex>
#include <set>

#include "oc_core/evaluation/evaluation_plot.h"
#include "tests/page/unstyled_classes.h"

namespace ocelli {
namespace {

using testing::HasSubstr;
using testing::Not;

RepresentationFigures figures(const std::string& name, size_t strict, size_t samples) {
  RepresentationFigures row;
  row.name = name;
  row.samples = samples;
  row.triangles = 2 * samples;
  row.edges.truth = 1000;
  row.edges.strict = strict;
  row.edges.thick = strict / 2;
  row.edges.images = 1;
  row.edges.squaredError = static_cast<double>(strict) / 1e4;
  row.offsets = {FrameErrors{}, row.edges};
  return row;
}

EvaluationOptions options() {
  EvaluationOptions options;
  options.width = 90;
  options.height = 60;
  options.offsets = {0, 1};
  return options;
}

std::string pageOf(const std::vector<RepresentationFigures>& rows, const std::string& scene = "builtin:room",
                   bool complete = true) {
  EvaluatePage page{scene, "0.1", 1234567, "truth.png", {}, complete};
  for (const RepresentationFigures& row : rows) {
    page.images.push_back(imageNames(row.name, row.name));
  }
  return evaluatePage(page, options(), rows);
}

std::vector<std::string> pageMatches(const std::string& text, const std::string& pattern) {
  const std::regex regex(pattern);
  std::vector<std::string> found;
  for (std::sregex_iterator it(text.begin(), text.end(), regex); it != std::sregex_iterator(); ++it) {
    found.push_back((*it)[1]);
  }
  return found;
}

const std::vector<RepresentationFigures> kRows{figures("di", 100, 5000), figures("ddoc", 25, 5100),
                                               figures("cell", 5, 7000), figures("geometry", 0, 90000)};

void expectTagsClosed(const std::string& page) {
  for (const char* tag :
       {"html",  "body",  "main", "header", "section", "article", "div",  "figure", "figcaption", "table",
        "thead", "tbody", "tr",   "td",     "th",      "p",       "h1",   "h2",     "h3",         "dl",
        "dt",    "dd",    "ul",   "li",     "svg",     "g",       "text", "title",  "span",       "a"}) {
    const std::string name(tag);
    EXPECT_EQ(pageMatches(page, "(<" + name + "[ >])").size(), pageMatches(page, "(</" + name + ">)").size()) << tag;
  }
}

TEST(EvaluatePage, StyleHasItsClassesAndColours) {
  const std::string page = pageOf({figures("di", 40, 300), figures("ddoc", 10, 900)}, "builtin:room", false);
  EXPECT_THAT(test::unstyledClasses(page), testing::IsEmpty());
  EXPECT_THAT(test::undefinedProperties(page), testing::IsEmpty());
}

TEST(EvaluatePage, OpenedTagsAreClosed) {
  expectTagsClosed(pageOf(kRows));
  expectTagsClosed(pageOf({}));
  expectTagsClosed(pageOf({kRows[0]}));
}

TEST(EvaluatePage, EscapesWhatTheUserNamed) {
  const std::string page = pageOf({figures("<i>\"mine\" & yours", 10, 100)}, "<b>\"rabbit\" & co</b>.obj");
  EXPECT_THAT(page, HasSubstr("&lt;b&gt;&quot;rabbit&quot; &amp; co&lt;/b&gt;.obj"));
  EXPECT_THAT(page, HasSubstr("&lt;i&gt;&quot;mine&quot; &amp; yours"));
  EXPECT_THAT(page, Not(HasSubstr("<b>\"rabbit")));
  EXPECT_THAT(page, Not(HasSubstr("<i>")));
  expectTagsClosed(page);
}

TEST(EvaluatePage, NeedsNothingFromElsewhereAndNoScript) {
  const std::string page = pageOf(kRows);
  EXPECT_THAT(page, Not(HasSubstr("://")));
  EXPECT_THAT(page, Not(HasSubstr("<script")));
  EXPECT_THAT(page, HasSubstr("@media print"));
  for (const std::string& source : pageMatches(page, "(?:src|href)=\"([^#\"][^\"]*)\"")) {
    EXPECT_TRUE(source.ends_with(".png") || source == "data:,") << source;
  }
}

TEST(EvaluatePage, IdsAreUniqueAndLinksAndLabelsHaveTheirs) {
  const std::string page = pageOf(kRows);
  const std::vector<std::string> ids = pageMatches(page, " id=\"([^\"]*)\"");
  const std::set<std::string> unique(ids.begin(), ids.end());
  EXPECT_EQ(unique.size(), ids.size());
  for (const std::string& wanted : pageMatches(page, "(?:href=\"#|labelledby=\")([^\"]*)\"")) {
    EXPECT_TRUE(unique.contains(wanted)) << wanted;
  }
}

TEST(EvaluatePage, MarksTheBestOfAColumnButNotTheSceneItself) {
  const std::string page = pageOf(kRows);
  // Of the strict errors 10, 2.5 and 0.5 %; the scene itself has none.
  EXPECT_THAT(page, HasSubstr("<td class=\"best\">0.500<span class=\"hidden\"> (best)</span></td>"));
  EXPECT_THAT(page, Not(HasSubstr("<td class=\"best\">0.000")));
  EXPECT_THAT(page, HasSubstr("<td class=\"best\">33.01")) << "the highest PSNR: 10 log10(1e4 / 5)";
  EXPECT_THAT(pageOf({kRows[0]}), Not(HasSubstr("<td class=\"best\""))) << "a single one has won nothing";
}

TEST(EvaluatePage, NoNumberIsWithoutAPlace) {
  for (const auto& rows : {kRows, {kRows[3]}, {kRows[0]}, {figures("none", 0, 0)}}) {
    const std::string page = pageOf(rows);
    for (const std::string& path : pageMatches(page, " (?:d|points|x|y|cx|cy)=\"([^\"]*)\"")) {
      EXPECT_THAT(path, Not(HasSubstr("nan")));
      EXPECT_THAT(path, Not(HasSubstr("inf")));
    }
  }
}

TEST(EvaluatePage, TellsThatRowsAreMissing) {
  EXPECT_THAT(pageOf(kRows, "x", false), HasSubstr("interrupted"));
  EXPECT_THAT(pageOf(kRows, "x", true), Not(HasSubstr("interrupted")));
}

TEST(EvaluatePage, EveryImageSaysWhatItShows) {
  const std::vector<std::string> tags = pageMatches(pageOf(kRows), "(<img[^>]*>)");
  ASSERT_EQ(tags.size(), 1u + 2 * kRows.size());
  for (const std::string& tag : tags) {
    EXPECT_TRUE(std::regex_search(tag, std::regex("alt=\"[^\"]{10,}\""))) << tag;
  }
}

TEST(ImageNames, AreSafeAndDiffer) {
  EXPECT_EQ(imageNames("eoc-hv+ddoc", "eoc-hv+ddoc").frame, "frame-eoc-hv+ddoc.png");
  const std::string odd = imageNames("../a b/<c>", "file.json 1").errors;
  EXPECT_TRUE(std::regex_match(odd, std::regex("errors-[A-Za-z0-9-]+\\.png"))) << odd;
  EXPECT_NE(imageNames("same", "one.json 1").frame, imageNames("same", "one.json 2").frame);
}

std::vector<double> xOfMarkers(const std::string& svg) {
  std::vector<double> places;
  for (const std::string& x : pageMatches(svg, "<circle cx=\"([0-9.]+)\"")) {
    places.push_back(std::stod(x));
  }
  return places;
}

TEST(FrontierPlot, DecadesAreEquallyFarApart) {
  // All with the round marker, which comes once in seven styles.
  const std::string svg =
      frontierPlot("title", "x", "y", {{"a", {{1e3, 0.1}}, 1}, {"b", {{1e4, 0.01}}, 8}, {"c", {{1e5, 0.001}}, 15}});
  const std::vector<double> x = xOfMarkers(svg);
  ASSERT_EQ(x.size(), 3u);
  EXPECT_GT(x[1], x[0] + 50);
  EXPECT_NEAR(x[2] - x[1], x[1] - x[0], 0.11) << "printed to a tenth";
  EXPECT_THAT(svg, HasSubstr("10 %"));
  EXPECT_THAT(svg, HasSubstr("10 K"));
}

TEST(FrontierPlot, ZeroHasARowOfItsOwn) {
  const std::string with = frontierPlot("t", "x", "y", {{"a", {{1e3, 0}}, 0}, {"b", {{1e4, 0.01}}, 0}});
  EXPECT_THAT(with, HasSubstr(">0</text>"));
  const std::string without = frontierPlot("t", "x", "y", {{"b", {{1e4, 0.01}}, 0}});
  EXPECT_THAT(without, Not(HasSubstr(">0</text>")));
}

TEST(FrontierPlot, LabelsThatWouldCoverEachOtherStandInTheMargin) {
  std::vector<PlotSeries> series;
  for (size_t i = 0; i < 12; ++i) {
    series.push_back({"name-" + std::to_string(i), {{1000, 0.01}}, i});
  }
  const std::string svg = frontierPlot("t", "x", "y", series);
  std::set<std::pair<std::string, std::string>> places;
  const std::regex label("class=\"label\" x=\"([0-9.]+)\" y=\"([0-9.]+)\"");
  size_t labels = 0;
  for (std::sregex_iterator it(svg.begin(), svg.end(), label); it != std::sregex_iterator(); ++it, ++labels) {
    places.emplace((*it)[1], (*it)[2]);
  }
  EXPECT_EQ(labels, 12u);
  EXPECT_EQ(places.size(), 12u);
}

TEST(CurvePlot, HasACurveForEachSeriesWithPoints) {
  const std::string svg =
      curvePlot("t", "x", "y", {{"a", {{0, 0}, {1, 0.1}}, 0}, {"b", {{0, 0.1}, {1, 0.2}}, 1}, {"none", {}, 2}});
  EXPECT_EQ(pageMatches(svg, "(fill: none; stroke: var)").size(), 2u);
  EXPECT_THAT(svg, Not(HasSubstr("none</text>")));
}

}  // namespace
}  // namespace ocelli
