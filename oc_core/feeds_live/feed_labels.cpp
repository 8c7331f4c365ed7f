#include "oc_core/feeds_live/feed_labels.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "oc_core/base/utf8.h"
#include "oc_core/feeds_background/picture_text.h"

namespace ocelli {
namespace {

constexpr size_t kMaxLabelName = 20;  ///< letters
constexpr int kMinTextHeight = 7;
constexpr int kTextShare = 44;  ///< of the height of the image

/// "LATE ", for states that are worth a word.
std::string shoutOf(FeedState state) {
  if (state == FeedState::kLive) {
    return "";
  }
  std::string word = wordOf(state);
  std::transform(word.begin(), word.end(), word.begin(), [](char c) { return static_cast<char>(std::toupper(c)); });
  return word + " ";
}

/// Names as long as a sentence would cover the labels of others.
std::string shortName(const std::string& name) {
  const std::string clean = cleanText(name);
  const std::vector<char32_t> codes = codePoints(clean);
  if (codes.size() <= kMaxLabelName) {
    return clean;
  }
  std::string text;
  for (size_t i = 0; i + 2 < kMaxLabelName; ++i) {
    text += utf8FromCodePoint(codes[i]);
  }
  return text + "..";
}

int letterHeight(int imageHeight) {
  return std::max(kMinTextHeight, imageHeight / kTextShare);
}

bool areOver(const FeedLabelBox& a, const FeedLabelBox& b) {
  return a.left < b.left + b.width && b.left < a.left + a.width && a.top < b.top + b.height && b.top < a.top + a.height;
}

}  // namespace

std::string feedLabelText(const std::string& name, const FeedLabel& label) {
  std::string text = shortName(name) + " " + shoutOf(label.state) + label.remark + (label.remark.empty() ? "" : " ");
  if (!label.hasFrame) {
    return text + "no picture";
  }
  return text + (label.ageSeconds < 1 ? fmt::format("{:.0f} ms", 1e3 * label.ageSeconds)
                                      : fmt::format("{:.1f} s", label.ageSeconds));
}

std::vector<FeedLabelBox> feedLabelBoxes(const FeedGraph& graph, const std::vector<FeedLabel>& labels) {
  const FeedOutput& image = graph.setup().output;
  const int letter = letterHeight(image.height);
  std::vector<FeedLabelBox> boxes;
  for (size_t i = 0; i < labels.size(); ++i) {
    const auto& part = graph.camera().frusta()[i].part;
    glm::dvec2 corner(part.front());
    for (const glm::dvec2& p : part) {
      corner = glm::min(corner, p);
    }
    const int width = pictureTextWidth(feedLabelText(graph.setup().frusta[i].feed, labels[i]), letter) + letter;
    FeedLabelBox box{static_cast<int>(corner.x), static_cast<int>(corner.y) + letter / 2, width, 2 * letter};
    box.left = std::max(0, std::min(box.left, image.width - width));
    while (std::ranges::any_of(boxes, [&](const FeedLabelBox& other) { return areOver(box, other); })) {
      box.top += box.height;
    }
    boxes.push_back(box);
  }
  return boxes;
}

void drawFeedLabels(const FeedGraph& graph, const std::vector<FeedLabel>& labels, Image<Rgb8>& image) {
  const int letter = letterHeight(image.height());
  const std::vector<FeedLabelBox> boxes = feedLabelBoxes(graph, labels);
  for (size_t i = 0; i < labels.size(); ++i) {
    drawPictureText(image, feedLabelText(graph.setup().frusta[i].feed, labels[i]),
                    {boxes[i].left + letter / 2, boxes[i].top + boxes[i].height - letter / 2}, letter,
                    labels[i].isGood() ? Rgb8(255, 255, 255) : Rgb8(255, 90, 70));
  }
}

}  // namespace ocelli
