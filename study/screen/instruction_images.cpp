#include "study/screen/instruction_images.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "oc_core/gl/gl_api.h"
#include "oc_core/window/screen_target.h"
#include "study/screen/example_picture.h"
#include "study/screen/study_pieces.h"
#include "study/screen/trial_overlay.h"
#include "study/task/trial_image.h"
#include "study/tasks/task_registry.h"

namespace ocelli {
namespace {

/// Where the view shows each object: the middle of its pixels.
std::vector<glm::dvec2> marksOf(const StudyScene& scene, const TrialLayout& layout) {
  const FragmentImage seen = rasterizeStudy(layout.views.front().camera, scene.mesh());
  std::vector<glm::dvec3> sums(scene.objectCount() + 1, glm::dvec3(0));
  for (int y = 0; y < seen.height(); ++y) {
    for (int x = 0; x < seen.width(); ++x) {
      if (seen(x, y).covered()) {
        sums[scene.objectOfTriangle()[seen(x, y).triangle]] += glm::dvec3(x + 0.5, y + 0.5, 1);
      }
    }
  }
  std::vector<glm::dvec2> marks;
  for (size_t i = 1; i < sums.size(); ++i) {
    if (sums[i].z > 0) {
      marks.emplace_back(glm::dvec2(sums[i]) / sums[i].z);
    }
  }
  return marks;
}

void moveBy(TrialLayout& layout, const glm::dvec2& offset) {
  const auto move = [&](PixelRect& place) {
    place.left += offset.x;
    place.top += offset.y;
  };
  for (TrialLayout::Choice& choice : layout.choices) {
    move(choice.place);
  }
  for (TrialLayout::PathMap& map : layout.maps) {
    move(map.place);
  }
}

void ringAround(StudyCanvas& canvas, const glm::dvec2& center, double radius) {
  canvas.ring(center, radius, kStudyInk, canvas.length(7));
  canvas.ring(center, radius, {255, 255, 255}, canvas.length(3));
}

struct KeyRow {
  std::vector<std::string> keys;
  std::string meaning;
};

std::vector<KeyRow> rowsOf(const Controls& controls, const SubjectTexts& texts) {
  const auto name = [](Key key) { return std::string(nameOf(key)); };
  return {{{name(controls.forward), "Up"}, texts.say("walk_forward")},
          {{name(controls.backward), "Down"}, texts.say("walk_backward")},
          {{name(controls.left), name(controls.right)}, texts.say("step_aside")},
          {{name(controls.turnLeft), name(controls.turnRight), "Left", "Right"}, texts.say("turn")},
          {{"right mouse button"}, texts.say("turn_by_mouse")},
          {{"Shift", "arrows"}, texts.say("move_pointer")},
          {{name(controls.select), "left click"}, texts.say("choose")}};
}

void drawControls(StudyCanvas& canvas, const PixelRect& place, const Controls& controls) {
  const std::vector<KeyRow> rows = rowsOf(controls, canvas.texts());
  const double gap = canvas.length(8);
  double column = 0;
  for (const KeyRow& row : rows) {
    double width = 0;
    for (const std::string& key : row.keys) {
      width += keyCapWidth(canvas, key) + gap;
    }
    column = std::max(column, width);
  }
  const double pad = canvas.length(26);
  const double rowHeight = std::min((place.height - 2 * pad) / static_cast<double>(rows.size()), canvas.length(58));
  const double height = rowHeight * static_cast<double>(rows.size()) + 2 * pad;
  const PixelRect card{place.left, place.center().y - height / 2, place.width, height};
  canvas.fill(card, kStudyCard, canvas.length(12));
  double y = card.top + pad + rowHeight / 2;
  for (const KeyRow& row : rows) {
    double x = card.left + pad;
    for (const std::string& key : row.keys) {
      x = drawKeyCap(canvas, x, y, key, kStudyField) + gap;
    }
    canvas.writeLine({StudyText::kBody, kStudyText, kStudyCard},
                     {card.left + pad + column + canvas.length(10), y - canvas.look().textPixels(StudyText::kBody) / 2},
                     row.meaning);
    y += rowHeight;
  }
}

}  // namespace

const InstructionImages::Example& InstructionImages::exampleOf(const std::shared_ptr<const PageExample>& example,
                                                               const PixelRect& place) {
  Example& known = examples_[example];
  if (known.place == place) {
    return known;
  }
  const ExamplePicture picture = examplePicture(*context_, *example, screen_);
  const double scale = std::min({1.0, place.width / picture.pixels.width(), place.height / picture.pixels.height()});
  const auto scaled = [&](int length) { return std::max(1, static_cast<int>(scale * length)); };
  const Image<Rgb8> small = shrunk(picture.pixels, scaled(picture.pixels.width()), scaled(picture.pixels.height()));
  Image<std::array<uint8_t, 4>> texels(small.width(), small.height());
  std::transform(small.begin(), small.end(), texels.begin(), [](const Rgb8& pixel) {
    return std::array<uint8_t, 4>{pixel.x, pixel.y, pixel.z, 255};
  });
  known = {place, makeTexture(*context_, GL_RGBA8, small.width(), small.height()), {}, {}};
  context_->gl().TextureSubImage2D(known.texture.id(), 0, 0, 0, small.width(), small.height(), GL_RGBA,
                                   GL_UNSIGNED_BYTE, texels.data());
  known.image = {std::round(place.center().x - small.width() / 2.0),
                 std::round(place.center().y - small.height() / 2.0), static_cast<double>(small.width()),
                 static_cast<double>(small.height())};
  for (const ExamplePicture::Mark& mark : picture.marks) {
    known.marks.push_back({scale * mark.center, scale * mark.radius});
  }
  return known;
}

void InstructionImages::drawExample(StudyCanvas& canvas, const std::shared_ptr<const PageExample>& example,
                                    const PixelRect& place) {
  const Example& of = exampleOf(example, place);
  canvas.image(of.texture, of.image);
  canvas.outline(of.image, kStudyLine, canvas.length(1.5));
  for (const auto& [center, radius] : of.marks) {
    ringAround(canvas, glm::dvec2(of.image.left, of.image.top) + center, radius + canvas.length(9));
  }
}

const InstructionImages::View& InstructionImages::viewOf(const InstructionImage& image, int width, int height) {
  const std::string key = fmt::format("{} {}x{}", image.name, width, height);
  if (const auto found = views_.find(key); found != views_.end()) {
    return found->second;
  }
  const InstructionExample example = image.make({width, height});
  View view;
  ScreenTarget target(*context_, width, height);
  target.clear(kStudyBackground);
  SceneViews(*context_).draw(example.layout, target.color());
  view.texture = makeTexture(*context_, GL_RGBA8, width, height);
  context_->gl().CopyImageSubData(target.color().id(), GL_TEXTURE_2D, 0, 0, 0, 0, view.texture.id(), GL_TEXTURE_2D, 0,
                                  0, 0, 0, width, height, 1);
  if (image.marksObjects) {
    view.marks = marksOf(*example.scene, example.layout);
  }
  return views_.emplace(key, std::move(view)).first->second;
}

void InstructionImages::draw(StudyCanvas& canvas, const PageScreen& page, const PixelRect& place) {
  if (page.example) {
    drawExample(canvas, page.example, place);
    return;
  }
  const std::string& name = page.image;
  if (name == kControlsImage) {
    drawControls(canvas, place, controls_);
    return;
  }
  drawTaskImage(canvas, name, canvas.onScreen(place));
}

void InstructionImages::drawTaskImage(StudyCanvas& canvas, const std::string& name, const PixelRect& place) {
  const MirrorScope unmirrored(canvas, false);
  const InstructionImage* image = instructionImage(name);
  if (image == nullptr) {
    return;
  }
  const glm::ivec2 size(place.width, place.height);
  if (InstructionExample example = image->make(size); example.layout.views.empty()) {
    moveBy(example.layout, {place.left, place.top});
    for (TrialLayout::Choice& choice : example.layout.choices) {
      choice.label = canvas.texts().translated(choice.label);
    }
    drawChoicesAndMaps(canvas, example.layout);
    return;
  }
  const View& view = viewOf(*image, size.x, size.y);
  canvas.image(view.texture, place);
  canvas.outline(place, kStudyLine, canvas.length(1.5));
  for (size_t i = 0; i < view.marks.size(); ++i) {
    const glm::dvec2 center = glm::dvec2(place.left, place.top) + view.marks[i];
    ringAround(canvas, center, canvas.length(view.marks.size() == 1 ? 44 : 30));
  }
}

}  // namespace ocelli
