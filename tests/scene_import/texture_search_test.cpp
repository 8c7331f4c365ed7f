#include "oc_core/scene/import/texture_search.h"

#include <gtest/gtest.h>

#include "tests/base/temporary_folder.h"

namespace ocelli {
namespace {

namespace fs = std::filesystem;
using test::TemporaryFolder;

/// scenes/a.gltf with what a test puts beside it.
class FindTextureFile : public testing::Test {
 protected:
  FindTextureFile() { fs::create_directories(folder_.path() / "scenes" / "sub"); }

  void put(const std::string& name) {
    const fs::path path = folder_.path() / name;
    fs::create_directories(path.parent_path());
    folder_.write(name, "x");
  }
  /// From the folder of the test, "none" where nothing is found.
  std::string find(const std::string& name) const {
    const auto found = findTextureFile(folder_.path() / "scenes" / "a.gltf", name);
    return found ? fs::weakly_canonical(*found).lexically_relative(fs::canonical(folder_.path())).string() : "none";
  }

  TemporaryFolder folder_;
};

TEST_F(FindTextureFile, TakesThePathAsItStandsFirst) {
  put("scenes/wood.png");
  put("scenes/sub/wood.png");
  EXPECT_EQ(find("sub/wood.png"), "scenes/sub/wood.png");
  EXPECT_EQ(find((folder_.path() / "scenes" / "sub" / "wood.png").string()), "scenes/sub/wood.png");
}

TEST_F(FindTextureFile, FindsTheBareNameBesideTheScene) {
  put("scenes/wood.png");
  EXPECT_EQ(find("Q:/tex/wood.png"), "scenes/wood.png");
  EXPECT_EQ(find("Q:\\tex\\wood.png"), "scenes/wood.png");
  EXPECT_EQ(find("//wood.png"), "scenes/wood.png");
  EXPECT_EQ(find("//maps/wood.png"), "scenes/wood.png");
  EXPECT_EQ(find("/home/someone/wood.png"), "scenes/wood.png");
  EXPECT_EQ(find("../../elsewhere/wood.png"), "scenes/wood.png");
}

TEST_F(FindTextureFile, TakesBlendersPathFromTheScene) {
  put("scenes/sub/wood.png");
  put("scenes/wood.png");
  EXPECT_EQ(find("//sub\\wood.png"), "scenes/sub/wood.png");
}

TEST_F(FindTextureFile, OverlooksCase) {
  put("scenes/Sub2/Wood.PNG");
  EXPECT_EQ(find("sub2/wood.png"), "scenes/Sub2/Wood.PNG");
  put("scenes/Stone.JPG");
  EXPECT_EQ(find("C:\\STONE.jpg"), "scenes/Stone.JPG");
}

TEST_F(FindTextureFile, OfTwoCasesTheNamedOneElseTheFirst) {
  put("scenes/WOOD.png");
  put("scenes/Wood.png");
  EXPECT_EQ(find("Wood.png"), "scenes/Wood.png");
  EXPECT_EQ(find("wood.png"), "scenes/WOOD.png");
}

TEST_F(FindTextureFile, LooksInFoldersOfTextures) {
  put("scenes/Textures/inside.png");
  put("textures/above.png");
  EXPECT_EQ(find("Q:/inside.png"), "scenes/Textures/inside.png");
  EXPECT_EQ(find("Q:/above.png"), "textures/above.png");
}

TEST_F(FindTextureFile, DecodesWhatAnAddressEncodes) {
  put("scenes/old wood.png");
  EXPECT_EQ(find("old%20wood.png"), "scenes/old wood.png");
  put("scenes/100%zz.png");
  EXPECT_EQ(find("100%zz.png"), "scenes/100%zz.png");
}

TEST_F(FindTextureFile, FindsNamesThatAreNotUtf8) {
  put("scenes/m\xfcll.png");
  EXPECT_EQ(find("Q:/m\xfcll.png"), "scenes/m\xfcll.png");
}

TEST_F(FindTextureFile, FindsNoFoldersDevicesOrNothing) {
  for (const std::string& name : {std::string("sub"), std::string("/dev/zero"), std::string(""), std::string("."),
                                  std::string(".."), std::string("/"), std::string("none.png"), std::string("a\0b", 3),
                                  std::string("%00"), std::string("//"), std::string("\\")}) {
    EXPECT_EQ(find(name), "none") << name;
  }
}

}  // namespace
}  // namespace ocelli
