#include "tests/feeds/made_blobs.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <numeric>

#include "oc_core/feeds/feed_graph.h"

namespace ocelli::test {
namespace {

constexpr double kHalfWidth = 0.22;  ///< metres
constexpr double kHalfHead = 0.1;    ///< metres
constexpr double kShoulders = 0.84;  ///< of a body's height

/// Fills the box of a part of a body between two heights, which are shares of its own.
void fill(const Feed& feed, const MadeBody& body, const glm::dvec2& heights, double half, FeedBlobs& blobs) {
  const glm::dvec3 side = glm::normalize(feed.pose.right()) * half;
  glm::dvec2 lower(1e9);
  glm::dvec2 upper(-1e9);
  constexpr int kSteps = 8;
  for (int k = 0; k <= kSteps; ++k) {
    const double height = body.height * (heights.x + (heights.y - heights.x) * k / kSteps);
    for (const double sign : {-1.0, 1.0}) {
      if (const auto q = feedPixelOf(feed, body.place + side * sign + glm::dvec3(0, height, 0))) {
        lower = glm::min(lower, *q);
        upper = glm::max(upper, *q);
      }
    }
  }
  const glm::ivec2 size(blobs.core.width(), blobs.core.height());
  const auto scale = static_cast<double>(blobs.scale);
  const glm::ivec2 from = glm::clamp(glm::ivec2(glm::round(lower / scale)), glm::ivec2(0), size);
  const glm::ivec2 to = glm::clamp(glm::ivec2(glm::round(upper / scale)), glm::ivec2(0), size);
  for (int y = from.y; y < to.y; ++y) {
    for (int x = from.x; x < to.x; ++x) {
      blobs.core(x, y) = 1;
      blobs.colors(x, y) = body.color;
    }
  }
}

/// Numbers the connected regions (by sides) of cells that are not 0.
void number(FeedBlobs& blobs) {
  Image<uint16_t>& cells = blobs.core;
  Image<uint16_t> numbers(cells.width(), cells.height());
  for (int y = 0; y < cells.height(); ++y) {
    for (int x = 0; x < cells.width(); ++x) {
      if (cells(x, y) == 0 || numbers(x, y) > 0) {
        continue;
      }
      blobs.blobs.emplace_back();
      const auto label = static_cast<uint16_t>(blobs.blobs.size());
      glm::ivec2 lower(x, y);
      glm::ivec2 upper(x, y);
      std::vector<glm::ivec2> open{{x, y}};
      numbers(x, y) = label;
      while (!open.empty()) {
        const glm::ivec2 at = open.back();
        open.pop_back();
        lower = glm::min(lower, at);
        upper = glm::max(upper, at);
        for (const glm::ivec2& way : {glm::ivec2(1, 0), glm::ivec2(-1, 0), glm::ivec2(0, 1), glm::ivec2(0, -1)}) {
          const glm::ivec2 next = at + way;
          if (cells.contains(next.x, next.y) && cells(next.x, next.y) > 0 && numbers(next.x, next.y) == 0) {
            numbers(next.x, next.y) = label;
            open.push_back(next);
          }
        }
      }
      SubjectBlob& blob = blobs.blobs.back();
      blob.lower = glm::dvec2(lower * blobs.scale);
      blob.upper = glm::dvec2((upper + 1) * blobs.scale);
      blob.isCutBelow = upper.y + 1 >= cells.height();
      blob.foot = {(blob.lower.x + blob.upper.x) / 2, blob.upper.y};
    }
  }
  cells = numbers;
}

}  // namespace

FeedBlobs blobsOf(const Feed& feed, const std::vector<MadeBody>& bodies) {
  FeedBlobs blobs;
  blobs.scale = maskScaleOf(feed.width);
  blobs.core = Image<uint16_t>(feed.width / blobs.scale, feed.height / blobs.scale);
  blobs.colors = Image<Rgb8>(blobs.core.width(), blobs.core.height(), Rgb8(100));
  std::vector<MadeBody> farFirst = bodies;
  std::sort(farFirst.begin(), farFirst.end(), [&](const MadeBody& a, const MadeBody& b) {
    return glm::length(a.place - feed.pose.eye) > glm::length(b.place - feed.pose.eye);
  });
  for (const MadeBody& body : farFirst) {
    fill(feed, body, {0, kShoulders}, kHalfWidth, blobs);
    fill(feed, body, {kShoulders, 1}, kHalfHead, blobs);
  }
  number(blobs);
  blobs.wide = blobs.core;
  return blobs;
}

std::vector<FeedBlobs> allBlobs(const FeedSetup& setup, const std::vector<MadeBody>& bodies) {
  std::vector<FeedBlobs> all;
  for (const Feed& feed : setup.feeds) {
    all.push_back(blobsOf(feed, bodies));
  }
  return all;
}

}  // namespace ocelli::test
