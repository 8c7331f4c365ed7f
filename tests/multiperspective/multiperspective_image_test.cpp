#include "oc_core/multiperspective/multiperspective_image.h"

#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <ImfStringAttribute.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <array>

#include "oc_core/base/error.h"
#include "oc_core/constructor/curved_bends.h"
#include "oc_core/constructor/graph_operations.h"
#include "oc_core/render/identity_image.h"
#include "tests/base/temporary_folder.h"
#include "tests/camera/test_curved_cameras.h"
#include "tests/camera/test_graph_cameras.h"

namespace ocelli {
namespace {

using test::TemporaryFolder;
using testing::HasSubstr;

/// A box, which is object 5, before a wall that does not fill the image.
GuidedScene scene() {
  GuidedScene scene;
  scene.mesh = test::boxBeforeWall(1.2f);
  scene.objectOfTriangle.assign(scene.mesh.triangles.size(), 5);
  scene.objectOfTriangle[0] = kStructure;
  scene.objectOfTriangle[1] = kStructure;
  return scene;
}

template <class T>
Image<T> channel(Imf::InputFile& file, const char* name, Imf::PixelType type) {
  const Imath::Box2i window = file.header().dataWindow();
  Image<T> image(window.max.x + 1, window.max.y + 1);
  Imf::FrameBuffer buffer;
  buffer.insert(name, Imf::Slice(type, reinterpret_cast<char*>(image.data()), sizeof(T),
                                 sizeof(T) * static_cast<size_t>(image.width())));
  file.setFrameBuffer(buffer);
  file.readPixels(window.min.y, window.max.y);
  return image;
}

Image<float> floats(Imf::InputFile& file, const char* name) {
  return channel<float>(file, name, Imf::FLOAT);
}

void expectFile(const std::filesystem::path& path, const FragmentImage& fragments, const GuidedScene& scene) {
  Imf::InputFile file(path.c_str());
  const std::array color{floats(file, "R"), floats(file, "G"), floats(file, "B")};
  const std::array point{floats(file, "P.X"), floats(file, "P.Y"), floats(file, "P.Z")};
  const Image<float> z = floats(file, "Z");
  const auto objects = channel<uint32_t>(file, "object", Imf::UINT);
  ASSERT_EQ(z.width(), fragments.width());
  ASSERT_EQ(z.height(), fragments.height());
  for (size_t i = 0; i < fragments.size(); ++i) {
    const Fragment& f = fragments[i];
    const bool covered = f.covered();
    EXPECT_EQ(z[i], f.t) << i;
    EXPECT_EQ(objects[i], covered ? scene.objectOfTriangle[f.triangle] : kNothing) << i;
    const glm::vec3 itsColor = covered ? colorOf(f, scene.mesh) : glm::vec3(0);
    const glm::vec3 itsPoint = covered ? positionOf(f, scene.mesh) : glm::vec3(0);
    for (int k = 0; k < 3; ++k) {
      EXPECT_EQ(color[static_cast<size_t>(k)][i], itsColor[k]) << i;
      EXPECT_EQ(point[static_cast<size_t>(k)][i], itsPoint[k]) << i;
    }
  }
}

std::string descriptionOf(const std::filesystem::path& path) {
  return Imf::InputFile(path.c_str()).header().typedAttribute<Imf::StringAttribute>("ocelli").value();
}

TEST(MultiperspectiveImage, ofAGraphCameraReadsBack) {
  const TemporaryFolder folder;
  const GuidedScene shown = scene();
  const GraphCamera camera = test::crossroads();
  const FragmentImage fragments = rasterize(MultiperspectiveCamera(camera), shown.mesh);
  // All kinds of pixels are in it.
  const Image<uint32_t> identities = identityImage(fragments, shown.objectOfTriangle);
  for (const uint32_t identity : {kStructure, 5u, kNothing}) {
    EXPECT_GT(std::count(identities.data(), identities.data() + identities.size(), identity), 50) << identity;
  }
  writeMultiperspectiveImage(folder / "image.exr", fragments, shown, camera);
  expectFile(folder / "image.exr", fragments, shown);
  EXPECT_EQ(descriptionOf(folder / "image.exr"), jsonText(camera));
}

TEST(MultiperspectiveImage, ofACurvedRayCameraReadsBack) {
  const TemporaryFolder folder;
  const GuidedScene shown = scene();
  const CurvedRayCamera camera = test::bendingTwice();
  const FragmentImage fragments = rasterize(MultiperspectiveCamera(camera), shown.mesh);
  writeMultiperspectiveImage(folder / "image.exr", fragments, shown, camera);
  expectFile(folder / "image.exr", fragments, shown);
  EXPECT_EQ(descriptionOf(folder / "image.exr"), jsonText(camera));
}

TEST(MultiperspectiveImage, whereNothingIsSeenAllIsZero) {
  const TemporaryFolder folder;
  const GuidedScene shown = scene();
  const FragmentImage fragments(3, 2);
  writeMultiperspectiveImage(folder / "image.exr", fragments, shown, GraphCamera(test::smallCamera()));
  expectFile(folder / "image.exr", fragments, shown);
}

TEST(MultiperspectiveImage, placesThatCannotBeWrittenAreNamed) {
  const TemporaryFolder folder;
  const FragmentImage fragments(3, 2);
  const auto write = [&](const std::filesystem::path& path) {
    writeMultiperspectiveImage(path, fragments, scene(), GraphCamera(test::smallCamera()));
  };
  EXPECT_THROW(write(folder.path()), WorkError);
  EXPECT_THROW(write("/dev/full"), WorkError);
  try {
    write(folder / "no/such/folder.exr");
    FAIL() << "nothing was thrown";
  } catch (const WorkError& error) {
    EXPECT_THAT(error.what(), HasSubstr("no/such/folder.exr"));
    EXPECT_THAT(error.what(), HasSubstr("No such file or directory"));
  }
}

}  // namespace
}  // namespace ocelli
