// How the state of a feed looks: a mark of its own shape and colour, and words. For the .cpp files of this room.
#pragma once

#include <glm/vec2.hpp>
#include <span>
#include <string>

#include "oc_core/feeds_live/feed_labels.h"

struct ImDrawList;

namespace ocelli {

/// What the help says of each state.
struct FeedStateMeaning {
  FeedState state;
  const char* meaning;
};
std::span<const FeedStateMeaning> feedStateMeanings();

/// Positions are top left corners in screen coordinates; `scale` is the length of 1 at 96 dots an inch.
void drawFeedMark(ImDrawList& list, const glm::vec2& at, FeedState state, float scale);
/// The mark, the name, the state, and the age of the frame, in a line of text.
void drawFeedState(ImDrawList& list, const glm::vec2& at, const std::string& name, const FeedLabel& label, float scale);
/// How wide that is, with the space behind it.
float feedStateWidth(const std::string& name, const FeedLabel& label, float scale);
/// The same on a dark plate, to be read over images.
void drawFeedPlate(ImDrawList& list, const glm::vec2& at, const std::string& name, const FeedLabel& label, float scale);

}  // namespace ocelli
