// Cameras that are shown as they are, from files or by their names, as `--camera` of other commands takes them.
#pragma once

#include <string>

#include "oc_core/explore/explorer.h"

namespace ocelli {

/// Builds it for the scene and shows it as `drawn`. Throws as constructCamera() does.
void showCamera(Explorer& explorer, const std::string& nameOrFile);

/// Throws InputError for what exploreFrom() does not know, before a scene is read: neither a live constructor nor a
/// camera's file.
void checkExploreCamera(const std::string& constructorOrFile);
/// Chooses a live constructor by its name, or shows the camera of a file.
void exploreFrom(Explorer& explorer, const std::string& constructorOrFile);

}  // namespace ocelli
