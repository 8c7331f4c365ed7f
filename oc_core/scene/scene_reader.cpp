#include "oc_core/scene/scene_reader.h"

namespace ocelli {

const ReaderProgram& sceneReader() {
  static constexpr ReaderProgram kReader{
      .program = {.name = "ocelli-read-scene",
                  .installed = OCELLI_SCENE_READER_INSTALLED,
                  .variable = "OCELLI_SCENE_READER",
                  .does = "reads scene files other than PLY",
                  .ifMissing =
                      "install Ocelli whole, or let the environment variable OCELLI_SCENE_READER name the program"},
      .library = "Assimp",
      .memoryVariable = "OCELLI_SCENE_MEMORY_GIB",
      .secondsVariable = "OCELLI_SCENE_SECONDS",
      .convert = "convert it to binary PLY",
      .afterCrash = "the file may be damaged: export it again, if need be in another format such as glTF or PLY",
      .reduce = "reduce the mesh"};
  return kReader;
}

SceneRecord readInOtherProcess(const std::filesystem::path& path, bool withTextures, const Progress& progress) {
  std::error_code ignored;
  const uintmax_t bytes = std::filesystem::file_size(path, ignored);
  const ReaderResult result = runReaderProgram(sceneReader(), {withTextures ? "textures" : "plain", path.string()},
                                               path, bytes, [&] { report(progress, "loading the scene", 0); });
  return sceneFromRecord(result.record.bytes(), result.program);
}

}  // namespace ocelli
