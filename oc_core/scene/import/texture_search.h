// Where the image files lie that a scene file names, on a machine that the file was not made on.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace ocelli {

/// The first regular file of: the name as it stands, from the folder of the scene; the same with `\` as `/`, %XX
/// decoded, without Blender's `//` in front, and in any case; its bare file name, in any case, beside the scene, in a
/// folder `textures` beside it, and in one beside the scene's folder. Of several that differ in case alone, the first
/// by its bytes. Bytes need not be UTF-8.
std::optional<std::filesystem::path> findTextureFile(const std::filesystem::path& sceneFile, const std::string& name);

}  // namespace ocelli
