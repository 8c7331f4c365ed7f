// Writes the seed corpus of the message fuzzer anew: message_corpus tests/remote/message_corpus
#include <filesystem>
#include <string>

#include "oc_core/base/file_bytes.h"
#include "oc_core/remote/remote_message.h"
#include "oc_core/remote/remote_scene.h"
#include "oc_core/worlds/scene_source.h"

namespace {

using namespace ocelli;

std::string textOf(const std::vector<std::byte>& bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

}  // namespace

int main(int argumentCount, char** arguments) {
  if (argumentCount != 2) {
    return 2;
  }
  const std::filesystem::path folder = arguments[1];
  const RemoteScene scene(loadScene("builtin:boxes"), "builtin:boxes");
  RemoteRequest request{.sequence = 7, .view = {}, .screen = {16, 16}};
  RemoteSettings settings;
  settings.color = "png";
  const RemoteImage image = scene.answer(request, settings, 3);
  request.lenses = {GpcRegion{{0.3f, 0.4f}, {0.2f, 0.3f}, 3, 0.5f}, GpcRegion{{0.35f, 0.4f}, {0.2f, 0.3f}, 5, 1}};
  writeFile(folder / "look", jsonText(request));
  writeFile(folder / "hello",
            jsonText(RemoteHello{.scene = scene.name(), .view = {}, .box = scene.bounds(), .settings = settings}));
  writeFile(folder / "queued", jsonText(RemoteQueued{7, 2}));
  writeFile(folder / "drawing", jsonText(RemoteDrawing{7}));
  writeFile(folder / "error", jsonText(RemoteFailure{"there is nothing to see", 7u}));
  writeFile(folder / "header", image.headerJson);
  writeFile(folder / "piece", textOf(messageOf(piecesOf(image).front())));
  writeFile(folder / "image", image.headerJson + "\n" + textOf(image.color) + textOf(image.depth));
}
