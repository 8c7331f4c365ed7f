// What turns rigidly about the display's axis: an object on a turntable, or, the other way round, an eye that walks
// around a scene at rest.
#pragma once

#include <glm/vec3.hpp>
#include <span>

namespace ocelli {

/// Positive radians turn counter-clockwise seen from above (+y).
glm::vec3 turnedAboutAxis(const glm::vec3& point, double radians);

/// The same for each of many points; both spans have the same length, and may be the same.
void turnAboutAxis(std::span<const glm::vec3> points, double radians, std::span<glm::vec3> turned);

}  // namespace ocelli
