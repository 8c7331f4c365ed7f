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
  const FeedMarks* marks = nullptr;
  // Factors of light, per channel, at most 4: cameras choose exposures of their own, the image has one.
  glm::dvec3 frameLight{1};
  glm::dvec3 backgroundLight{1};
};

/// How pixels look from which a subject was erased, which are not live.
enum class ErasedLook { kBackground, kRed };

/// Sets `image`, of the size of the map. `pictures` has one entry a frustum. What no feed shows is hatched.
void composeFeeds(const FeedMap& map, std::span<const FeedPicture> pictures, ErasedLook erased, Image<Rgb8>& image);

}  // namespace ocelli
