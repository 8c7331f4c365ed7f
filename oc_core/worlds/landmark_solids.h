// The objects that stand in a maze: a few shapes and colours that are easy to tell apart.
#pragma once

#include <array>

#include "oc_core/scene/maze.h"

namespace ocelli {

inline constexpr std::array<LandmarkShape, 7> kLandmarkShapes{
    LandmarkShape::kCone,    LandmarkShape::kCube, LandmarkShape::kSphere, LandmarkShape::kColumn,
    LandmarkShape::kPyramid, LandmarkShape::kRing, LandmarkShape::kArch};
inline constexpr std::array<LandmarkColor, 8> kLandmarkColors{
    LandmarkColor::kOrange, LandmarkColor::kSkyBlue,   LandmarkColor::kGreen,  LandmarkColor::kYellow,
    LandmarkColor::kBlue,   LandmarkColor::kVermilion, LandmarkColor::kPurple, LandmarkColor::kIvory};

const char* nameOf(LandmarkShape shape);
const char* nameOf(LandmarkColor color);
glm::vec3 colorOf(LandmarkColor color);

/// The closed solid of a landmark where it stands in its maze, without colours.
Mesh makeLandmark(const Maze& maze, const Landmark& landmark);

}  // namespace ocelli
