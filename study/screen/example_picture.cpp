#include "study/screen/example_picture.h"

#include <algorithm>
#include <cmath>

#include "oc_core/base/check.h"
#include "oc_core/image/color.h"
#include "oc_core/render/identity_image.h"
#include "oc_core/window/screen_target.h"
#include "study/protocol/coverage.h"
#include "study/screen/study_look.h"
#include "study/task/trial_image.h"

namespace ocelli {
namespace {

PixelRect around(const std::vector<TrialLayout::View>& views) {
  PixelRect box = views.front().place;
  for (const TrialLayout::View& view : views) {
    const double right = std::max(box.right(), view.place.right());
    const double bottom = std::max(box.bottom(), view.place.bottom());
    box.left = std::min(box.left, view.place.left);
    box.top = std::min(box.top, view.place.top);
    box.width = right - box.left;
    box.height = bottom - box.top;
  }
  return box;
}

std::vector<ExamplePicture::Mark> marksOf(const TrialLayout& layout, const PixelRect& box, size_t minPixels) {
  std::vector<ExamplePicture::Mark> marks;
  for (const TrialLayout::View& view : layout.views) {
    const glm::dvec2 from(view.place.left - box.left, view.place.top - box.top);
    for (const ObjectSighting& each : sightings(objectsIn(layout, view))) {
      if (each.pixels >= minPixels) {
        const glm::ivec2 size = each.upper - each.lower + 1;
        marks.push_back({from + each.centroid, std::max(size.x, size.y) / 2.0});
      }
    }
  }
  return marks;
}

}  // namespace

ExamplePicture examplePicture(GlContext& context, const PageExample& example, const TrialScreen& screen) {
  const std::unique_ptr<TrialRun> run = example.task->start(example.plan, screen);
  const TrialLayout layout = run->layout();
  OC_CHECK(!layout.views.empty(), "a trial begins with views of its scene");
  ScreenTarget target(context, screen.width, screen.height);
  target.clear(kStudyBackground);
  SceneViews(context).draw(layout, target.color());
  const Image<Rgb8> all = target.read();
  const PixelRect box = around(layout.views);
  const auto left = static_cast<int>(std::lround(box.left));
  const auto top = static_cast<int>(std::lround(box.top));
  ExamplePicture picture{{static_cast<int>(std::lround(box.width)), static_cast<int>(std::lround(box.height))},
                         marksOf(layout, box, minSeenPixels(screen))};
  for (int y = 0; y < picture.pixels.height(); ++y) {
    for (int x = 0; x < picture.pixels.width(); ++x) {
      picture.pixels(x, y) = all(left + x, top + y);
    }
  }
  return picture;
}

Image<Rgb8> shrunk(const Image<Rgb8>& image, int width, int height) {
  OC_CHECK(width >= 1 && width <= image.width() && height >= 1 && height <= image.height(), "images only shrink");
  Image<Rgb8> small(width, height);
  for (int y = 0; y < height; ++y) {
    const int top = y * image.height() / height;
    const int bottom = (y + 1) * image.height() / height;
    for (int x = 0; x < width; ++x) {
      const int left = x * image.width() / width;
      const int right = (x + 1) * image.width() / width;
      glm::vec3 light(0);
      for (int v = top; v < bottom; ++v) {
        for (int u = left; u < right; ++u) {
          const Rgb8& pixel = image(u, v);
          light += glm::vec3(linearFromSrgbByte(pixel.x), linearFromSrgbByte(pixel.y), linearFromSrgbByte(pixel.z));
        }
      }
      light /= static_cast<float>((bottom - top) * (right - left));
      small(x, y) = {srgbByteFromLinear(light.x), srgbByteFromLinear(light.y), srgbByteFromLinear(light.z)};
    }
  }
  return small;
}

}  // namespace ocelli
