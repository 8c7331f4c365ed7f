#include "analysis/report/report_files.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/analysis_report/sample_document.h"

namespace ocelli {
namespace {

TEST(ReportFiles, everyFigureIsThereForAPaper) {
  ReportDocument document;
  for (const ReportElement& element : sampleDocument().elements) {
    if (const auto* figure = std::get_if<ReportFigure>(&element); figure != nullptr && document.elements.size() < 2) {
      document.add(*figure);
    }
  }
  std::vector<std::string> names;
  for (const ReportFile& file : reportFiles(document)) {
    names.push_back(file.name);
    EXPECT_FALSE(file.bytes.empty()) << file.name;
  }
  EXPECT_THAT(names,
              testing::ElementsAre("index.html", "supplement.html", "report.pdf", "report.json", "figures/flow.svg",
                                   "figures/flow.pdf", "figures/cases.svg", "figures/cases.pdf"));
}

TEST(ReportFiles, namesOfHostileFiguresStayInTheFolder) {
  for (const ReportFile& file : reportFiles(hostileDocument())) {
    EXPECT_EQ(file.name.find(".."), std::string::npos);
    EXPECT_THAT(file.name, testing::MatchesRegex("(index|supplement|report|figures/[a-z0-9-]+)[.](html|pdf|json|svg)"));
  }
}

}  // namespace
}  // namespace ocelli
