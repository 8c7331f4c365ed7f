#include "cli/study_drawer.h"

#include <CLI/CLI.hpp>
#include <memory>

#include "cli/gl_drawing.h"

namespace ocelli {

void addRendererOption(CLI::App& command, std::string& renderer) {
  command.add_option("--renderer", renderer, "What draws: the rasteriser on the processor, or OpenGL through EGL or OSMesa")
      ->check(CLI::IsMember({"raster", "egl", "osmesa"}))
      ->type_name("NAME")
      ->capture_default_str();
}

StudyDrawer studyDrawer(const std::string& renderer) {
  if (renderer == "raster") {
    return rasterizeStudy;
  }
  const auto drawing = std::make_shared<GlDrawing>(renderer);
  return [drawing](const StudyCamera& camera, const Mesh& mesh) {
    const SceneDrawer& drawer = drawing->drawerOf(mesh);
    return std::visit([&](const auto& each) { return drawer.draw(each); }, camera);
  };
}

}  // namespace ocelli
