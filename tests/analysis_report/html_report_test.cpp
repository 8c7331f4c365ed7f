#include "analysis/report/html_report.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <regex>
#include <set>

#include "analysis/report/html_style.h"
#include "tests/analysis_plot/well_formed.h"
#include "tests/analysis_report/sample_document.h"
#include "tests/page/unstyled_classes.h"

namespace ocelli {
namespace {

MarkupReading read(const std::string& html) {
  return readMarkup(html, {"meta", "br"});
}

bool holds(const std::string& text, const std::string& what) {
  return text.find(what) != std::string::npos;
}

/// Values of an attribute.
std::vector<std::string> valuesOf(const MarkupReading& reading, const std::string& attribute) {
  std::vector<std::string> values;
  for (const std::string& each : reading.attributes) {
    if (each.rfind(attribute + "=", 0) == 0) {
      values.push_back(each.substr(attribute.size() + 1));
    }
  }
  return values;
}

TEST(HtmlReport, isWellFormedAndShowsEveryElement) {
  const std::string html = htmlReport(sampleDocument());
  const MarkupReading reading = read(html);
  EXPECT_EQ(reading.problem, "");
  for (const char* text : {"Table 1.", "Figure 13.", "Methods paragraph", "Cannot be estimated", "19.7",
                           "33 trials ran out of time", "9f86d081884c7d659a2feaa0c55ad015"}) {
    EXPECT_TRUE(holds(reading.text, text)) << text;
  }
}

TEST(HtmlReport, namesNothingOutsideItself) {
  for (const std::string& html : {htmlReport(sampleDocument()), htmlSupplement(sampleDocument())}) {
    EXPECT_FALSE(holds(html, "http:"));
    EXPECT_FALSE(holds(html, "https:"));
    EXPECT_FALSE(holds(html, "@import"));
    const MarkupReading reading = read(html);
    EXPECT_TRUE(valuesOf(reading, "src").empty());
    for (const std::string& href : valuesOf(reading, "href")) {
      const std::string file = href.substr(0, href.find('#'));
      EXPECT_TRUE(file.empty() || file == "index.html" || file == "supplement.html") << href;
    }
    const std::regex outside("url\\((?!#)");
    EXPECT_FALSE(std::regex_search(html, outside));
  }
}

TEST(HtmlReport, hostileTextStaysText) {
  const std::string html = htmlReport(hostileDocument());
  const MarkupReading reading = read(html);
  EXPECT_EQ(reading.problem, "");
  EXPECT_THAT(reading.tags, testing::Not(testing::Contains("img")));
  EXPECT_EQ(std::count(reading.tags.begin(), reading.tags.end(), "script"), 1);
  EXPECT_EQ(std::count(reading.tags.begin(), reading.tags.end(), "style"), 1);
  EXPECT_TRUE(valuesOf(reading, "onerror").empty());
  EXPECT_TRUE(valuesOf(reading, "autofocus").empty());
  EXPECT_TRUE(holds(reading.text, "&lt;script&gt;alert(1)"));
}

TEST(HtmlReport, idsAreUniqueAndLinksLeadSomewhere) {
  ReportDocument document = sampleDocument();
  {
    const InSupplement supplement(document);
    document.add(std::get<ReportTable>(
        *std::find_if(document.elements.begin(), document.elements.end(),
                      [](const ReportElement& element) { return std::holds_alternative<ReportTable>(element); })));
  }
  std::map<std::string, MarkupReading> pages;
  pages["index.html"] = read(htmlReport(document));
  pages["supplement.html"] = read(htmlSupplement(document));
  std::map<std::string, std::set<std::string>> ids;
  for (const auto& [name, page] : pages) {
    EXPECT_EQ(page.problem, "") << name;
    for (const std::string& id : valuesOf(page, "id")) {
      EXPECT_TRUE(ids[name].insert(id).second || id.starts_with("t71-")) << id << " stands twice";
    }
  }
  for (const auto& [name, page] : pages) {
    for (const char* attribute : {"href", "xlink:href"}) {
      for (const std::string& link : valuesOf(page, attribute)) {
        const size_t hash = link.find('#');
        const std::string file = hash == 0 ? name : link.substr(0, hash);
        ASSERT_EQ(ids.count(file), 1U) << link;
        EXPECT_TRUE(hash == std::string::npos || ids[file].count(link.substr(hash + 1)) == 1) << name << ": " << link;
      }
    }
  }
  EXPECT_EQ(ids["index.html"].count("t71-s1-ppc"), 1U) << "the anchor of a cell";
}

TEST(HtmlReport, cellsSayWhereTheyComeFrom) {
  const std::string html = htmlReport(sampleDocument());
  EXPECT_TRUE(holds(html,
                    "id=\"t71-s1-ppc\" title=\"SELECT avg(response_s) FROM final_trial WHERE task = &#39;find&#39; AND "
                    "session = 1\""));
  EXPECT_TRUE(holds(html, "<a href=\"supplement.html#sources-table-7-1\">Where these numbers come from</a>"));
  EXPECT_TRUE(holds(htmlSupplement(sampleDocument()), "<a href=\"index.html#t71-s1-ppc\">Session 1</a>"));
}

TEST(HtmlReport, theSupplementIsAPageOfItsOwn) {
  ReportDocument document;
  document.title = "Study";
  document.add(ReportHeading{1, "Finding", "find"});
  document.add(ReportTable{"Main", "main", {{"What"}}, {{{"x"}}}});
  {
    const InSupplement supplement(document);
    document.add(ReportTable{"All cases", "cases", {{"What"}}, {{{"y"}}}});
  }
  document.add(ReportParagraph{"Main again."});
  const MarkupReading main = read(htmlReport(document));
  const MarkupReading more = read(htmlSupplement(document));
  EXPECT_TRUE(holds(main.text, "Main again."));
  EXPECT_FALSE(holds(main.text, "All cases"));
  EXPECT_TRUE(holds(more.text, "Table S1.")) << "counted apart";
  EXPECT_TRUE(holds(more.text, "Finding")) << "below the heading of its section";
  EXPECT_THAT(valuesOf(main, "href"), testing::Contains("supplement.html"));
}

TEST(HtmlReport, exploratoryTablesAreMarkedAndShortNamesAreSmall) {
  ReportDocument document;
  ReportTable table{"Ratios", "ratios", {{"What"}}, {{{"Found sooner"}}}};
  table.rows[0][0].shortName = "find-faster";
  document.add(table);
  EXPECT_FALSE(holds(read(htmlReport(document)).text, "Exploratory"));
  std::get<ReportTable>(document.elements[0]).exploratory = true;
  const std::string html = htmlReport(document);
  EXPECT_TRUE(holds(html, "<span class=\"exploratory\">Exploratory</span>"));
  EXPECT_TRUE(holds(html, "Found sooner<small>find-faster</small>"));
}

TEST(HtmlReport, policyAllowsItsOwnScriptAlone) {
  const std::string html = htmlReport(sampleDocument());
  const MarkupReading reading = read(html);
  const std::vector<std::string> contents = valuesOf(reading, "content");
  const auto policy = std::find_if(contents.begin(), contents.end(),
                                   [](const std::string& content) { return holds(content, "default-src"); });
  ASSERT_NE(policy, contents.end());
  EXPECT_TRUE(holds(*policy, "default-src &#39;none&#39;"));
  EXPECT_TRUE(std::regex_search(*policy, std::regex("script-src &#39;sha256-[A-Za-z0-9+/]{43}=&#39;")));
  EXPECT_TRUE(holds(html, "<script>" + std::string(kReportScript) + "</script>"));
}

TEST(HtmlReport, figuresAreDescribed) {
  const MarkupReading reading = read(htmlReport(sampleDocument()));
  EXPECT_EQ(std::count(reading.tags.begin(), reading.tags.end(), "desc"), 13);
  EXPECT_THAT(valuesOf(reading, "role"), testing::Contains("img").Times(13));
}

TEST(HtmlReport, styleHasItsColours) {
  EXPECT_THAT(test::undefinedProperties(htmlReport(sampleDocument())), testing::IsEmpty());
}

TEST(HtmlReport, sameDocumentSameBytes) {
  EXPECT_EQ(htmlReport(sampleDocument()), htmlReport(sampleDocument()));
}

TEST(HtmlReport, anEmptyDocumentIsAPage) {
  EXPECT_EQ(read(htmlReport({})).problem, "");
}

}  // namespace
}  // namespace ocelli
