// What users give to make seas from.
#include "oc_core/sea_input/sea_input.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "oc_core/base/error.h"
#include "oc_core/sea/sea_build.h"
#include "tests/base/temporary_folder.h"

namespace ocelli {
namespace {

using test::TemporaryFolder;
using testing::AllOf;
using testing::HasSubstr;
using testing::ThrowsMessage;

constexpr const char* kHouse = "builtin:house";

SeaInputOptions smallGrid() {
  SeaInputOptions options;
  options.size = {64, 32};
  options.samples = 1;
  options.grid = "0,0,0.4,0.2,0.2";
  options.proxyTriangles = 2000;
  return options;
}

TEST(SeaInput, RendersASceneOnAGridInItsOwnUnits) {
  const SeaInput input = openSeaInput(kHouse, {}, smallGrid());
  ASSERT_EQ(input.source->poses().size(), 6u);
  EXPECT_EQ(input.source->poses()[0].position, glm::dvec3(0, 1.6, 0));
  EXPECT_TRUE(input.arePosesExact);
  EXPECT_LE(input.proxy.triangles.size(), input.scene->triangles.size());
  const Box box = boundsOf(*input.scene);
  EXPECT_GT(box.upper.x - box.lower.x, 5) << "metres: it is not fitted into the unit sphere";
}

TEST(SeaInput, FollowsThePathOfAScene) {
  SeaInputOptions options = smallGrid();
  options.grid = "";
  options.spacing = 0.5;
  options.first = 2;
  options.count = 5;
  options.proxy = "box";
  const SeaInput input = openSeaInput(kHouse, {}, options);
  ASSERT_EQ(input.source->poses().size(), 5u);
  EXPECT_EQ(input.proxy.triangles.size(), 12u);
}

TEST(SeaInput, RefusesWhatDoesNotGoTogether) {
  const auto open = [](const char* source, const auto& change) {
    SeaInputOptions options = smallGrid();
    change(options);
    return [source, options] { openSeaInput(source, {}, options); };
  };
  EXPECT_THAT(open("builtin:sphere", [](SeaInputOptions& o) { o.grid = ""; }),
              ThrowsMessage<InputError>(AllOf(HasSubstr("no path"), HasSubstr("--grid"))));
  EXPECT_THAT(open(kHouse, [](SeaInputOptions& o) { o.positions = "x.csv"; }),
              ThrowsMessage<InputError>(HasSubstr("do not go together")));
  EXPECT_THAT(open(kHouse, [](SeaInputOptions& o) { o.grid = "0,0,1,1"; }),
              ThrowsMessage<InputError>(HasSubstr("X0,Z0,X1,Z1,SPACING")));
  EXPECT_THAT(open(kHouse, [](SeaInputOptions& o) { o.grid = "0,0,1e9,1e9,0.01"; }),
              ThrowsMessage<InputError>(HasSubstr("farther apart")));
  EXPECT_THAT(open(kHouse, [](SeaInputOptions& o) { o.first = 6; }), ThrowsMessage<InputError>(HasSubstr("--first")));
  EXPECT_THAT(open(kHouse, [](SeaInputOptions& o) { o.proxy = "cone"; }),
              ThrowsMessage<InputError>(AllOf(HasSubstr("cone"), HasSubstr("box"))));
  EXPECT_THAT(open(kHouse,
                   [](SeaInputOptions& o) {
                     o.size = {4, 4};
                   }),
              ThrowsMessage<InputError>(HasSubstr("--size")));
}

TEST(SeaInput, FindsTheSourceOfASeaAgain) {
  const TemporaryFolder folder;
  SeaInputOptions options = smallGrid();
  const SeaInput input = openSeaInput(kHouse, {}, options);
  SeaSettings settings;
  settings.source = input.source->description();
  settings.projection = input.source->projection();
  settings.iCodec = settings.pCodec = "png";
  buildSea(*input.source, input.proxy, settings, folder / "house.sea");
  const SeaFile sea(folder / "house.sea");
  const SeaInput again = openSeaSource(sea.settings().source, {}, sea, 1);
  EXPECT_EQ(again.source->image(3), input.source->image(3));
}

TEST(SeaInput, AFolderHasItsPlacesAlready) {
  const TemporaryFolder folder;
  writePng(folder / "a.png", Image<Rgb8>(32, 16));
  writePng(folder / "b.png", Image<Rgb8>(32, 16));
  folder.write("positions.csv", "file,x,y,z\na.png,0,0,0\nb.png,1,0,0\n");
  SeaInputOptions options = smallGrid();
  EXPECT_THAT([&] { openSeaInput(folder.path().string(), {}, options); },
              ThrowsMessage<InputError>(HasSubstr("places already")));
  options.grid = "";
  EXPECT_TRUE(openSeaInput(folder.path().string(), {}, options).proxy.empty()) << "nothing is known of the room";
  options.first = 1;
  const SeaInput second = openSeaInput(folder.path().string(), {}, options);
  EXPECT_THAT(second.source->names(), testing::ElementsAre("b.png"));
  EXPECT_FALSE(second.arePosesExact);
  options.proxy = "scene";
  EXPECT_THAT([&] { openSeaInput(folder.path().string(), {}, options); },
              ThrowsMessage<InputError>(HasSubstr("--proxy scene")));
}

}  // namespace
}  // namespace ocelli
