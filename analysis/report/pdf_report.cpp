#include "analysis/report/pdf_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "analysis/plot/style.h"
#include "analysis/report/page_flow.h"
#include "analysis/report/table_layout.h"
#include "oc_core/base/utf8.h"

namespace ocelli {
namespace {

constexpr const char* kSupplementId = "the-supplement";
constexpr Paint kAccent = paintOf(page_color::kAccent);
constexpr Paint kCaution = paintOf(page_color::kCaution);
constexpr Paint kTint = paintOf(page_color::kTint);

/// On which page the first layout put what the contents name.
using PageNumbers = std::map<std::string, int>;

struct HeadingLook {
  double size;
  double lineHeight;
  double above;
  double below;
};

HeadingLook lookOf(int level) {
  return level <= 1   ? HeadingLook{15, 19, 26, 6}
         : level == 2 ? HeadingLook{11.5, 15, 16, 4}
                      : HeadingLook{10, 14, 12, 3};
}

class PdfWriter {
 public:
  PdfWriter(const ReportDocument& document, const PageNumbers& numbers)
      : document_(document), names_(documentNames(document)), numbers_(numbers) {}

  PdfDocument write() {
    frontMatter();
    // The contents stand below the first section, which has what the report is read for.
    const size_t first = endOfFirstSection();
    flowAll(document_.elements, names_.elements, 0, first);
    contents();
    flowAll(document_.elements, names_.elements, first, document_.elements.size());
    if (!document_.supplement.empty()) {
      flow_.require(kPageHeight);
      flow(ReportHeading{1, kSupplementTitle}, {kSupplementId, ""});
      flowAll(document_.supplement, names_.supplement, 0, document_.supplement.size());
    }
    sources();
    runningLines();
    PdfDocument pdf;
    pdf.title = document_.title;
    pdf.subject = document_.subtitle;
    pdf.keywords = document_.marking;
    pdf.created = document_.created;
    pdf.width = kPageWidth;
    pdf.height = kPageHeight;
    pdf.pages = std::move(flow_.pages());
    pdf.bookmarks = std::move(bookmarks_);
    return pdf;
  }

 private:
  /// Index of the second heading of level 1, or of the end.
  size_t endOfFirstSection() const {
    int sections = 0;
    for (size_t i = 0; i < document_.elements.size(); ++i) {
      const auto* heading = std::get_if<ReportHeading>(&document_.elements[i]);
      if (heading != nullptr && heading->level <= 1 && ++sections == 2) {
        return i;
      }
    }
    return document_.elements.size();
  }

  void flowAll(const std::vector<ReportElement>& elements, const std::vector<ElementName>& names, size_t first,
               size_t end) {
    for (size_t i = first; i < end; ++i) {
      std::visit([&](const auto& what) { flow(what, names[i]); }, elements[i]);
    }
  }

  void target(const std::string& id) {
    flow_.page().targets.push_back({id, {0, std::max(0.0, kPageHeight - kPageMargin - flow_.left() - 8)}});
  }

  void frontMatter() {
    if (!document_.marking.empty()) {
      flowText(flow_, document_.marking, {.face = Face::kSansBold, .size = 9, .lineHeight = 14, .paint = kCaution},
               "marking");
    }
    flowText(flow_, document_.title, {.face = Face::kSansBold, .size = 21, .lineHeight = 26}, "title");
    if (!document_.subtitle.empty()) {
      flowText(flow_, document_.subtitle,
               {.face = Face::kSerifItalic, .size = 11, .lineHeight = 15, .paint = kSoftTextPaint}, "subtitle");
    }
    const double y = flow_.take(14) + 7;
    flow_.drawing().line("rule", {kPageMargin, y}, {kPageMargin + kTextWidth, y}, {kAxisPaint, 0.6});
  }

