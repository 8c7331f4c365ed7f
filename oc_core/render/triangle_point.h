// The point of a triangle that is closest to another point.
#pragma once

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace ocelli {

/// Of the triangle's plane where that point lies inside, else of an edge.
inline glm::vec3 closestPoint(const glm::vec3& p, const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
  const glm::vec3 normal = glm::cross(b - a, c - a);
  const auto leftOf = [&](const glm::vec3& from, const glm::vec3& to) {
    return glm::dot(glm::cross(to - from, p - from), normal) >= 0;
  };
  const float normal2 = glm::dot(normal, normal);
  if (normal2 > 0 && leftOf(a, b) && leftOf(b, c) && leftOf(c, a)) {
    return p - normal * (glm::dot(p - a, normal) / normal2);
  }
  const auto onEdge = [&](const glm::vec3& from, const glm::vec3& to) {
    const glm::vec3 along = to - from;
    const float length2 = glm::dot(along, along);
    return from + along * (length2 > 0 ? glm::clamp(glm::dot(p - from, along) / length2, 0.0f, 1.0f) : 0.0f);
  };
  const auto nearer = [&](const glm::vec3& q, const glm::vec3& r) {
    return glm::dot(q - p, q - p) <= glm::dot(r - p, r - p) ? q : r;
  };
  return nearer(nearer(onEdge(a, b), onEdge(b, c)), onEdge(c, a));
}

}  // namespace ocelli
