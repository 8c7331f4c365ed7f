// The image of a graph camera from the last frames of its feeds.
#pragma once

#include <glm/vec3.hpp>
#include <span>

#include "oc_core/feeds/feed_map.h"
#include "oc_core/feeds/subject_marks.h"
#include "oc_core/image/png_file.h"

namespace ocelli {

/// What a feed gives to a frustum. Null where there is nothing of it yet.
struct FeedPicture {
  const Image<Rgb8>* frame = nullptr;
  const Image<Rgb8>* background = nullptr;  ///< without subjects
  glm::dvec3 light{1};                      ///< of the frame: so much that of the background, per channel
  const FeedMarks* marks = nullptr;
};

/// How pixels look from which a subject was erased, which are not live.
enum class ErasedLook { kBackground, kRed };

/// Sets `image`, of the size of the map. `pictures` has one entry a frustum. What no feed shows is hatched.
void composeFeeds(const FeedMap& map, std::span<const FeedPicture> pictures, ErasedLook erased, Image<Rgb8>& image);

}  // namespace ocelli
