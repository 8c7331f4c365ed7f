#include "analysis/report/pdf_report.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <set>

#include "analysis/report/page_flow.h"
#include "analysis/report/table_layout.h"
#include "tests/analysis_report/sample_document.h"

namespace ocelli {
namespace {

/// Texts of a part, page by page.
std::vector<std::vector<std::string>> textsOf(const PdfDocument& pdf, const std::string& part) {
  std::vector<std::vector<std::string>> pages;
  for (const PdfPage& page : pdf.pages) {
    pages.emplace_back();
    for (const Shape& shape : page.drawing.shapes()) {
      if (shape.part == part) {
        pages.back().push_back(std::get<TextShape>(shape.what).text);
      }
    }
  }
  return pages;
}

ReportDocument documentWith(ReportElement element) {
  ReportDocument document;
  document.title = "One element";
  document.add(std::move(element));
  return document;
}

ReportTable tableOf(int rows) {
  ReportTable table;
  table.caption = "Many rows";
  table.columns = {{"Row"}, {"Value"}, {"Words", "", true}};
  for (int i = 0; i < rows; ++i) {
    table.rows.push_back({{std::to_string(i)}, {"1.5"}, {"a few words"}});
  }
  return table;
}

TEST(PdfReport, nothingStandsInTheMargins) {
  const PdfDocument pdf = pdfPages(sampleDocument());
  const PlotBox paper{kPageMargin, 0, kPageWidth - kPageMargin, kPageHeight};
  for (size_t i = 0; i < pdf.pages.size(); ++i) {
    for (const Shape& shape : pdf.pages[i].drawing.shapes()) {
      EXPECT_TRUE(paper.contains(boxOf(shape), 1.5)) << "page " << i + 1 << ": " << shape.part;
      if (shape.part != "page number" && shape.part != "running version") {
        EXPECT_LE(boxOf(shape).bottom, kPageHeight - kPageMargin + 1) << "page " << i + 1 << ": " << shape.part;
      }
    }
  }
}

TEST(PdfReport, textDoesNotOverlap) {
  const PdfDocument pdf = pdfPages(sampleDocument());
  for (size_t i = 0; i < pdf.pages.size(); ++i) {
    std::vector<std::pair<std::string, PlotBox>> texts;
    for (const Shape& shape : pdf.pages[i].drawing.shapes()) {
      if (const auto* text = std::get_if<TextShape>(&shape.what); text != nullptr && !text->text.empty()) {
        PlotBox box = boxOf(shape);
        box.top += 0.15 * text->size;
        box.bottom -= 0.15 * text->size;
        for (const auto& [other, otherBox] : texts) {
          ASSERT_FALSE(box.overlaps(otherBox)) << "page " << i + 1 << ": " << text->text << " on " << other;
        }
        texts.emplace_back(text->text, box);
      }
    }
  }
}

TEST(PdfReport, headsOfTablesStandOnEveryPage) {
  const PdfDocument pdf = pdfPages(documentWith(tableOf(150)));
  ASSERT_GE(pdf.pages.size(), 3U);
  const auto heads = textsOf(pdf, "head");
  const auto captions = textsOf(pdf, "caption");
  const auto cells = textsOf(pdf, "cell");
  size_t rows = 0;
  for (size_t i = 0; i < pdf.pages.size(); ++i) {
    EXPECT_THAT(heads[i], testing::ElementsAre("Row", "Value", "Words")) << i;
    EXPECT_THAT(captions[i], testing::ElementsAre(i == 0 ? "Table 1. Many rows" : "Table 1 (continued). Many rows"));
    rows += cells[i].size() / 3;
  }
  EXPECT_EQ(rows, 150U);
}

TEST(PdfReport, contentsNameTheRightPages) {
  const PdfDocument pdf = pdfPages(sampleDocument());
  std::map<std::string, int> pageOf;
  for (size_t i = 0; i < pdf.pages.size(); ++i) {
    for (const PdfTarget& target : pdf.pages[i].targets) {
      EXPECT_TRUE(pageOf.emplace(target.name, static_cast<int>(i) + 1).second) << target.name;
    }
  }
  // Below the first section, over as many pages as they take.
  std::vector<std::string> numbers;
  std::vector<PdfLink> links;
  for (size_t i = 0; i < pdf.pages.size(); ++i) {
    const std::vector<std::string> onPage = textsOf(pdf, "contents page")[i];
    numbers.insert(numbers.end(), onPage.begin(), onPage.end());
    links.insert(links.end(), pdf.pages[i].links.begin(), pdf.pages[i].links.end());
  }
  ASSERT_EQ(numbers.size(), links.size());
  ASSERT_GE(numbers.size(), 6U);
  for (size_t i = 0; i < links.size(); ++i) {
    EXPECT_EQ(numbers[i], std::to_string(pageOf.at(links[i].target))) << links[i].target;
  }
  for (const PdfBookmark& bookmark : pdf.bookmarks) {
    EXPECT_EQ(pageOf.count(bookmark.target), 1U) << bookmark.title;
  }
}

TEST(PdfReport, pagesAreNumberedAndMarked) {
  const PdfDocument pdf = pdfPages(sampleDocument());
  const auto numbers = textsOf(pdf, "page number");
  const auto marking = textsOf(pdf, "running marking");
  for (size_t i = 0; i < pdf.pages.size(); ++i) {
    EXPECT_THAT(numbers[i], testing::ElementsAre(fmt::format("{} / {}", i + 1, pdf.pages.size())));
    if (i > 0) {
      EXPECT_THAT(marking[i], testing::ElementsAre("Simulated subjects"));
    }
  }
  EXPECT_THAT(textsOf(pdf, "marking")[0], testing::ElementsAre("Simulated subjects"));
}

TEST(PdfReport, sourcesOfNumbersStandAtTheEnd) {
  const PdfDocument pdf = pdfPages(sampleDocument());
  EXPECT_THAT(textsOf(pdf, "source"),
              testing::Contains(testing::Contains("SELECT avg(response_s) FROM final_trial WHERE task = 'find' AND "
                                                  "session = 1")));
}

TEST(PdfReport, longTextFlowsOverPagesWithoutLoss) {
  std::string text;
  for (int i = 0; i < 3000; ++i) {
    text += fmt::format("{}word{}", i > 0 ? " " : "", i);
  }
  for (const ReportElement& element :
       {ReportElement(ReportParagraph{text}), ReportElement(ReportExcerpt{"Title", text}),
        ReportElement(ReportNote{NoteKind::kWarning, text})}) {
    const PdfDocument pdf = pdfPages(documentWith(element));
    EXPECT_GT(pdf.pages.size(), 2U);
    std::string joined;
    for (const char* part : {"text", "boxed"}) {
      for (const auto& page : textsOf(pdf, part)) {
        for (const std::string& line : page) {
          joined += line + " ";
        }
      }
    }
    EXPECT_NE(joined.find(text.substr(0, 2000)), std::string::npos);
    EXPECT_NE(joined.find("word2999"), std::string::npos);
  }
}

TEST(PdfReport, largeFiguresShrinkToThePage) {
  ReportFigure figure;
  figure.figure.width = 3 * kPageWidth;
  figure.figure.height = 4 * kPageHeight;
  figure.figure.drawing.box("frame", {0, 0, figure.figure.width, figure.figure.height}, std::nullopt, Pen{});
  const PdfDocument pdf = pdfPages(documentWith(figure));
  for (const PdfPage& page : pdf.pages) {
    for (const Shape& shape : page.drawing.shapes()) {
      if (shape.part == "frame") {
        EXPECT_LE(boxOf(shape).width(), kTextWidth + 1e-6);
        EXPECT_LE(boxOf(shape).bottom, kPageHeight - kPageMargin);
        return;
      }
    }
  }
  FAIL() << "the figure is on no page";
}

TEST(TableLayout, columnsFillAtMostThePage) {
  for (const ReportElement& element : sampleDocument().elements) {
    if (const auto* table = std::get_if<ReportTable>(&element)) {
      for (const ReportTable& part : partsOf(*table, kTextWidth)) {
        const TableLayout layout = layOut(part, kTextWidth);
        EXPECT_LE(std::accumulate(layout.widths.begin(), layout.widths.end(), 0.0), kTextWidth + 1e-6);
        EXPECT_GE(layout.size, 7);
      }
    }
  }
}

TEST(TableLayout, tooManyColumnsStandInPartsWithTheFirst) {
  ReportTable table;
  table.columns = {{"Name"}};
  std::vector<ReportCell> row{{"a"}};
  for (int i = 0; i < 40; ++i) {
    table.columns.push_back({fmt::format("c{}", i)});
    row.push_back({"1234.5678"});
  }
  table.rows = {row};
  const std::vector<ReportTable> parts = partsOf(table, kTextWidth);
  EXPECT_GT(parts.size(), 2U);
  size_t columns = 0;
  for (const ReportTable& part : parts) {
    EXPECT_EQ(part.columns.front().title, "Name");
    EXPECT_EQ(part.rows.front().size(), part.columns.size());
    columns += part.columns.size() - 1;
  }
  EXPECT_EQ(columns, 40U);
}

TEST(PdfReport, hostileAndEmptyDocumentsAreFiles) {
  for (const ReportDocument& document : {hostileDocument(), ReportDocument{}, documentWith(ReportTable{})}) {
    EXPECT_EQ(pdfReport(document).rfind("%PDF-", 0), 0U);
  }
}

TEST(PdfReport, sameDocumentSameBytes) {
  EXPECT_TRUE(pdfReport(sampleDocument()) == pdfReport(sampleDocument()));
}

}  // namespace
}  // namespace ocelli
