// Cameras that are written as shaders, and the rays that they should have. write_shaders.cpp writes them when the tests
// are built, and the tests run what it wrote.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "oc_core/camera/ray_map.h"
#include "oc_core/camera/view.h"

namespace ocelli::test {

struct ShaderCase {
  std::string name;
  std::string text;
  std::string texture;  ///< bytes of the file that the shader reads; empty where it reads none
  RayMap rays;          ///< of the camera itself
  /// Those of a closed form anywhere in the image; empty for others.
  std::function<RayPath(const glm::vec2& pixel)> rayAt;
};

/// `folder` is where textures lie.
std::vector<ShaderCase> shaderCases(const std::filesystem::path& folder);
std::filesystem::path texturePath(const std::filesystem::path& folder, const std::string& name);

/// A view that looks down at nothing in particular, with a shifted image.
View obliqueView();

}  // namespace ocelli::test
