// Runs the texts of shaders as C++: run_shaders.cpp has the types and functions of the Open Shading Language that they
// use, in single precision as in that language.
#pragma once

#include <filesystem>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

namespace ocelli::test {

struct ShaderRay {
  glm::vec3 position{0};
  glm::vec3 direction{0};
  glm::vec3 throughput{0};
};

/// How textures are read: as the shader asks for, or by renderers that filter all the same.
enum class Filtering { kClosest, kLinear };

/// At a place in the image: from (0, 0) at the bottom left to (1, 1) at the top right. One thread at a time.
ShaderRay runShader(const std::string& name, const glm::vec2& raster, Filtering filtering = Filtering::kClosest);

std::vector<std::string> shaderNames();

}  // namespace ocelli::test
