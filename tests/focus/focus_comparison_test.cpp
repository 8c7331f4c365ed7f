#include "oc_core/focus/focus_comparison.h"

#include <gmock/gmock.h>

#include "oc_core/base/error.h"
#include "oc_core/camera/gpc_camera.h"
#include "oc_core/focus/focus_page.h"
#include "oc_core/page/html.h"
#include "oc_core/worlds/scene_source.h"
#include "tests/focus/focus_layouts.h"

namespace ocelli {
namespace {

using test::focusWay;
using test::twoFoci;
using testing::HasSubstr;

const Mesh& focusScene() {
  static const Mesh mesh = loadScene("builtin:teapot");
  return mesh;
}
const PinholeCamera& plainCamera() {
  static const PinholeCamera camera(View{}, 160, 90);
  return camera;
}
const FocusComparison& comparison() {
  static const FocusComparison all = compareFocusWays(focusWays(), twoFoci(), plainCamera(), focusScene(), {.runs = 1});
  return all;
}
Image<Rgb8> colors(const FragmentImage& fragments) {
  return srgbFromLinear(colorImage(fragments, focusScene(), glm::vec3(0)));
}
size_t differentPixels(const Image<Rgb8>& a, const Image<Rgb8>& b) {
  size_t different = 0;
  for (size_t i = 0; i < a.size(); ++i) {
    different += a[i] != b[i];
  }
  return different;
}

TEST(FocusComparison, picturesAreThoseOfTheirCameras) {
  const RayScene rays(focusScene());
  for (const FocusResult& result : comparison().results) {
    const std::string name = result.way->name;
    if (name == "plain") {
      EXPECT_EQ(result.picture, colors(raycast(plainCamera(), focusScene(), rays)));
    } else if (name == "gpc") {
      // The same rays, rounded to single precision in another order: they may tell apart what lies at edges.
      const Image<Rgb8> cast = colors(raycast(GpcCamera(plainCamera(), twoFoci()), focusScene(), rays));
      EXPECT_LE(differentPixels(result.picture, cast), cast.size() / 500);
    }
  }
}

TEST(FocusComparison, anInsetDiffersFromThePlainViewInItsPlacesAlone) {
  const auto find = [](const char* name) -> const FocusResult& {
    return *std::find_if(comparison().results.begin(), comparison().results.end(),
                         [&](const FocusResult& each) { return std::string(each.way->name) == name; });
  };
  const Image<Rgb8>& inset = find("inset").picture;
  const Image<Rgb8>& plain = find("plain").picture;
  const std::vector<FocusBox> places = focusPlaces(twoFoci(), {160, 90});
  size_t inside = 0;
  for (int y = 0; y < 90; ++y) {
    for (int x = 0; x < 160; ++x) {
      const glm::dvec2 at = glm::dvec2(x, y) + 0.5;
      if (places[0].contains(at) || places[1].contains(at)) {
        inside += inset(x, y) != plain(x, y);
      } else {
        EXPECT_EQ(inset(x, y), plain(x, y));
      }
    }
  }
  EXPECT_GT(inside, 20U);
  // What it hides is marked in the plain view: around the focus, in its place.
  const Image<Rgb8>& kept = find("inset").kept;
  EXPECT_EQ(kept(43 + 12, 38), kHiddenColor);
  EXPECT_NE(kept(43, 38), kHiddenColor) << "the focus itself";
  EXPECT_EQ(std::count(find("gpc").kept.begin(), find("gpc").kept.end(), kHiddenColor), 0);
}

TEST(FocusComparison, timesAreMeasuredWhereThereIsSomethingToMeasure) {
  for (const FocusResult& result : comparison().results) {
    EXPECT_GT(result.raysMilliseconds, 0) << result.way->name;
    EXPECT_EQ(result.rasterMilliseconds.has_value(), static_cast<bool>(result.way->raster)) << result.way->name;
  }
}

/// A way that the toolkit does not know: compared as all others.
TEST(FocusComparison, takesRowsOfOthers) {
  class Mirrored final : public FocusMap {
   public:
    glm::dvec2 plainFromPicture(const glm::dvec2& at) const override { return {160 - at.x, at.y}; }
    std::optional<glm::dvec2> pictureFromPlain(const glm::dvec2& at) const override {
      return glm::dvec2(160 - at.x, at.y);
    }
  };
  const FocusWay way{"mirrored", "Mirrored", "left and right change places",
                     [](const GpcLayout&, const glm::ivec2&) { return std::make_unique<Mirrored>(); }};
  const FocusComparison one = compareFocusWays(std::span(&way, 1), twoFoci(), plainCamera(), focusScene(), {.runs = 1});
  ASSERT_EQ(one.results.size(), 1U);
  EXPECT_EQ(one.results[0].figures.hiddenShare, 0);
  const Image<Rgb8>& plain = comparison().results.back().picture;
  EXPECT_EQ(one.results[0].picture(10, 40), plain(149, 40));
}

TEST(FocusComparison, refusesWhatHasNoFocus) {
  GpcLayout layout = twoFoci();
  layout.regions[0].zoom = 0.9f;
  EXPECT_THROW(compareFocusWays(focusWays(), layout, plainCamera(), focusScene(), {.runs = 1}), InputError);
  layout.regions[0].center.x = 2;
  EXPECT_THROW(compareFocusWays(focusWays(), layout, plainCamera(), focusScene(), {.runs = 1}), InputError);
}

TEST(FocusPage, holdsEveryWayAndEveryFigure) {
  const std::string html = focusPage({"<scene>", "two.json", "1.2.3", 1}, comparison(), twoFoci());
  EXPECT_THAT(html, HasSubstr("&lt;scene&gt;"));
  EXPECT_THAT(html, HasSubstr("2 foci: 3x, 6x"));
  for (const FocusWay& way : focusWays()) {
    EXPECT_THAT(html, HasSubstr(way.title));
    EXPECT_THAT(html, HasSubstr(focusImageNames(way).picture));
    EXPECT_THAT(html, HasSubstr(focusImageNames(way).rates));
    EXPECT_THAT(html, HasSubstr(focusImageNames(way).kept));
    EXPECT_THAT(focusTable(comparison()), HasSubstr(way.name));
  }
  for (const FocusColumn& column : focusColumns()) {
    EXPECT_NE(html.find(htmlFromText(column.meaning)), std::string::npos) << column.key;
    EXPECT_THAT(focusTable(comparison()), HasSubstr(column.heading));
    EXPECT_THAT(column.key, testing::MatchesRegex("[a-z]+(_[a-z]+)*")) << "as all keys of JSON";
  }
  EXPECT_EQ(html.find("<script"), std::string::npos);
  EXPECT_EQ(html.find("http"), std::string::npos) << "nothing from the network";
}

}  // namespace
}  // namespace ocelli
