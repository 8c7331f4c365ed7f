// What one moment of a trial looks like: which cameras show the scene, and where on the screen. Whoever draws it, sees
// it (a simulated subject) or replays it takes it from here; nothing in it depends on how it is drawn.
#pragma once

#include <algorithm>
#include <array>
#include <functional>
#include <glm/vec2.hpp>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "oc_core/base/input_event.h"
#include "oc_core/base/progress.h"
#include "oc_core/camera/graph_camera.h"
#include "oc_core/camera/pinhole_camera.h"
#include "oc_core/image/image.h"
#include "oc_core/image/png_file.h"
#include "study/task/pixel_rect.h"
#include "study/task/study_scene.h"

namespace ocelli {

using StudyCamera = std::variant<PinholeCamera, GraphCamera>;

/// The screen that a trial is drawn for. Tasks lay everything out in its pixels.
struct TrialScreen {
  int width = 1920;
  int height = 1200;
  double refreshHertz = 60;  ///< frames a second: exposures are counted in them

  bool operator==(const TrialScreen&) const = default;
};

/// Pixels at the top of the screen that the prompt takes; views, maps and choices lie below them.
constexpr int promptHeight(const TrialScreen& screen) {
  return std::max(48, screen.height * 3 / 40);
}

struct TrialLayout;

/// What stands for a scene where a view does not show the scene itself.
struct ShownMesh {
  Mesh mesh;
  std::vector<uint32_t> objectOfTriangle;  ///< as StudyScene::objectOfTriangle()
};
/// An image that is as large as the place of its view, where no camera draws it from a mesh.
struct ShownImage {
  Image<Rgb8> pixels;
  Image<uint32_t> objects;                   ///< as identity_image.h
  Image<glm::vec3> positions;                ///< where the surface is that shows, of pixels with an object; or empty
  std::vector<glm::vec3> placesOfObjects{};  ///< of each object, where there are no positions

  /// Of a pixel with an object.
  glm::vec3 positionAt(const glm::ivec2& pixel) const {
    return positions.size() > 0 ? positions(pixel.x, pixel.y) : placesOfObjects.at(objects(pixel.x, pixel.y) - 1);
  }
};
using ShownContent = std::variant<ShownMesh, ShownImage>;
/// Makes it of the scene and the objects of a layout. Any thread may call it at any time; it may take long, and keep
/// what it made.
using ShowScene = std::function<std::shared_ptr<const ShownContent>(const TrialLayout& layout)>;
/// Makes, and keeps, all that the view shows at any tick of a trial whose scene and objects are those of the layout, so
/// that screens need not wait for it. Throws InputError where it is more than is kept.
using PrepareScene = std::function<void(const TrialLayout& layout, const Progress& progress)>;

struct TrialLayout {
  /// An image, as large as its place.
  struct View {
    View(const PixelRect& at, StudyCamera from, ShowScene shows = {}, PrepareScene prepares = {})
        : place(at), camera(std::move(from)), show(std::move(shows)), prepare(std::move(prepares)) {}

    PixelRect place;
    StudyCamera camera;    ///< where it is looked from
    ShowScene show;        ///< what the camera shows; the scene where it is empty
    PrepareScene prepare;  ///< of views that take longer to make than a frame lasts; else empty
  };
  /// A path drawn as a map: corners in metres, x to the east, y to the south; the first is the start.
  struct PathMap {
    PixelRect place;
    std::vector<glm::dvec2> corners;
  };
  /// An answer to choose, by a click on its place, or by its key.
  struct Choice {
    PixelRect place;
    std::string label;
    Key key = Key::k1;
    bool chosen = false;
  };
  /// A straight scale to answer on with a number.
  struct Scale {
    PixelRect place;  ///< where clicks set the mark: its left border is `least`, its right one `most`
    double least = 0;
    double most = 1;
    double step = 1;               ///< between the numbers beside it
    std::string unit{};            ///< of them, as its symbol: "m"
    std::optional<double> mark{};  ///< what is answered; none at first
  };
  /// A dial to point on: what lies around the subject, seen from above, ahead at the top.
  struct Dial {
    PixelRect place;                  ///< a square around the circle; clicks set the mark
    std::optional<double> degrees{};  ///< what is answered, clockwise from ahead; none at first
  };

  const StudyScene* scene = nullptr;       ///< of the views; lives as long as the trial
  std::vector<glm::vec3> objectOffsets{};  ///< of the objects of `scene`, from where they stand at first
  std::vector<View> views{};
  int64_t tick = 0;  ///< since the trial began, of tasks whose blocks are still: what moves in views by itself asks it
  std::vector<PathMap> maps{};
  std::vector<Choice> choices{};
  std::optional<Scale> scale{};
  std::optional<Dial> dial{};
  std::string prompt{};                 ///< one line in the topmost promptHeight() pixels: what to do
  std::optional<int> targetObject{};    ///< an object of `scene` to show beside the prompt
  std::optional<glm::dvec2> pointer{};  ///< where the pointer is, where it matters
};

}  // namespace ocelli
