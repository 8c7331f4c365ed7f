// Reading the small values that several commands take: "720x480", "0,0.2,9.8", "1/25".
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <optional>
#include <string>

namespace ocelli {

struct ImageSize {
  int width = 0;
  int height = 0;
};

/// Each of these throws InputError, naming `option`, for anything but (the whole text being) such a value.
/// "WIDTHxHEIGHT", each in [1, 32768], of at most 2^26 pixels.
ImageSize imageSizeFromText(const std::string& text, const std::string& option);
/// "X,Y,Z", finite.
glm::vec3 pointFromText(const std::string& text, const std::string& option);
/// "8in" or "0.2m": a length at the reference display, in its radii; positive.
float cellSideFromText(const std::string& text, const std::string& option);
/// Of a frame, counted from 0.
size_t frameNumber(int64_t number, const std::string& option);
/// "1/25" or "0.04"; finite.
double ratioFromText(const std::string& text, const std::string& option);

/// "LEAST:GREATEST", finite, in this order.
glm::dvec2 rangeFromText(const std::string& text, const std::string& option);

/// "NX,NY,NZ,D", or "x>D" and "x<D" with any of the axes: (n, d), with n of length 1, of the half space where
/// dot(n, p) >= d.
glm::dvec4 halfSpaceFromText(const std::string& text, const std::string& option);
/// A number of triangles, or "full".
size_t textureTrianglesFromText(const std::string& text, const std::string& option);

/// "X,Y,Z", three numbers that are not all 0.
glm::vec3 directionFromText(const std::string& text, const std::string& option);

/// "#rrggbb", as sRGB: linear RGB.
glm::vec3 colorFromText(const std::string& text, const std::string& option);
/// "auto", which is nothing, or a width above 0.
std::optional<double> pointWidthFromText(const std::string& text, const std::string& option);

}  // namespace ocelli
