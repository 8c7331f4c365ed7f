#include "analysis/report/table_layout.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <numeric>
#include <utility>

#include "analysis/plot/style.h"
#include "oc_core/base/utf8.h"

namespace ocelli {
namespace {

constexpr double kPadding = 4;       // left and right of a cell, each
constexpr double kRowPadding = 2.2;  // above and below
constexpr double kMaxWords = 190;    // points that a column of words takes unbroken
constexpr double kMinHead = 26;
constexpr double kHeavyRule = 1;
constexpr double kMarkSize = 6;

constexpr double kSizes[] = {8.5, 8, 7.5, 7};

bool isWords(const ReportTable& table, size_t column) {
  return column == 0 || (column < table.columns.size() && table.columns[column].words);
}

/// The widths that columns ask for at that size, and whether words may be broken further.
struct Wish {
  std::vector<double> full;
  std::vector<double> least;
};

Wish wishOf(const ReportTable& table, double size) {
  Wish wish;
  for (size_t c = 0; c < table.columns.size(); ++c) {
    double full = 0;
    for (const std::vector<ReportCell>& row : table.rows) {
      if (c < row.size()) {
        const Face face = row[c].emphasised ? Face::kSansBold : Face::kSans;
        full = std::max(full, textWidth(cleanText(row[c].text), face, size));
      }
    }
    // Heads break between words first.
    const std::string title = cleanText(table.columns[c].title);
    double head = kMinHead;
    for (size_t from = 0; from <= title.size();) {
      const size_t to = std::min(title.find(' ', from), title.size());
      head = std::max(head, textWidth(title.substr(from, to - from), Face::kSansBold, size));
      from = to + 1;
    }
    const bool words = isWords(table, c);
    const double cells = words ? std::min(full, kMaxWords) : full;
    wish.full.push_back(std::max(cells, head) + 2 * kPadding);
    wish.least.push_back(words ? std::min(wish.full.back(), 60 + 2 * kPadding) : wish.full.back());
  }
  return wish;
}

double sumOf(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

using CellLines = std::vector<std::string>;

class TablePainter {
 public:
  TablePainter(PageFlow& flow, const ReportTable& table, ElementName name)
      : flow_(flow),
        table_(table),
        name_(std::move(name)),
        layout_(layOut(table, kTextWidth)),
        lineHeight_(1.25 * layout_.size),
        footnotes_(footnotesOf(table)) {
    hasGroups_ = std::any_of(table.columns.begin(), table.columns.end(),
                             [](const ReportColumn& column) { return !column.group.empty(); });
    for (const ReportColumn& column : table.columns) {
      head_.push_back(cellLines(cleanText(column.title), Face::kSansBold, head_.size()));
    }
  }

  void paint() {
    const std::vector<std::vector<CellLines>> rows = rowLines();
    const double firstRow = rows.empty() ? 0 : heightOf(rows.front());
    // The caption, the head and a row stay together.
    const double caption = 12 * static_cast<double>(captionLines("").size()) + 4;
    flow_.require(caption + headHeight() + firstRow + 10);
    if (!name_.id.empty()) {
      flow_.page().targets.push_back({name_.id, {0, std::max(0.0, kPageHeight - kPageMargin - flow_.left() - 6)}});
    }
    paintCaption("");
    paintHead();
    for (size_t r = 0; r < rows.size(); ++r) {
      const double height = heightOf(rows[r]);
      if (height > flow_.left() && !flow_.atTop()) {
        paintRule(kHeavyRule);
        flow_.require(height + headHeight() + caption);
        paintCaption(" (continued)");
        paintHead();
      }
      paintRow(rows[r], table_.rows[r], height);
      if (r + 1 < rows.size()) {
        paintRule(0.25);
      }
    }
    paintRule(kHeavyRule);
    paintFootnotes();
    flow_.space(10);
  }

 private:
  CellLines cellLines(const std::string& text, Face face, size_t column) const {
    const double width = column < layout_.widths.size() ? layout_.widths[column] - 2 * kPadding : kMaxWords;
    return brokenLines(text, face, layout_.size, width + 0.01);
  }
  std::vector<std::vector<CellLines>> rowLines() const {
    std::vector<std::vector<CellLines>> rows;
    for (const std::vector<ReportCell>& row : table_.rows) {
      std::vector<CellLines> cells;
      for (size_t c = 0; c < row.size() && c < table_.columns.size(); ++c) {
        cells.push_back(cellLines(cleanText(row[c].text), row[c].emphasised ? Face::kSansBold : Face::kSans, c));
        if (!row[c].shortName.empty()) {
          cells.back().push_back(cleanText(row[c].shortName));
        }
      }
      rows.push_back(std::move(cells));
    }
    return rows;
  }
  double heightOf(const std::vector<CellLines>& cells) const {
    size_t most = 1;
    for (const CellLines& lines : cells) {
      most = std::max(most, lines.size());
    }
    return 2 * kRowPadding + lineHeight_ * static_cast<double>(most);
  }
  double headHeight() const { return heightOf(head_) + (hasGroups_ ? 2 * kRowPadding + lineHeight_ : 0); }
  double columnLeft(size_t column) const {
    return kPageMargin +
           std::accumulate(layout_.widths.begin(), layout_.widths.begin() + static_cast<std::ptrdiff_t>(column), 0.0);
  }

  CellLines captionLines(const std::string& more) const {
    const std::string mark = table_.exploratory ? fmt::format(" ({})", kExploratory) : "";
    return brokenLines(cleanText(fmt::format("{}{}.{} {}", name_.label, more, mark, table_.caption)), Face::kSansBold,
                       9, kTextWidth);
  }
  void paintCaption(const std::string& more) {
    for (const std::string& line : captionLines(more)) {
      const double top = flow_.take(12);
      flow_.drawing().text("caption", {kPageMargin, top + 6}, line,
                           {.size = 9, .face = Face::kSansBold, .paint = kTextPaint, .down = Down::kMiddle});
    }
    flow_.take(4);
  }
  void paintHead() {
    paintRule(kHeavyRule);
    if (hasGroups_) {
      paintGroups();
    }
    const double height = heightOf(head_);
    const double top = flow_.take(height);
    for (size_t c = 0; c < head_.size(); ++c) {
      // Set at the foot of the head.
      const double down = height - 2 * kRowPadding - lineHeight_ * static_cast<double>(head_[c].size());
      paintCell("head", head_[c], c, top + down, Face::kSansBold);
    }
    paintRule(0.5);
  }
  void paintGroups() {
    const double top = flow_.take(2 * kRowPadding + lineHeight_);
    for (size_t c = 0; c < table_.columns.size();) {
      size_t end = c;
      while (end < table_.columns.size() && table_.columns[end].group == table_.columns[c].group) {
        ++end;
      }
      if (!table_.columns[c].group.empty()) {
        const double left = columnLeft(c) + kPadding;
        const double right = columnLeft(end) - kPadding;
        flow_.drawing().text("head", {(left + right) / 2, top + kRowPadding + lineHeight_ / 2},
                             shortened(cleanText(table_.columns[c].group), Face::kSansBold, layout_.size, right - left),
                             {.size = layout_.size,
                              .face = Face::kSansBold,
                              .paint = kTextPaint,
                              .across = Across::kMiddle,
                              .down = Down::kMiddle});
        const double y = top + 2 * kRowPadding + lineHeight_ - 0.5;
        flow_.drawing().line("rule", {left, y}, {right, y}, {kAxisPaint, 0.4});
      }
      c = end;
    }
  }
  void paintRow(const std::vector<CellLines>& cells, const std::vector<ReportCell>& row, double height) {
    const double top = flow_.take(height);
    for (size_t c = 0; c < cells.size(); ++c) {
      CellLines lines = cells[c];
      if (!row[c].shortName.empty()) {
        paintShortName(lines.back(), c, top + lineHeight_ * static_cast<double>(lines.size() - 1));
        lines.pop_back();
      }
      paintCell("cell", lines, c, top, row[c].emphasised ? Face::kSansBold : Face::kSans);
      if (!row[c].footnote.empty()) {
        paintMark(cells[c].front(), row[c], c, top);
      }
      // The first cells of a table in parts stand in each of them.
      if (!row[c].id.empty() && (c > 0 || !name_.id.empty())) {
        flow_.page().targets.push_back({row[c].id, {0, top}});
      }
    }
  }
  void paintCell(const std::string& part, const CellLines& lines, size_t column, double top, Face face) {
    const bool words = isWords(table_, column);
    const double x = words ? columnLeft(column) + kPadding : columnLeft(column + 1) - kPadding;
    for (size_t i = 0; i < lines.size(); ++i) {
      flow_.drawing().text(part, {x, top + kRowPadding + lineHeight_ * (static_cast<double>(i) + 0.5)}, lines[i],
                           {.size = layout_.size,
                            .face = face,
                            .paint = kTextPaint,
                            .across = words ? Across::kLeft : Across::kRight,
                            .down = Down::kMiddle});
    }
  }
  /// As the last line of its cell.
  void paintShortName(const std::string& name, size_t column, double top) {
    const bool words = isWords(table_, column);
    const double size = 0.8 * layout_.size;
    flow_.drawing().text("short name",
                         {words ? columnLeft(column) + kPadding : columnLeft(column + 1) - kPadding,
                          top + kRowPadding + lineHeight_ / 2},
                         shortened(name, Face::kSans, size, layout_.widths[column] - 2 * kPadding),
                         {.size = size,
                          .paint = kSoftTextPaint,
                          .across = words ? Across::kLeft : Across::kRight,
                          .down = Down::kMiddle});
  }
  /// Of its footnote, beside the text, in the padding of the cell: numbers stay below each other.
  void paintMark(const std::string& line, const ReportCell& cell, size_t column, double top) {
    const Face face = cell.emphasised ? Face::kSansBold : Face::kSans;
    const double textEnd = isWords(table_, column) ? columnLeft(column) + kPadding + textWidth(line, face, layout_.size)
                                                   : columnLeft(column + 1) - kPadding;
    flow_.drawing().text("mark", {textEnd + 0.6, top + kRowPadding + 0.3 * lineHeight_},
                         footnoteMark(footnotes_, cell.footnote),
                         {.size = kMarkSize, .paint = kTextPaint, .down = Down::kMiddle});
  }
  void paintRule(double width) {
    const double y = flow_.take(width);
    flow_.drawing().line("rule", {kPageMargin, y + width / 2}, {kPageMargin + sumOf(layout_.widths), y + width / 2},
                         {width > 0.3 ? kTextPaint : kAxisPaint.faded(0.5), width});
  }
  void paintFootnotes() {
    flow_.take(2);
    for (const std::string& footnote : footnotes_) {
      flowText(flow_, fmt::format("{}  {}", footnoteMark(footnotes_, footnote), footnote),
               {.face = Face::kSans, .size = 7.5, .lineHeight = 9.5, .paint = kSoftTextPaint}, "footnote");
    }
  }

  PageFlow& flow_;
  const ReportTable& table_;
  ElementName name_;
  TableLayout layout_;
  double lineHeight_;
  std::vector<std::string> footnotes_;
  bool hasGroups_ = false;
  std::vector<CellLines> head_;
};

}  // namespace

TableLayout layOut(const ReportTable& table, double width) {
  Wish wish;
  double size = 0;
  for (const double each : kSizes) {
    size = each;
    wish = wishOf(table, size);
    if (sumOf(wish.full) <= width) {
      return {size, wish.full};
    }
    if (sumOf(wish.least) <= width) {
      // Columns of words share what is left, as they asked.
      const double share = (width - sumOf(wish.least)) / (sumOf(wish.full) - sumOf(wish.least));
      for (size_t c = 0; c < wish.full.size(); ++c) {
        wish.least[c] += share * (wish.full[c] - wish.least[c]);
      }
      return {size, wish.least};
    }
  }
  const double shrink = width / sumOf(wish.least);
  for (double& each : wish.least) {
    each *= shrink;
  }
  return {size, wish.least};
}

std::vector<ReportTable> partsOf(const ReportTable& table, double width) {
  const Wish wish = wishOf(table, kSizes[std::size(kSizes) - 1]);
  std::vector<ReportTable> parts;
  for (size_t c = 1; c < table.columns.size();) {
    size_t end = c;
    double used = wish.least[0];
    while (end < table.columns.size() && (end == c || used + wish.least[end] <= width)) {
      used += wish.least[end++];
    }
    ReportTable part{table.caption, table.id, {table.columns[0]}, {}};
    part.exploratory = table.exploratory;
    const auto take = [&](const auto& from, auto& to) {
      for (size_t k = c; k < end && k < from.size(); ++k) {
        to.push_back(from[k]);
      }
    };
    take(table.columns, part.columns);
    for (const std::vector<ReportCell>& row : table.rows) {
      part.rows.emplace_back(row.begin(), row.begin() + (row.empty() ? 0 : 1));
      take(row, part.rows.back());
    }
    parts.push_back(std::move(part));
    c = end;
  }
  return parts.empty() ? std::vector{table} : parts;
}

void flowTable(PageFlow& flow, const ReportTable& table, const ElementName& name) {
  const std::vector<ReportTable> parts = partsOf(table, kTextWidth);
  for (size_t i = 0; i < parts.size(); ++i) {
    const std::string more = parts.size() == 1 ? "" : fmt::format(" ({} of {})", i + 1, parts.size());
    TablePainter(flow, parts[i], {i == 0 ? name.id : "", name.label + more}).paint();
  }
}

}  // namespace ocelli
