#include "oc_core/feeds/feed_fields.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace ocelli {

glm::dvec3 readFeedPoint(JsonFields& fields, const std::string& name) {
  const std::vector<double> p = fields.numbers(name, 3, -kMaxFeedMetres, kMaxFeedMetres);
  return {p[0], p[1], p[2]};
}

std::array<glm::dvec3, 4> readFeedCorners(JsonFields& fields, const std::string& name) {
  std::array<glm::dvec3, 4> corners{};
  const nlohmann::json& given = fields.value(name);
  if (!given.is_array() || given.size() != corners.size()) {
    fields.fail(name, "must be an array of 4 points");
  }
  for (size_t i = 0; i < corners.size(); ++i) {
    const bool isPoint =
        given[i].is_array() && given[i].size() == 3 && std::ranges::all_of(given[i], [](const nlohmann::json& x) {
          return x.is_number() && std::abs(x.get<double>()) <= kMaxFeedMetres;
        });
    if (!isPoint) {
      fields.fail(name, "must be an array of 4 points, each of 3 numbers in [-100000, 100000]");
    }
    const auto p = given[i].get<std::vector<double>>();
    corners[i] = {p[0], p[1], p[2]};
  }
  return corners;
}

nlohmann::ordered_json jsonOfPoint(const glm::dvec3& point) {
  return nlohmann::ordered_json::array({point.x, point.y, point.z});
}

nlohmann::ordered_json jsonOfCorners(const std::array<glm::dvec3, 4>& corners) {
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (const glm::dvec3& corner : corners) {
    json.push_back(jsonOfPoint(corner));
  }
  return json;
}

}  // namespace ocelli
