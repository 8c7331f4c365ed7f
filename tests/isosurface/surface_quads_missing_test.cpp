// Of a build without OpenVDB.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "oc_core/base/error.h"
#include "oc_core/isosurface/isosurface.h"
#include "tests/isosurface/field_volumes.h"

namespace ocelli {
namespace {

TEST(Isosurface, TheErrorSaysWhatToInstall) {
  const VolumeScene scene = sceneOfField(glm::ivec3(4), [](const glm::dvec3& p) { return p.x; });
  EXPECT_FALSE(canExtractIsosurfaces());
  try {
    isosurface(scene, {.value = 1.5}, "the volume");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("libopenvdb-dev"));
  }
}

}  // namespace
}  // namespace ocelli
