// Small scene files of many formats, made here, and files that lie about themselves: for tests, and as seeds of fuzz/.
#pragma once

#include <string>
#include <vector>

namespace ocelli::test {

struct SceneFileSample {
  std::string name;  ///< with the extension of its format
  std::string bytes;
};

/// A triangle in formats that Assimp reads and does not write. Each is sound, or ends after a sound header.
std::vector<SceneFileSample> smallSceneFiles();

/// Headers that promise far more than there is, that end early, or whose offsets lead out of the file.
std::vector<SceneFileSample> hostileSceneFiles();

}  // namespace ocelli::test
