// throwaway
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iostream>

#include "oc_core/remote/page/remote_page.h"
#include "oc_core/remote/remote_message.h"
#include "oc_core/remote/remote_scene.h"
#include "oc_core/worlds/scene_source.h"
using namespace ocelli;
static void put(char kind, const std::string& s) {
  const auto n = static_cast<uint32_t>(s.size());
  std::fwrite(&kind, 1, 1, stdout);
  std::fwrite(&n, 4, 1, stdout);
  std::fwrite(s.data(), 1, s.size(), stdout);
}
int main(int argc, char** argv) {
  if (argc > 2) {
    for (const auto& f : remotePageFiles()) {
      std::ofstream(std::string(argv[2]) + (f.path == "/" ? "/index.html" : f.path)) << f.bytes;
    }
  }
  const std::string source = argv[1];
  View view;
  view.eye = {0, 1.2f, 5};
  view.fovVerticalDegrees = 24;
  const RemoteScene scene(loadScene(source), source, view);
  RemoteSettings settings;
  if (argc > 3)
    settings = remoteSettingsFromJson(argv[3], "arg");
  RemoteHello hello;
  hello.scene = source;
  hello.view = view;
  hello.box = scene.bounds();
  hello.settings = settings;
  put('t', jsonText(hello));
  std::fflush(stdout);
  uint32_t id = 0;
  for (std::string line; std::getline(std::cin, line);) {
    try {
      const RemoteImage image = scene.answer(remoteRequestFromJson(line), settings, ++id);
      put('t', image.headerJson);
      for (const auto& piece : piecesOf(image)) {
        const auto m = messageOf(piece);
        put('b', std::string(reinterpret_cast<const char*>(m.data()), m.size()));
      }
    } catch (const std::exception& e) {
      RemoteFailure f{.message = e.what()};
      put('t', jsonText(f));
    }
    put('e', "");
    std::fflush(stdout);
  }
}
