// Rigs that can be simulated: a built-in scene, cameras in it, and the ways that people walk there.
//
// Recipe for a new one, two files:
//   1. oc_core/feeds_measure/NAME_rig.cpp: a function that returns its FeedRig, declared below;
//   2. oc_core/feeds_measure/feed_rigs.cpp: add it to the list.
#pragma once

#include <glm/vec2.hpp>
#include <span>
#include <string>
#include <string_view>

#include "oc_core/feeds/feed_setup.h"
#include "oc_core/feeds_measure/walkers.h"

namespace ocelli {

struct FeedRig {
  const char* scene;     ///< NAME of builtin:NAME
  FeedSetup (*setup)();  ///< sources are NAME.mkv and backgrounds NAME.png, NAME that of the feed
  WalkWays (*ways)();
};

std::span<const FeedRig> feedRigs();
/// The rig of a scene, "builtin:NAME" or "builtin:NAME,key=value". Throws InputError that lists the scenes that have
/// one.
const FeedRig& feedRigOf(const std::string& scene);

/// A feed NAME of a rig, with a lens without distortion.
Feed rigFeed(const std::string& name, const glm::ivec2& size, double focal, const glm::dvec3& eye,
             const glm::dvec3& target);
/// The setup with all feeds and the output so many pixels wide and high. What its cameras saw they still see: where the
/// new shape is wider or higher, they see more.
FeedSetup resizedSetup(FeedSetup setup, int width, int height);

FeedRig corridorRig();
FeedRig corridorTRig();
FeedRig courtyardRig();
FeedRig shopRig();

}  // namespace ocelli
