// Small scenes, and how far images are apart, for the tests of antialiasing.
#pragma once

#include <glm/vec3.hpp>

#include "oc_core/antialiasing/antialias_image.h"

namespace ocelli::test {

inline constexpr glm::vec3 kNight{0.1f, 0.2f, 0.4f};  ///< the background of these tests

/// A camera whose pixel (u, v) sees (u, height - v, 0) of the plane z = 0.
PinholeCamera flatCamera(int width, int height);

/// Adds a triangle of one colour between points of that plane, at a height above it.
void addFlat(Mesh& mesh, const glm::vec2& a, const glm::vec2& b, const glm::vec2& c, const glm::vec3& color,
             const PinholeCamera& camera, float above = 0);

/// So many small triangles in the unit cube, each of one colour, the same every time.
Mesh triangleCloud(size_t count, float size);

/// Those of a plan with one rule.
AntialiasPlan everywhere(const PixelRule& rule);
PixelRule squareRule(int side, const char* placement, size_t maxExactTriangles = 0);
PixelRule multisampleRule(int samples);

/// Root of the mean squared difference of linear colours.
double rmse(const Image<glm::vec3>& a, const Image<glm::vec3>& b);
/// The greatest difference of a channel.
double greatestDifference(const Image<glm::vec3>& a, const Image<glm::vec3>& b);

}  // namespace ocelli::test