  void contents() {
    struct Entry {
      std::string text;
      std::string id;
      int level;
    };
    std::vector<Entry> entries;
    const auto addHeadings = [&](const std::vector<ReportElement>& part, const std::vector<ElementName>& names,
                                 int below, int deepest) {
      for (size_t i = 0; i < part.size(); ++i) {
        const auto* heading = std::get_if<ReportHeading>(&part[i]);
        if (heading != nullptr && heading->level <= deepest) {
          entries.push_back({cleanText(heading->text), names[i].id, std::max(heading->level, 1) + below});
        }
      }
    };
    addHeadings(document_.elements, names_.elements, 0, 2);
    if (entries.empty()) {
      return;
    }
    if (!document_.supplement.empty()) {
      entries.push_back({kSupplementTitle, kSupplementId, 1});
      addHeadings(document_.supplement, names_.supplement, 1, 1);
    }
    if (hasSources()) {
      entries.push_back({kSourcesTitle, kSourcesId, 1});
    }
    flowText(flow_, "Contents", {.face = Face::kSansBold, .size = 10, .lineHeight = 17}, "contents title");
    for (const Entry& entry : entries) {
      constexpr double kRow = 13.5;
      flow_.require(kRow);
      const double top = flow_.take(kRow);
      const double left = kPageMargin + 14 * (entry.level - 1);
      const double right = kPageMargin + kTextWidth;
      const auto number = numbers_.find(entry.id);
      const std::string page = number == numbers_.end() ? "" : fmt::format("{}", number->second);
      const Face face = entry.level == 1 ? Face::kSansBold : Face::kSans;
      const std::string text = shortened(entry.text, face, 9, right - left - 40);
      flow_.drawing().text("contents", {left, top + kRow / 2}, text,
                           {.size = 9, .face = face, .paint = kTextPaint, .down = Down::kMiddle});
      flow_.drawing().text("contents page", {right, top + kRow / 2}, page,
                           {.size = 9, .paint = kTextPaint, .across = Across::kRight, .down = Down::kMiddle});
      flow_.drawing().line("leader", {left + textWidth(text, face, 9) + 6, top + kRow / 2 + 3},
                           {right - 22, top + kRow / 2 + 3}, {kAxisPaint, 0.5, {0.6, 3}});
      flow_.page().links.push_back({{left, top, right, top + kRow}, entry.id});
    }
    flow_.space(8);
  }

  void flow(const ReportHeading& heading, const ElementName& name) {
    const int level = std::clamp(heading.level, 1, 3);
    const HeadingLook look = lookOf(level);
    // With some of what it heads.
    flow_.require(look.above + 2 * look.lineHeight + 60);
    flow_.space(look.above);
    target(name.id);
    bookmarks_.push_back({heading.text, level, name.id});
    if (level == 1 && !flow_.atTop()) {
      const double y = flow_.take(8);
      flow_.drawing().line("rule", {kPageMargin, y}, {kPageMargin + kTextWidth, y}, {kAxisPaint, 0.6});
    }
    flowText(flow_, heading.text, {.face = Face::kSansBold, .size = look.size, .lineHeight = look.lineHeight},
             "heading");
    flow_.take(look.below);
  }

  void flow(const ReportParagraph& paragraph, const ElementName&) {
    flowText(flow_, paragraph.text, {.rightGap = 0.04 * kTextWidth});
    flow_.space(6);
  }

  void flow(const ReportList& list, const ElementName&) {
    for (const std::string& item : list.items) {
      flow_.require(28);
      flow_.drawing().marker("bullet", {{kPageMargin + 6, kPageHeight - kPageMargin - flow_.left() + 7},
                                        Marker::kCircle,
                                        1.3,
                                        kTextPaint,
                                        std::nullopt});
      flowText(flow_, item, {.indent = 14, .rightGap = 0.04 * kTextWidth});
      flow_.space(2);
    }
    flow_.space(4);
  }

  void flow(const ReportFacts& facts, const ElementName&) {
    constexpr double kTerm = 110;
    for (const ReportFacts::Fact& fact : facts.facts) {
      const Face face = fact.code ? Face::kMono : Face::kSerif;
      const double size = fact.code ? 8 : 9.5;
      flow_.require(26);
      flow_.drawing().text("term", {kPageMargin, kPageHeight - kPageMargin - flow_.left() + 6.5},
                           shortened(cleanText(fact.term), Face::kSans, 8.5, kTerm - 8),
                           {.size = 8.5, .paint = kSoftTextPaint, .down = Down::kMiddle});
      flowText(flow_, fact.text, {.face = face, .size = size, .lineHeight = 13, .indent = kTerm}, "fact");
    }
    flow_.space(8);
  }

