#include "oc_core/drawing/figure.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <regex>
#include <set>

#include "oc_core/drawing/pdf_file.h"
#include "tests/analysis_plot/sample_figures.h"
#include "tests/analysis_plot/well_formed.h"

namespace ocelli {
namespace {

/// Of files: a failure does not print them.
bool holds(const std::string& bytes, const std::string& what) {
  return bytes.find(what) != std::string::npos;
}

Figure hostileFigure() {
  Figure figure{"<script>alert(1)</script>\x01\xFF", "\"&' ]]> <!-- \xC3(", 100, 50, {}};
  figure.drawing.text("label", {5, 20}, "a\xFF\x02 \u5B57 & <b>", {});
  return figure;
}

std::set<std::string> idsOf(const std::string& svg) {
  std::set<std::string> ids;
  for (const std::string& attribute : readMarkup(svg).attributes) {
    if (attribute.rfind("id=", 0) == 0) {
      EXPECT_TRUE(ids.insert(attribute.substr(3)).second) << attribute << " stands twice";
    }
  }
  return ids;
}

TEST(Figure, svgIsWellFormedWithTitleAndDescription) {
  for (const SampleFigure& sample : sampleFigures()) {
    const MarkupReading reading = readMarkup(svgText(sample.figure));
    EXPECT_EQ(reading.problem, "") << sample.name;
    ASSERT_GT(reading.tags.size(), 3U);
    EXPECT_EQ(reading.tags[0], "svg");
    EXPECT_EQ(reading.tags[1], "title");
    EXPECT_EQ(reading.tags[2], "desc");
    EXPECT_THAT(reading.text, testing::HasSubstr(sample.figure.title));
    EXPECT_THAT(reading.tags, testing::Not(testing::Contains("image"))) << sample.name << " is not all vectors";
  }
}

TEST(Figure, hostileTextStaysText) {
  const MarkupReading reading = readMarkup(svgText(hostileFigure()));
  EXPECT_EQ(reading.problem, "");
  EXPECT_THAT(reading.tags, testing::Not(testing::Contains("script")));
  EXPECT_THAT(reading.text, testing::HasSubstr("&lt;script&gt;"));
  EXPECT_THAT(pdfBytes(hostileFigure()), testing::StartsWith("%PDF-"));
}

TEST(Figure, inlineFiguresShareNoIdsAndNameNoAddress) {
  const std::vector<SampleFigure> samples = sampleFigures();
  const std::string first = inlineSvgText(samples[0].figure, "one-");
  const std::string second = inlineSvgText(samples[1].figure, "two-");
  EXPECT_THAT(first, testing::Not(testing::HasSubstr("http")));
  const std::set<std::string> ids = idsOf(first);
  EXPECT_GT(ids.size(), 10U);
  for (const std::string& id : idsOf(second)) {
    EXPECT_EQ(ids.count(id), 0U) << id;
  }
  // What is referred to is there.
  const std::regex reference("(?:=\"#|url\\(#)([^\")]*)");
  for (std::sregex_iterator it(first.begin(), first.end(), reference), end; it != end; ++it) {
    EXPECT_EQ(ids.count((*it)[1].str()), 1U) << (*it)[1].str();
  }
}

TEST(Figure, sameFigureSameBytes) {
  const Figure figure = sampleFigures().front().figure;
  EXPECT_EQ(svgText(figure), svgText(figure));
  EXPECT_EQ(pdfBytes(figure), pdfBytes(figure));
}

TEST(Figure, pdfHasFontsInItAndItsSize) {
  const std::string pdf = pdfBytes(sampleFigures().front().figure);
  EXPECT_TRUE(holds(pdf, "/FontFile"));
  EXPECT_TRUE(holds(pdf, "/MediaBox [ 0 0 240.9"));
  EXPECT_FALSE(holds(pdf, "/Subtype /Image"));
}

TEST(Figure, pngHasTheResolutionThatWasAskedFor) {
  Figure figure;
  figure.width = 72;
  figure.height = 36;
  const std::string png = pngBytes(figure, 100);
  ASSERT_GT(png.size(), 24U);
  EXPECT_EQ(static_cast<unsigned char>(png[19]), 100) << "width";
  EXPECT_EQ(static_cast<unsigned char>(png[23]), 50) << "height";
}

TEST(PdfFile, hasPagesBookmarksAndLinks) {
  PdfDocument document;
  document.title = "Two pages";
  document.width = 200;
  document.height = 100;
  document.pages.resize(2);
  document.pages[0].drawing.text("text", {10, 18}, "second page", {});
  document.pages[0].links = {{{10, 10, 50, 20}, "second"}, {{10, 30, 50, 40}, "nowhere"}};
  document.pages[1].targets = {{"second", {0, 10}}};
  document.bookmarks = {{"Second page", 1, "second"}, {"Nowhere", 1, "nowhere"}};
  const std::string pdf = pdfBytes(document);
  EXPECT_TRUE(holds(pdf, "/Count 2"));
  EXPECT_TRUE(holds(pdf, "(Second page)"));
  EXPECT_FALSE(holds(pdf, "(Nowhere)"));
  EXPECT_TRUE(holds(pdf, "(Two pages)"));
  size_t links = 0;
  for (size_t at = pdf.find("/Subtype /Link"); at != std::string::npos; at = pdf.find("/Subtype /Link", at + 1)) {
    ++links;
  }
  EXPECT_EQ(links, 1U);
}

}  // namespace
}  // namespace ocelli
