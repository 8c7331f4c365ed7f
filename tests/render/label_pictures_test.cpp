// Labels, as a camera sees them, beside the same text as Cairo draws it.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <glm/ext/matrix_transform.hpp>

#include "oc_core/drawing/figure.h"
#include "oc_core/drawing/text_outline.h"
#include "tests/base/temporary_folder.h"
#include "tests/render/file_pictures.h"

namespace ocelli {
namespace {

using test::covered;
using test::Picture;
using test::pictureOf;
using test::pictureOfFile;
using test::TemporaryFolder;

constexpr int kLabelSide = 480;

double pixelsOfUnitHere() {
  const PinholeCamera camera(View{}, kLabelSide, kLabelSide);
  return static_cast<double>(camera.project(glm::vec3(1, 0, 0))->u - camera.project(glm::vec3(0))->u);
}

/// Black on white; `size` is the height of a capital letter in pixels, the middle of the text that of the image.
Pixels drawnByCairo(const std::string& text, double size) {
  const double fontSize = size / capitalHeight(Face::kSansBold);
  Figure figure{.title = text, .description = text, .width = kLabelSide, .height = kLabelSide, .drawing = {}};
  figure.drawing.text("text",
                      {kLabelSide / 2.0 - textWidth(text, Face::kSansBold, fontSize) / 2, kLabelSide / 2.0 + size / 2},
                      text, {.size = fontSize, .face = Face::kSansBold, .paint = Paint{}});
  return pixelsOf(figure);
}

// Far from all else there is: a small box that lies behind the label gives the scene its extent.
TEST(LabelPictures, AreTheLettersThatCairoDraws) {
  const TemporaryFolder folder;
  for (const auto& [text, size] :
       {std::pair<std::string, double>{"Nose 12 \u00b5m", 0.25}, {"Gr\u00f6\u00dfe & Qb", 0.2}}) {
    SceneOptions options{.fit = false, .shading = Shading::kLambert};
    options.labels.file =
        folder.write("labels.csv", fmt::format("x,y,z,text,size\n0,0,0,{},{}\n", text, size)).string();
    const auto path = folder.write("a.obj", "v 0 0 -1\nv 0.001 0 -1\nv 0 0.001 -1\nf 1 2 3\n");
    const Picture seen = pictureOfFile(path, options, fmt::format("label_{}", size), kLabelSide);
    const Pixels drawn = drawnByCairo(text, size * pixelsOfUnitHere());
    size_t ink = 0;
    size_t wrong = 0;
    for (int y = 0; y < kLabelSide; ++y) {
      for (int x = 0; x < kLabelSide; ++x) {
        const uint32_t grey = drawn.values[static_cast<size_t>(y) * kLabelSide + static_cast<size_t>(x)] & 255U;
        const bool isInk = seen(x, y) != glm::vec3(0);
        ink += grey < 128 ? 1 : 0;
        // What Cairo covers by a quarter to three quarters may be on either side of a straightened curve.
        wrong += (grey < 64 && !isInk) || (grey > 191 && isInk) ? 1 : 0;
      }
    }
    EXPECT_GT(ink, 500u);
    EXPECT_LE(wrong, ink / 100) << text;
  }
}

// Three labels on the sides of a box, each seen from its side.
TEST(LabelPictures, AreSeenFromWhereTheyFace) {
  const TemporaryFolder folder;
  SceneOptions options{.fit = false};
  options.labels.file = folder
                            .write("labels.csv",
                                   "x,y,z,text,size,color,nx,ny,nz\n0,0,0.505,front,0.2,#ff0000,0,0,1\n"
                                   "0.505,0,0,right,0.2,#00ff00,1,0,0\n0,0.505,0,top,0.2,#4080ff,0,1,0\n")
                            .string();
  const auto path = folder.write(
      "cube.obj",
      "v -0.5 -0.5 -0.5\nv 0.5 -0.5 -0.5\nv -0.5 0.5 -0.5\nv 0.5 0.5 -0.5\nv -0.5 -0.5 0.5\nv 0.5 -0.5 0.5\n"
      "v -0.5 0.5 0.5\nv 0.5 0.5 0.5\n"
      "f 5 6 8 7\nf 2 1 3 4\nf 6 2 4 8\nf 1 5 7 3\nf 7 8 4 3\nf 1 2 6 5\n");
  const Mesh mesh = loadScene(path.string(), options);
  const auto inkOf = [&](const Picture& picture, glm::length_t channel) {
    size_t count = 0;
    for (const glm::vec3& color : picture) {
      const glm::vec3 others = color - glm::vec3(color[channel]);
      count += color[channel] == 1.0f && (others[0] < -0.5f || others[1] < -0.5f || others[2] < -0.5f) ? 1 : 0;
    }
    return count;
  };
  const auto seenAfter = [&](const glm::mat4& turn, const std::string& name) {
    Mesh turned = mesh;
    transform(turned, turn);
    return pictureOf(turned, name, kLabelSide);
  };
  const glm::mat4 still(1);
  EXPECT_GT(inkOf(seenAfter(still, "labels_front"), 0), 300u);
  EXPECT_EQ(inkOf(seenAfter(still, "labels_front"), 1), 0u) << "the front hides the right side";
  const glm::mat4 left = glm::rotate(still, -1.5707963f, glm::vec3(0, 1, 0));
  EXPECT_GT(inkOf(seenAfter(left, "labels_right"), 1), 300u);
  const glm::mat4 oblique = glm::rotate(glm::rotate(still, 0.6f, glm::vec3(1, 0, 0)), -0.6f, glm::vec3(0, 1, 0));
  const Picture all = seenAfter(oblique, "labels_oblique");
  for (const glm::length_t channel : {0, 1, 2}) {
    EXPECT_GT(inkOf(all, channel), 100u) << channel;
  }
}

}  // namespace
}  // namespace ocelli
