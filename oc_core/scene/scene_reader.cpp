#include "oc_core/scene/scene_reader.h"

namespace ocelli {

const ReaderProgram& sceneReader() {
  static constexpr ReaderProgram kReader{
      .name = "ocelli-read-scene",
      .files = "scene files",
      .library = "Assimp",
      .installed = OCELLI_SCENE_READER_INSTALLED,
      .programVariable = "OCELLI_SCENE_READER",
      .memoryVariable = "OCELLI_SCENE_MEMORY_GIB",
      .secondsVariable = "OCELLI_SCENE_SECONDS",
      .convert = "convert it to binary PLY",
      .afterCrash = "the file may be damaged: export it again, if need be in another format such as glTF or PLY",
      .reduce = "reduce the mesh",
      .missing = "the program ocelli-read-scene is missing, which reads scene files other than PLY",
      .ifMissing = "install Ocelli whole, or let the environment variable OCELLI_SCENE_READER name the program"};
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
