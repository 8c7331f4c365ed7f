// The light of relief pictures: a sun far away, the same that shading.h bakes, whose shadows are cast, and some light
// from everywhere.
#pragma once

#include <glm/vec3.hpp>

namespace ocelli {

/// A unit vector in the world.
glm::vec3 directionToSun();

/// The factor of the colour where the unit normal faces the viewer: 0.25 without the sun, up to 1 with it.
float sunlitShade(const glm::vec3& normal, bool lit);

/// What is behind everything, linear.
glm::vec3 reliefBackground();

}  // namespace ocelli
