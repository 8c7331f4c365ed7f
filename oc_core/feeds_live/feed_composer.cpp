#include "oc_core/feeds_live/feed_composer.h"

#include <fmt/format.h>

#include "oc_core/base/error.h"
#include "oc_core/base/parallel.h"

namespace ocelli {
namespace {

Image<Rgb8> knownBackground(const Feed& feed) {
  if (feed.background.empty()) {
    return {};
  }
  Image<Rgb8> image = readPng(feed.background);
  if (image.width() != feed.width || image.height() != feed.height) {
    throw InputError(fmt::format("the background of feed \"{}\" has {}x{} pixels, the feed {}x{}", feed.name,
                                 image.width(), image.height(), feed.width, feed.height),
                     feed.background, "take it with the same camera at the same size");
  }
  return image;
}

}  // namespace

FeedComposer::FeedComposer(const FeedGraph& graph, const FeedBackgroundOptions& options)
    : graph_(graph),
      map_(graph),
      frames_(graph.setup().feeds.size()),
      isStale_(frames_.size(), 0),
      blobs_(frames_.size()),
      tracks_(graph_),
      marks_(graph.frusta()) {
  for (size_t i = 0; i < graph_.frusta(); ++i) {
    hidden_.emplace_back(graph_, i);
  }
  for (const Feed& feed : graph.setup().feeds) {
    portraits_.emplace_back(graph_, portraits_.size());
    backgrounds_.push_back(std::make_unique<FeedBackground>(feed.width, feed.height, knownBackground(feed), options));
  }
}

void FeedComposer::take(std::vector<Image<Rgb8>>& frames) {
  parallelFor(frames.size(), 1, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      if (!frames[i].empty() && isStale_[i] == 0) {
        blobs_[i] = backgrounds_[i]->update(frames[i]);
        std::swap(frames_[i], frames[i]);
      }
    }
  });
}

glm::dvec3 FeedComposer::commonLight() const {
  glm::dvec3 sum(0);
  double feeds = 0;
  for (size_t i = 0; i < graph_.frusta(); ++i) {
    if (const size_t feed = graph_.feedIndexOf(i); !frames_[feed].empty()) {
      sum += backgrounds_[feed]->light();
      ++feeds;
    }
  }
  return feeds > 0 ? sum / feeds : glm::dvec3(1);
}

void FeedComposer::compose(double seconds, ErasedLook erased, Image<Rgb8>& image) {
  std::vector<FeedBlobs> old(blobs_.size());
  const auto swapOld = [&] {
    for (size_t feed = 0; feed < blobs_.size(); ++feed) {
      if (isStale_[feed] != 0) {
        std::swap(old[feed], blobs_[feed]);
      }
    }
  };
  swapOld();
  tracks_.update(blobs_, seconds);
  std::vector<glm::dvec3> places;
  for (size_t i = 0; i < tracks_.count(); ++i) {
    places.push_back(tracks_.place(i));
  }
  parallelFor(showsHidden_ ? portraits_.size() : 0, 1, [&](size_t begin, size_t end) {
    for (size_t feed = begin; feed < end; ++feed) {
      if (!frames_[feed].empty() && isStale_[feed] == 0) {
        portraits_[feed].look(tracks_, frames_[feed], backgrounds_[feed]->light(), seconds);
      }
    }
  });
  const glm::dvec3 common = commonLight();
  std::vector<FeedPicture> pictures(graph_.frusta());
  parallelFor(pictures.size(), 1, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      const size_t feed = graph_.feedIndexOf(i);
      if (!frames_[feed].empty()) {
        marks_[i] = isStale_[feed] != 0 ? eraseSubjects(old[feed])
                                        : markSubjects(graph_, i, blobs_[feed], tracks_.cells(feed).who, places);
        const FeedBackground& background = *backgrounds_[feed];
        if (showsHidden_) {
          hidden_[i].update(tracks_, portraits_, seconds);
        }
        pictures[i] = {&frames_[feed], &hidden_[i].in(background.image()), &marks_[i], common / background.light(),
                       common};
      }
    }
  });
  composeFeeds(map_, pictures, erased, image);
  swapOld();
}

}  // namespace ocelli
