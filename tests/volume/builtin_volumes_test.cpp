#include "oc_core/volume/builtin_volumes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>

#include "oc_core/base/error.h"
#include "oc_core/base/parallel.h"
#include "oc_core/volume/voxel_survey.h"

namespace ocelli {
namespace {

using testing::HasSubstr;

std::string volumeErrorOf(const std::string& source) {
  try {
    makeBuiltinVolume(source);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

ScalarVolume madeOf(const std::string& rest) {
  return makeBuiltinVolume("builtin:volume," + rest).volume;
}

/// The value at a point of the world.
double valueAtWorld(const ScalarVolume& volume, const glm::dvec3& point) {
  return volume.fieldAt(glm::dvec3(glm::inverse(volume.grid().worldFromIndex) * glm::dvec4(point, 1)));
}

TEST(BuiltinVolumes, areMadeTheSameWithAnyNumberOfThreads) {
  for (const BuiltinVolumeKind& kind : listBuiltinVolumes()) {
    const std::string source = "size=24,name=" + kind.name;
    const ScalarVolume one = madeOf(source);
    setThreadCount(1);
    const ScalarVolume other = madeOf(source);
    setThreadCount(0);
    EXPECT_EQ(std::memcmp(one.voxels().data(), other.voxels().data(), one.voxels().size()), 0) << kind.name;
    EXPECT_EQ(surveyVoxels(one).notFinite, 0U) << kind.name;
    EXPECT_EQ(glm::max(one.grid().size.x, one.grid().size.y), 24) << kind.name;
  }
}

TEST(BuiltinVolumes, sayWhatIsWrongWithAName) {
  EXPECT_THAT(volumeErrorOf("builtin:volume"), HasSubstr("name=skull"));
  EXPECT_THAT(volumeErrorOf("builtin:volume,name=teapot"), HasSubstr("one of skull, engine"));
  EXPECT_THAT(volumeErrorOf("builtin:volume,name=skull,size=4"), HasSubstr("a whole number from 8 to 1024"));
  EXPECT_THAT(volumeErrorOf("builtin:volume,name=skull,seed=4"), HasSubstr("the volume skull has no parameter 'seed'"));
  EXPECT_THAT(volumeErrorOf("builtin:volume,name=skull,name=engine"), HasSubstr("twice"));
  EXPECT_THAT(volumeErrorOf("builtin:volume,name=skull,size"), HasSubstr("key=value"));
  EXPECT_TRUE(isBuiltinVolume("builtin:volume"));
  EXPECT_FALSE(isBuiltinVolume("builtin:volumes,name=skull"));
}

TEST(BuiltinVolumes, marschnerLobbIsTheFormula) {
  const ScalarVolume volume = madeOf("name=marschner-lobb,size=41");
  // At the origin the wave is cos(12 pi cos 0) = 1: (1 - 0 + 0.25 * 2) / 2.5.
  EXPECT_NEAR(volume.valueAt({20, 20, 20}), 0.6, 1e-6);
  // At z = 1 the sine is 1.
  EXPECT_NEAR(volume.valueAt({20, 20, 40}), 0.2, 1e-6);
  // At r = 1 the wave is cos(12 pi cos(pi / 2)) = 1.
  EXPECT_NEAR(volume.valueAt({40, 20, 20}), 0.6, 1e-6);
}

TEST(BuiltinVolumes, phantomHasTheDensitiesOfItsEllipsoids) {
  const ScalarVolume volume = madeOf("name=phantom,size=200");
  // Points of the phantom, x to the right, y to the front and z to the top; the world's x and y are the other way.
  const auto density = [&](double x, double y, double z) { return valueAtWorld(volume, {-x, -y, z}); };
  // Sums of floats.
  EXPECT_NEAR(density(0, 0.9, 0), 1, 1e-6) << "the skull, in front";
  EXPECT_NEAR(density(0, 0.95, 0), 0, 1e-6) << "before it";
  EXPECT_NEAR(density(0, 0, 0.4), 0.2, 1e-6) << "the brain";
  EXPECT_NEAR(density(-0.22, 0, -0.25), 0, 1e-6) << "a ventricle";
  EXPECT_NEAR(density(0, 0.5, -0.3), 0.3, 1e-6) << "the large one in front";
  EXPECT_NEAR(density(0.06, -0.1, 0.625), 0.3, 1e-6);
  EXPECT_NEAR(density(0, 0.1, 0.6), 0.1, 1e-6);
  EXPECT_TRUE(volume.grid().isAnatomical);
}

TEST(BuiltinVolumes, sphereAndSlabAndRampAreWhatAnalyticTestsTake) {
  const ScalarVolume sphere = madeOf("name=sphere,size=50");
  EXPECT_EQ(valueAtWorld(sphere, {0.4, 0.4, 0.4}), 1);
  EXPECT_EQ(valueAtWorld(sphere, {0.5, 0.5, 0.5}), 0);
  double inside = 0;
  for (int k = 0; k < 50; ++k) {
    for (int j = 0; j < 50; ++j) {
      for (int i = 0; i < 50; ++i) {
        inside += sphere.valueAt({i, j, k});
      }
    }
  }
  // A linear edge is as much too large outside as it is too small inside, to the second order of its width (0.04).
  EXPECT_NEAR(inside * std::pow(2.0 / 50, 3), 4.0 / 3 * 3.14159265 * std::pow(0.75, 3), 2e-3);

  const ScalarVolume slab = madeOf("name=slab,size=16");
  EXPECT_EQ(slab.grid().size, glm::ivec3(16, 16, 4));
  const ValueRange range = valueRange(slab);
  EXPECT_EQ(range.least, 1);
  EXPECT_EQ(range.greatest, 1);

  const ScalarVolume ramp = madeOf("name=ramp,size=16");
  EXPECT_NEAR(valueAtWorld(ramp, {0.5, 0.3, -0.2}), 0.75, 1e-6);
}

TEST(BuiltinVolumes, skullIsAHeadInHounsfieldUnits) {
  const ScalarVolume skull = madeOf("name=skull,size=128");
  EXPECT_EQ(skull.type(), VoxelType::kInt16);
  EXPECT_EQ(skull.facts().modality, "CT");
  EXPECT_EQ(skull.grid().unit, "mm");
  EXPECT_NEAR(skull.grid().spacing().x * 128, 240, 1e-9);
  const auto at = [&](double x, double y, double z) { return valueAtWorld(skull, {x, y, z}); };
  EXPECT_EQ(at(110, 110, 110), -1000) << "air";
  EXPECT_NEAR(at(0, 8, 101), 900, 400) << "the top of the vault, 6 mm thick, in voxels of 2 mm";
  EXPECT_NEAR(at(-30, 30, 50), 34, 10) << "the right half of the brain, between grey and white matter";
  EXPECT_GT(at(46 + 5, -12, 18), 1500) << "the coil in the left half";
  EXPECT_NEAR(at(31, -72, 20), -100, 60) << "fat in the left eye socket";
  EXPECT_NEAR(at(-31, -72, 20), -100, 60);
  EXPECT_GT(at(0, -87, -79), 900) << "the chin";
  EXPECT_LT(at(0, -80, -24), -800) << "air in the nose";
}

TEST(BuiltinVolumes, engineHasTheSizeOfTheText) {
  const ScalarVolume engine = madeOf("name=engine");
  EXPECT_EQ(engine.grid().size, glm::ivec3(256, 256, 110));
  EXPECT_EQ(engine.type(), VoxelType::kUint8);
  const auto at = [&](double x, double y, double z) { return valueAtWorld(engine, {x, y, z}); };
  EXPECT_EQ(at(0.9, 0.9, 0), 0) << "around it";
  EXPECT_EQ(at(0, 0, 0), 120) << "the wall between both cylinders";
  EXPECT_EQ(at(0.38, 0.3, 0), 0) << "a bore, above its piston";
  EXPECT_EQ(at(0.9, -0.6, 0), 230) << "the crankshaft";
}

}  // namespace
}  // namespace ocelli
