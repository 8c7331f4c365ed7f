// Pages that fill from the top down: who needs room takes it, on the next page where this one has too little.
#pragma once

#include <string>
#include <vector>

#include "oc_core/drawing/pdf_file.h"

namespace ocelli {

// A4 with margins of 20 mm: a double column of 170 mm fits.
inline constexpr double kPageWidth = 210 * kPointsPerMillimetre;
inline constexpr double kPageHeight = 297 * kPointsPerMillimetre;
inline constexpr double kPageMargin = 20 * kPointsPerMillimetre;
inline constexpr double kTextWidth = kPageWidth - 2 * kPageMargin;

class PageFlow {
 public:
  PageFlow() { pages_.emplace_back(); }

  /// Ends the page if fewer points than that are left, unless it is still empty.
  void require(double height);
  /// The top of that much room on the page, which must have been required; what comes next is below.
  double take(double height);
  /// Not at the top of a page.
  void space(double height);

  Drawing& drawing() { return pages_.back().drawing; }
  PdfPage& page() { return pages_.back(); }
  int pageNumber() const { return static_cast<int>(pages_.size()); }
  double left() const { return kPageHeight - kPageMargin - y_; }
  bool atTop() const { return y_ <= kPageMargin; }
  std::vector<PdfPage>& pages() { return pages_; }

 private:
  std::vector<PdfPage> pages_;
  double y_ = kPageMargin;
};

struct TextBlock {
  Face face = Face::kSerif;
  double size = 10;
  double lineHeight = 14;
  Paint paint = paintOf(page_color::kText);
  double indent = 0;    ///< from the left margin
  double rightGap = 0;  ///< from the right one
};

/// Lines over as many pages as it takes; never one line alone at the foot or at the top of a page.
void flowText(PageFlow& flow, const std::string& text, const TextBlock& block, const std::string& part = "text");

}  // namespace ocelli
