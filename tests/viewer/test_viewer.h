// A viewer of a small scene without a display, and what of its window a test looks at.
#pragma once

#include <functional>

#include "display_sim/viewer/script_player.h"
#include "display_sim/viewer/viewer_colors.h"
#include "tests/base/temporary_folder.h"
#include "tests/gl/gl_test_context.h"

namespace ocelli::test {

class TestViewer {
 public:
  static constexpr int kWidth = 960;
  static constexpr int kHeight = 640;

  explicit TestViewer(GlProvider provider, const std::string& source = "builtin:room",
                      const std::string& camera = "ddoc", const SceneOptions& sceneOptions = {})
      : context(openTestContext(provider)),
        viewer(*context, options(source, camera, sceneOptions, folder.path())),
        player(viewer, folder.path()) {
    player.play(ResizeStep{kWidth, kHeight, 1});
    player.play(WaitStep{});
  }

  void key(Key key, Modifiers modifiers = {}) { player.play(KeyStep{key, modifiers}); }
  void settle() { player.play(WaitStep{}); }

  PaneLayout layoutOf(Pane pane) const { return *viewerLayout(viewer.state(), {kWidth, kHeight}, 1).find(pane); }
  /// What a pane shows, with the texts over it.
  Image<Rgb8> paneImage(Pane pane) const {
    const WindowRect rect = layoutOf(pane).image;
    const Image<Rgb8> window = viewer.screenshot();
    Image<Rgb8> image(static_cast<int>(rect.width), static_cast<int>(rect.height));
    for (int y = 0; y < image.height(); ++y) {
      for (int x = 0; x < image.width(); ++x) {
        image(x, y) = window(x + static_cast<int>(rect.x), y + static_cast<int>(rect.y));
      }
    }
    return image;
  }
  /// The window's coordinates of a place of a pane.
  glm::dvec2 at(Pane pane, double x, double y) const {
    const WindowRect rect = layoutOf(pane).image;
    return {rect.x + x, rect.y + y};
  }

  TemporaryFolder folder;
  std::unique_ptr<GlContext> context;
  Viewer viewer;
  ScriptPlayer player;

 private:
  static ViewerOptions options(const std::string& source, const std::string& camera, const SceneOptions& sceneOptions,
                               const std::filesystem::path& folder) {
    ViewerOptions options;
    options.source = source;
    options.sceneOptions = sceneOptions;
    options.camera = cameraChoice(camera);
    options.width = 180;
    options.height = 120;
    options.profile = "test";
    options.folder = folder;
    options.showTimes = false;
    options.environmentHeight = 64;
    return options;
  }
};

inline bool isNear(const Rgb8& a, const Rgb8& b, int tolerance) {
  const glm::ivec3 step = glm::abs(glm::ivec3(a) - glm::ivec3(b));
  return std::max({step.x, step.y, step.z}) <= tolerance;
}
inline Rgb8 bytesOf(GuiColor color) {
  return {color.red, color.green, color.blue};
}
inline size_t countNear(const Image<Rgb8>& image, const Rgb8& color, int tolerance) {
  return static_cast<size_t>(
      std::count_if(image.begin(), image.end(), [&](const Rgb8& pixel) { return isNear(pixel, color, tolerance); }));
}
inline size_t countDifferent(const Image<Rgb8>& a, const Image<Rgb8>& b) {
  size_t different = a.size() != b.size() ? a.size() : 0;
  for (size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
    different += a[i] != b[i];
  }
  return different;
}

}  // namespace ocelli::test
