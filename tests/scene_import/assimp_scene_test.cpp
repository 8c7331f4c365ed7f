#include "oc_core/scene/import/assimp_scene.h"

#include <gtest/gtest.h>

#include "oc_core/base/error.h"
#include "tests/base/temporary_folder.h"

namespace ocelli {
namespace {

namespace fs = std::filesystem;
using test::TemporaryFolder;

TEST(ReadWithAssimp, OpensRegularFilesAlone) {
  const TemporaryFolder folder;
  const std::string mesh = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
  const SceneRecord record = readWithAssimp(folder.write("a.obj", "mtllib /dev/zero\n" + mesh), true, nullptr);
  ASSERT_EQ(record.parts.size(), 1u);
  EXPECT_EQ(record.parts[0].mesh.triangles.size(), 1u);
  fs::create_symlink("/dev/zero", folder / "zero.obj");
  EXPECT_THROW(readWithAssimp(folder / "zero.obj", true, nullptr), InputError);
}

}  // namespace
}  // namespace ocelli
