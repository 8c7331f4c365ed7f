// What the JSON files of this room share. Include it in .cpp files only, as json_fields.h.
#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <string>

#include "oc_core/base/json_fields.h"
#include "oc_core/feeds/known_places.h"

namespace ocelli {

inline constexpr double kMaxFeedMetres = 1e5;
inline constexpr size_t kMaxFeedNameLength = 64;

glm::dvec3 readFeedPoint(JsonFields& fields, const std::string& name);
/// Four points.
std::array<glm::dvec3, 4> readFeedCorners(JsonFields& fields, const std::string& name);
nlohmann::ordered_json jsonOfPoint(const glm::dvec3& point);
nlohmann::ordered_json jsonOfCorners(const std::array<glm::dvec3, 4>& corners);

KnownPlaces readPlacesFields(JsonFields fields);
nlohmann::ordered_json jsonOfPlaces(const KnownPlaces& places);

}  // namespace ocelli
