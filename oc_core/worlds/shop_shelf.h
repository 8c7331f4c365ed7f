// A shelf of a shop, with rows of packages on its boards (place_builder.h).
#pragma once

#include <glm/mat4x4.hpp>

#include "oc_core/worlds/place_builder.h"

namespace ocelli {

inline constexpr float kShopShelfDepth = 0.45f;
inline constexpr float kShopShelfHeight = 2.3f;

/// Its front in the plane z = 0 of its frame, from x = 0 to `length`, on y = 0; it reaches to z = -kShopShelfDepth.
void addShopShelf(PlaceBuilder& place, float length, const glm::mat4& worldFromShelf, uint32_t seed);

}  // namespace ocelli
