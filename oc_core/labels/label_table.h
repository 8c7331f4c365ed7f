// Labels of a scene, as people write them: a table in CSV.
#pragma once

#include <filesystem>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <vector>

namespace ocelli {

struct SceneLabel {
  glm::vec3 position{0};            ///< of the middle of the text, in the scene before it is fitted
  std::string text;                 ///< clean (utf8.h), of one line or several
  std::optional<double> size{};     ///< height of a capital letter; nothing: as high as others of no size
  glm::vec3 color{1};               ///< linear
  std::optional<glm::vec3> facing;  ///< where one stands who reads it; nothing: as others without a direction
};

/// The most characters of one label.
inline constexpr size_t kMaxLabelCharacters = 1000;

/// Reads a table whose first row names its columns, in any order and case: `x`, `y`, `z`, `text`, and perhaps `size`
/// (positive), `color` or `colour` (#rrggbb, sRGB), and `nx`, `ny`, `nz` (not all 0). Others are left out. A field of
/// the optional ones may be empty. Throws InputError with the line for what is missing or wrong.
std::vector<SceneLabel> readLabels(const std::filesystem::path& path);

}  // namespace ocelli
