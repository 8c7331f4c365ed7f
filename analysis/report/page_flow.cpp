#include "analysis/report/page_flow.h"

#include "oc_core/base/utf8.h"

namespace ocelli {

void PageFlow::require(double height) {
  if (height > left() && !atTop()) {
    pages_.emplace_back();
    y_ = kPageMargin;
  }
}

double PageFlow::take(double height) {
  const double top = y_;
  y_ += height;
  return top;
}

void PageFlow::space(double height) {
  if (!atTop()) {
    y_ += height;
  }
}

void flowText(PageFlow& flow, const std::string& text, const TextBlock& block, const std::string& part) {
  const std::vector<std::string> lines =
      brokenLines(cleanText(text), block.face, block.size, kTextWidth - block.indent - block.rightGap);
  for (size_t i = 0; i < lines.size(); ++i) {
    const size_t after = lines.size() - i;
    // The first two stay together, and so do the last two.
    const bool pair = (i == 0 && after > 1) || after == 2;
    const size_t together = i == 0 && after == 3 ? 3 : pair ? 2 : 1;
    flow.require(static_cast<double>(together) * block.lineHeight);
    const double top = flow.take(block.lineHeight);
    flow.drawing().text(part, {kPageMargin + block.indent, top + block.lineHeight / 2}, lines[i],
                        {.size = block.size, .face = block.face, .paint = block.paint, .down = Down::kMiddle});
  }
}

}  // namespace ocelli
