#include "oc_core/feeds_live/feed_panes.h"

#include <algorithm>
#include <cmath>

#include "oc_core/base/parallel.h"
#include "oc_core/feeds_background/picture_text.h"

namespace ocelli {
namespace {

constexpr int kPaneGap = 4;         ///< pixels between panes
constexpr int kPaneTextShare = 22;  ///< of the height of a pane
constexpr int kMinPaneText = 9;     ///< pixels
const Rgb8 kPaneGround(16);
const Rgb8 kNoPicture(64);

/// The mean of the pixels of `image` in [left, right) x [top, bottom), which is not empty.
Rgb8 meanOf(const Image<Rgb8>& image, int left, int top, int right, int bottom) {
  glm::ivec3 sum(0);
  for (int y = top; y < bottom; ++y) {
    for (int x = left; x < right; ++x) {
      sum += glm::ivec3(image(x, y));
    }
  }
  const int count = (right - left) * (bottom - top);
  return Rgb8((sum + count / 2) / count);
}

void drawScaled(const Image<Rgb8>& frame, const FeedPane& pane, Image<Rgb8>& image) {
  const auto edge = [](int k, int size, int of) { return static_cast<int>(static_cast<int64_t>(k) * of / size); };
  parallelFor(static_cast<size_t>(pane.height), 16, [&](size_t begin, size_t end) {
    for (auto y = static_cast<int>(begin); y < static_cast<int>(end); ++y) {
      const int top = edge(y, pane.height, frame.height());
      const int bottom = std::max(top + 1, edge(y + 1, pane.height, frame.height()));
      for (int x = 0; x < pane.width; ++x) {
        const int left = edge(x, pane.width, frame.width());
        const int right = std::max(left + 1, edge(x + 1, pane.width, frame.width()));
        image(pane.left + x, pane.top + y) = meanOf(frame, left, top, right, bottom);
      }
    }
  });
}

/// In so many columns.
std::vector<FeedPane> panesInColumns(const FeedSetup& setup, int width, int height, int columns) {
  const auto count = static_cast<int>(setup.frusta.size());
  const int rows = (count + columns - 1) / columns;
  std::vector<FeedPane> panes;
  for (int i = 0; i < count; ++i) {
    const Feed& feed = setup.feeds[static_cast<size_t>(setup.feedIndex(setup.frusta[static_cast<size_t>(i)].feed))];
    const auto cell = [&](int k, int of, int size) { return k * (size + kPaneGap) / of; };
    const int left = cell(i % columns, columns, width);
    const int top = cell(i / columns, rows, height);
    const int cellWidth = std::max(1, cell(i % columns + 1, columns, width) - kPaneGap - left);
    const int cellHeight = std::max(1, cell(i / columns + 1, rows, height) - kPaneGap - top);
    const double scale =
        std::min(static_cast<double>(cellWidth) / feed.width, static_cast<double>(cellHeight) / feed.height);
    FeedPane pane;
    pane.width = std::clamp(static_cast<int>(std::lround(feed.width * scale)), 1, cellWidth);
    pane.height = std::clamp(static_cast<int>(std::lround(feed.height * scale)), 1, cellHeight);
    pane.left = left + (cellWidth - pane.width) / 2;
    pane.top = top + (cellHeight - pane.height) / 2;
    panes.push_back(pane);
  }
  return panes;
}

int64_t pixelsOf(const std::vector<FeedPane>& panes) {
  int64_t pixels = 0;
  for (const FeedPane& pane : panes) {
    pixels += int64_t{pane.width} * pane.height;
  }
  return pixels;
}

}  // namespace

std::vector<FeedPane> feedPanes(const FeedSetup& setup, int width, int height) {
  std::vector<FeedPane> best;
  for (int columns = 1; columns <= static_cast<int>(setup.frusta.size()); ++columns) {
    std::vector<FeedPane> panes = panesInColumns(setup, width, height, columns);
    if (pixelsOf(panes) > pixelsOf(best)) {
      best = std::move(panes);
    }
  }
  return best;
}

void drawFeedPanes(const FeedComposer& composer, const std::vector<FeedLabel>& labels, Image<Rgb8>& image) {
  const FeedGraph& graph = composer.graph();
  const FeedSetup& setup = graph.setup();
  image = Image<Rgb8>(setup.output.width, setup.output.height, kPaneGround);
  const std::vector<FeedPane> panes = feedPanes(setup, image.width(), image.height());
  for (size_t i = 0; i < panes.size(); ++i) {
    const FeedPane& pane = panes[i];
    const Image<Rgb8>& frame = composer.frame(graph.feedIndexOf(i));
    drawScaled(frame.empty() ? Image<Rgb8>(1, 1, kNoPicture) : frame, pane, image);
    if (i < labels.size()) {
      const int height = std::max(kMinPaneText, pane.height / kPaneTextShare);
      drawPictureText(image, feedLabelText(setup.frusta[i].feed, labels[i]),
                      {pane.left + height / 2, pane.top + 3 * height / 2}, height,
                      labels[i].hasFrame ? Rgb8(255) : Rgb8(255, 90, 70));
    }
  }
}

}  // namespace ocelli
