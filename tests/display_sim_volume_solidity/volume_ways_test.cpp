#include "display_sim/volume_solidity/volume_ways.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "oc_core/base/error.h"
#include "tests/display_sim_volume_slicing/swept_scenes.h"

namespace ocelli {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

/// A dense ball in a thin one, so that something lies before, in and behind what is opaque.
VolumeWaysToMeasure ballToMeasure() {
  const glm::vec3 eye(0, 0, 10);
  return {.scene = test::sceneOfField(
              24, 0.5, [](const glm::dvec3& p) { return 1 - 2 * glm::length(p); },
              TransferFunction({{0, {1, 0.2, 0}, 0}, {0.3, {1, 0.6, 0.2}, 0.02}, {0.6, {1, 1, 1}, 0.9}}, 0.02)),
          .settings = {.referenceEye = eye, .cellEyes = {eye, eye + glm::vec3(0.5f, 0, 0)}}};
}

SolidityFigures figuresOf(const std::string& way) {
  VolumeWaysToMeasure wanted = ballToMeasure();
  wanted.ways = {way};
  return measureVolumeWays(wanted, {.profile = loadProfile("test"), .groups = {{"reference", {{0, 0, 10}}}}}).front();
}

// The recipe at the top of volume_ways.h: a new way is one row, and this test finds it.
TEST(VolumeWays, showSomethingEach) {
  std::set<std::string> names;
  for (const VolumeWay& way : volumeWays()) {
    EXPECT_TRUE(names.insert(way.name).second) << way.name;
    EXPECT_FALSE(way.summary.empty());
    const SolidityFigures figures = figuresOf(way.name);
    EXPECT_EQ(figures.name, way.name);
    EXPECT_GT(figures.litVoxels, 50u) << way.name;
  }
}

TEST(VolumeWays, areRegisteredFromOutside) {
  registerVolumeWay({"faint", "a tenth of the light",
                     [](ShownVolumeOptions& options, const VolumeWaySettings&) { options.light.gain = 0.1; }});
  EXPECT_EQ(volumeWayByName("faint", "--ways").summary, "a tenth of the light");
  EXPECT_LT(figuresOf("faint").litVoxels, figuresOf("everything").litVoxels);
}

TEST(VolumeWays, unknownNamesAreAnsweredWithTheKnownOnes) {
  for (const VolumeWay& way : volumeWays()) {
    EXPECT_THAT([] { volumeWayByName("see", "--ways"); }, ThrowsMessage<InputError>(HasSubstr(way.name)));
  }
}

TEST(VolumeWays, whatNobodyCouldAskForIsRefused) {
  const auto set = [](ShownVolumeOptions&, const VolumeWaySettings&) {};
  const auto expect = [](VolumeWay way, const std::string& what) {
    EXPECT_THAT([&] { registerVolumeWay(way); }, ThrowsMessage<InputError>(HasSubstr(what)));
  };
  expect({"", "no name", set}, "name");
  expect({"a,b", "two names", set}, "comma");
  expect({"seen", "a name that is taken", set}, "already");
  expect({"idle", "no function", {}}, "no function");
}

}  // namespace
}  // namespace ocelli