  void flow(const ReportNote& note, const ElementName&) {
    const bool caution = note.kind == NoteKind::kWarning || note.kind == NoteKind::kSimulated;
    const bool missing = note.kind == NoteKind::kNotEstimable;
    const Paint paint = caution ? kCaution : missing ? kSoftTextPaint : kAccent;
    boxed({{noteTitle(note.kind), {.face = Face::kSansBold, .size = 8.5, .lineHeight = 13, .paint = paint}},
           {note.text, {.size = 9.5, .lineHeight = 13}}},
          kTint, Pen{paint, missing ? 1.0 : 2.5, missing ? Dash{3, 2} : Dash{}}, false);
  }

  void flow(const ReportExcerpt& excerpt, const ElementName& name) {
    flow_.require(60);
    target(name.id);
    boxed({{excerpt.title, {.face = Face::kSansBold, .size = 9, .lineHeight = 15}},
           {excerpt.text, {.size = 9.5, .lineHeight = 13.5}}},
          kWhite, Pen{kAxisPaint, 0.6}, true);
  }

  void flow(const ReportTable& table, const ElementName& name) {
    flow_.space(4);
    flowTable(flow_, table, name);
  }

  void flow(const ReportFigure& figure, const ElementName& name) {
    const std::string caption = cleanText(fmt::format("{}. {}", name.label, figure.caption));
    const TextBlock look{.face = Face::kSans, .size = 8.5, .lineHeight = 11};
    const auto lines = static_cast<double>(brokenLines(caption, look.face, look.size, kTextWidth).size());
    const double captionHeight = lines * look.lineHeight + 6;
    // Larger figures shrink to a page.
    const double scale =
        std::min({1.0, kTextWidth / std::max(figure.figure.width, 1.0),
                  (kPageHeight - 2 * kPageMargin - captionHeight) / std::max(figure.figure.height, 1.0)});
    const double height = scale * figure.figure.height;
    flow_.space(6);
    flow_.require(height + captionHeight);
    target(name.id);
    const double top = flow_.take(height + 6);
    flow_.drawing().add(figure.figure.drawing, {kPageMargin, top}, scale);
    flowText(flow_, caption, look, "caption");
    flow_.space(12);
  }

  struct BoxedText {
    std::string text;
    TextBlock block;
  };

  /// On a ground with a line at its left, or with a frame; over several pages where it must.
  void boxed(const std::vector<BoxedText>& texts, const Paint& ground, const Pen& pen, bool framed) {
    constexpr double kInside = 9;
    struct Line {
      std::string text;
      const TextBlock* block;
    };
    std::vector<Line> lines;
    for (const BoxedText& each : texts) {
      for (std::string& line :
           brokenLines(cleanText(each.text), each.block.face, each.block.size, kTextWidth - 2 * kInside - 4)) {
        lines.push_back({std::move(line), &each.block});
      }
    }
    for (size_t first = 0; first < lines.size();) {
      flow_.require(2 * kInside + 3 * lines[first].block->lineHeight);
      double height = 0;
      size_t end = first;
      while (end < lines.size() && (end == first || height + lines[end].block->lineHeight + 12 <= flow_.left())) {
        height += lines[end++].block->lineHeight;
      }
      const double top = flow_.take(height + 12);
      const PlotBox box{kPageMargin, top, kPageMargin + kTextWidth, top + height + 12};
      flow_.drawing().box("box", box, ground, framed ? std::optional(pen) : std::nullopt);
      if (!framed) {
        flow_.drawing().line("box side", {box.left + pen.width / 2, box.top}, {box.left + pen.width / 2, box.bottom},
                             pen);
      }
      double y = top + 6;
      for (; first < end; ++first) {
        const TextBlock& block = *lines[first].block;
        flow_.drawing().text("boxed", {kPageMargin + kInside, y + block.lineHeight / 2}, lines[first].text,
                             {.size = block.size, .face = block.face, .paint = block.paint, .down = Down::kMiddle});
        y += block.lineHeight;
      }
    }
    flow_.space(9);
  }

  bool hasSources() const {
    const auto has = [](const ReportElement& element) {
      const auto* table = std::get_if<ReportTable>(&element);
      return table != nullptr && !sourcesOf(*table).empty();
    };
    return std::any_of(document_.elements.begin(), document_.elements.end(), has) ||
           std::any_of(document_.supplement.begin(), document_.supplement.end(), has);
  }

