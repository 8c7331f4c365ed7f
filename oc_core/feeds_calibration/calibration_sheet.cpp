#include "oc_core/feeds_calibration/calibration_sheet.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

#include "oc_core/base/error.h"
#include "oc_core/base/number_text.h"
#include "oc_core/drawing/pdf_file.h"

namespace ocelli {
namespace {

constexpr double kEdgeMillimetres = 8;     ///< printers leave this blank
constexpr double kFooterMillimetres = 14;  ///< ruler and text
constexpr double kRulerMillimetres = 100;
constexpr double kTextPoints = 8;
/// A finder needs white around a tag: a cell of its ten.
constexpr double kTagMarginShare = 1.0 / 8;

struct PaperRow {
  const char* name;
  SheetPaper paper;
};
constexpr std::array kPapers{PaperRow{"a4", {297, 210}}, PaperRow{"a3", {420, 297}}, PaperRow{"a2", {594, 420}},
                             PaperRow{"a1", {841, 594}}, PaperRow{"a0", {1189, 841}}};

PlotPoint pointAt(double x, double y) {
  return {x * kPointsPerMillimetre, y * kPointsPerMillimetre};
}

/// A path a square, all in one shape: viewers that smooth edges leave no hairlines between overlapping cells.
void addBlack(Drawing& drawing, const std::vector<BlackSquare>& squares, double left, double top) {
  PathShape shape;
  shape.closed = true;
  shape.fill = Paint{};
  for (const BlackSquare& square : squares) {
    const double x = left + square.corner.x;
    const double y = top + square.corner.y;
    const double s = square.side;
    shape.lines.push_back({pointAt(x, y), pointAt(x + s, y), pointAt(x + s, y + s), pointAt(x, y + s)});
  }
  drawing.path("black", shape);
}

void addFooter(Drawing& drawing, const SheetPaper& paper, const std::string& text) {
  const double y = paper.heightMillimetres - kEdgeMillimetres - 6;
  const double length =
      std::min(kRulerMillimetres, 10 * std::floor((paper.widthMillimetres - 2 * kEdgeMillimetres) / 10));
  const Pen pen{Paint{}, 0.5};
  drawing.line("ruler", pointAt(kEdgeMillimetres, y), pointAt(kEdgeMillimetres + length, y), pen);
  for (double x = 0; x <= length; x += 10) {
    drawing.line("ruler", pointAt(kEdgeMillimetres + x, y - (x == 0 || x == length ? 3 : 1.5)),
                 pointAt(kEdgeMillimetres + x, y), pen);
  }
  TextLook look;
  look.size = kTextPoints;
  look.paint = Paint{};
  drawing.text("text", pointAt(kEdgeMillimetres, y + 4.5),
               fmt::format("The ruler is {} mm long: print at 100 %.   {}", length, text), look);
}

[[noreturn]] void failSize(const std::string& what, double width, double height, const SheetPaper& paper,
                           const std::string& smaller) {
  throw InputError(fmt::format("{} of {:.4g} x {:.4g} mm does not fit", what, width, height),
                   fmt::format("paper of {:.4g} x {:.4g} mm", paper.widthMillimetres, paper.heightMillimetres),
                   fmt::format("take larger paper or {}: edges take {} mm, the line below {}", smaller,
                               kEdgeMillimetres, kFooterMillimetres));
}

PdfPage boardPage(const CalibrationBoard& board, const SheetPaper& paper) {
  const double width = board.squaresAcross() * board.squareMillimetres;
  const double height = board.squaresDown() * board.squareMillimetres;
  const double left = (paper.widthMillimetres - width) / 2;
  const double top = (paper.heightMillimetres - kFooterMillimetres - height) / 2;
  if (left < kEdgeMillimetres || top < kEdgeMillimetres) {
    failSize("a board", width, height, paper, "smaller squares");
  }
  PdfPage page;
  addBlack(page.drawing, blackSquaresOf(board), left, top);
  addFooter(page.drawing, paper, "--board " + textOf(board));
  return page;
}

std::vector<PdfPage> tagPages(const std::vector<int>& ids, double tagMillimetres, const SheetPaper& paper) {
  const double margin = tagMillimetres * kTagMarginShare;
  constexpr double kLabelMillimetres = 6;
  const double cellWidth = tagMillimetres + 2 * margin;
  const double cellHeight = cellWidth + kLabelMillimetres;
  const auto across = static_cast<size_t>((paper.widthMillimetres - 2 * kEdgeMillimetres) / cellWidth);
  const auto down =
      static_cast<size_t>((paper.heightMillimetres - 2 * kEdgeMillimetres - kFooterMillimetres) / cellHeight);
  if (across == 0 || down == 0) {
    const double most =
        std::min(paper.widthMillimetres - 2 * kEdgeMillimetres,
                 paper.heightMillimetres - 2 * kEdgeMillimetres - kFooterMillimetres - kLabelMillimetres);
    failSize("a tag with its white margin", cellWidth, cellHeight, paper,
             fmt::format("black squares of {:.0f} mm", std::floor(most / (1 + 2 * kTagMarginShare))));
  }
  std::vector<PdfPage> pages;
  for (size_t first = 0; first < ids.size(); first += across * down) {
    PdfPage page;
    for (size_t i = first; i < std::min(ids.size(), first + across * down); ++i) {
      const double left = kEdgeMillimetres + margin + static_cast<double>((i - first) % across) * cellWidth;
      const double top = kEdgeMillimetres + margin + static_cast<double>((i - first) / across) * cellHeight;
      addBlack(page.drawing, blackSquaresOfTag(ids[i], tagMillimetres), left, top);
      TextLook look;
      look.size = kTextPoints;
      look.paint = Paint{};
      look.across = Across::kMiddle;
      page.drawing.text("text", pointAt(left + tagMillimetres / 2, top + tagMillimetres + margin + 3.5),
                        fmt::format("tag {}, upright", ids[i]), look);
    }
    addFooter(page.drawing, paper, fmt::format("AprilTag 36h11, black squares of {:.6g} mm", tagMillimetres));
    pages.push_back(std::move(page));
  }
  return pages;
}

}  // namespace

SheetPaper paperFromText(const std::string& text) {
  const auto row = std::ranges::find(kPapers, text, &PaperRow::name);
  if (row != kPapers.end()) {
    return row->paper;
  }
  const size_t mark = text.find('x');
  const auto width = numberFromText<double>(text.substr(0, mark));
  const auto height = mark == std::string::npos ? std::nullopt : numberFromText<double>(text.substr(mark + 1));
  constexpr double kMaxSide = 5000;
  if (!width || !height || !(*width >= 50) || !(*height >= 50) || *width > kMaxSide || *height > kMaxSide) {
    throw InputError("\"" + text + "\" is no paper", "--paper",
                     "write a4, a3, a2, a1 or a0, or WIDTHxHEIGHT from 50 to 5000 mm");
  }
  return {*width, *height};
}

std::string calibrationSheetPdf(const SheetContents& contents, const SheetPaper& paper) {
  PdfDocument document;
  document.width = paper.widthMillimetres * kPointsPerMillimetre;
  document.height = paper.heightMillimetres * kPointsPerMillimetre;
  if (contents.board) {
    document.title = "Calibration board " + textOf(*contents.board);
    document.pages.push_back(boardPage(*contents.board, paper));
  }
  if (!contents.tags.empty()) {
    document.title += contents.board ? " and AprilTags 36h11" : "AprilTags 36h11";
    std::ranges::move(tagPages(contents.tags, contents.tagMillimetres, paper), std::back_inserter(document.pages));
  }
  return pdfBytes(document);
}

}  // namespace ocelli