  /// Of every table: which cells came from where.
  void sources() {
    if (hasSources()) {
      flow(ReportHeading{1, kSourcesTitle}, {kSourcesId, ""});
      sourcesOfTables(document_.elements, names_.elements);
      sourcesOfTables(document_.supplement, names_.supplement);
    }
  }

  void sourcesOfTables(const std::vector<ReportElement>& part, const std::vector<ElementName>& names) {
    for (size_t i = 0; i < part.size(); ++i) {
      const auto* table = std::get_if<ReportTable>(&part[i]);
      const std::vector<SourceEntry> entries = table != nullptr ? sourcesOf(*table) : std::vector<SourceEntry>{};
      if (entries.empty()) {
        continue;
      }
      flow_.require(40);
      flowText(flow_, names[i].label, {.face = Face::kSansBold, .size = 8.5, .lineHeight = 13}, "source table");
      for (const SourceEntry& entry : entries) {
        std::string cells;
        for (const std::string& cell : entry.cells) {
          cells += cells.empty() ? "" : "; ";
          cells += cell;
        }
        sourceLines(cells, entry.source);
      }
      flow_.space(6);
    }
  }

  /// On one line where they fit.
  void sourceLines(const std::string& cells, const std::string& source) {
    const TextBlock cellLook{.face = Face::kSans, .size = 7.5, .lineHeight = 10};
    const double cellWidth = textWidth(cleanText(cells), cellLook.face, cellLook.size) + 8;
    TextBlock look{.face = Face::kMono, .size = 7, .lineHeight = 10, .paint = kSoftTextPaint, .indent = 10};
    if (cellWidth + textWidth(cleanText(source), look.face, look.size) <= kTextWidth) {
      flow_.require(look.lineHeight);
      const double y = kPageHeight - kPageMargin - flow_.left() + look.lineHeight / 2;
      flow_.drawing().text("source cells", {kPageMargin, y}, cells,
                           {.size = cellLook.size, .face = cellLook.face, .down = Down::kMiddle});
      look.indent = cellWidth;
    } else {
      flowText(flow_, cells, cellLook, "source cells");
    }
    flowText(flow_, source, look, "source");
  }

  void runningLines() {
    std::vector<PdfPage>& pages = flow_.pages();
    const TextLook soft{.size = 7.5, .paint = kSoftTextPaint, .down = Down::kMiddle};
    for (size_t i = 0; i < pages.size(); ++i) {
      Drawing& drawing = pages[i].drawing;
      const double right = kPageMargin + kTextWidth;
      TextLook atRight = soft;
      atRight.across = Across::kRight;
      const double head = kPageMargin - 20;
      if (i > 0) {
        drawing.text("running title", {kPageMargin, head},
                     shortened(cleanText(document_.title), Face::kSans, soft.size, 0.65 * kTextWidth), soft);
        TextLook marking = atRight;
        marking.face = Face::kSansBold;
        marking.paint = kCaution;
        drawing.text("running marking", {right, head},
                     shortened(cleanText(document_.marking), marking.face, soft.size, 0.3 * kTextWidth), marking);
      }
      const double foot = kPageHeight - kPageMargin + 24;
      drawing.text("running version", {kPageMargin, foot}, fmt::format("Ocelli {}", document_.version), soft);
      drawing.text("page number", {right, foot}, fmt::format("{} / {}", i + 1, pages.size()), atRight);
    }
  }

  static constexpr const char* kSupplementTitle = "Supplement";

  const ReportDocument& document_;
  DocumentNames names_;
  const PageNumbers& numbers_;
  PageFlow flow_;
  std::vector<PdfBookmark> bookmarks_;
};

}  // namespace

PdfDocument pdfPages(const ReportDocument& document) {
  // Laid out twice: the contents take the same room with and without their page numbers.
  const PdfDocument first = PdfWriter(document, {}).write();
  PageNumbers numbers;
  int page = 0;
  for (const PdfPage& each : first.pages) {
    ++page;
    for (const PdfTarget& target : each.targets) {
      numbers.emplace(target.name, page);
    }
  }
  return PdfWriter(document, numbers).write();
}

std::string pdfReport(const ReportDocument& document) {
  return pdfBytes(pdfPages(document));
}

}  // namespace ocelli
