#include "display_driver/pacing/turning_volume_source.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>

#include "display_sim/volume_slicing/transfer_blend.h"
#include "tests/display_sim_volume_slicing/swept_scenes.h"

namespace ocelli {
namespace {

using namespace std::chrono_literals;

constexpr HostTime kFirstSeen{100s};

VolumeScene wavyScene() {
  return test::sceneOfField(
      16, 0.55, [](const glm::dvec3& p) { return std::sin(4 * p.x + 2 * p.y) * p.z; },
      TransferFunction({{0, {1, 0, 0}, 0.1}, {0.4, {0, 1, 1}, 0.9}}, 0.1));
}

TEST(TurningVolumeSource, TurnsByStepsOfTheSweep) {
  const VolumeScene scene = wavyScene();
  const SweptSamples samples(scene, loadProfile("test"));
  const auto shared =
      std::make_shared<const SweptLight>(scene.appearance.transfer, samples.range(), 1, samples.sweep());
  const SweptLight& light = *shared;
  // A step of this display is 7.5 degrees.
  TurningVolumeSource source([&](double) { return VolumeMoment{&samples, shared}; }, samples.profile(), {}, 30);
  VolumeSlicer slicer(samples.profile());
  const SourcedVolume first = source.volumeFor(kFirstSeen);
  ASSERT_EQ(first.kind, SourcedVolume::Kind::kNew);
  EXPECT_EQ(*first.volume, slicer.slice(samples, light));
  EXPECT_EQ(source.volumeFor(kFirstSeen + 100ms).kind, SourcedVolume::Kind::kSame);
  const SourcedVolume turned = source.volumeFor(kFirstSeen + 1s);
  ASSERT_EQ(turned.kind, SourcedVolume::Kind::kNew);
  EXPECT_EQ(*turned.volume, slicer.slice(samples, light, 4));
  EXPECT_NE(*turned.volume, *first.volume);
}

TEST(TurningVolumeSource, ShowsLightThatMoves) {
  const VolumeScene scene = wavyScene();
  const SweptSamples samples(scene, loadProfile("test"));
  const TransferFunction dark({{0, {1, 1, 1}, 0.01}}, 0.1);
  const auto lightAt = [&](double seconds) {
    return SweptLight(blendedTransfer(scene.appearance.transfer, dark, seconds), samples.range(), 1, samples.sweep());
  };
  TurningVolumeSource source(
      [&](double seconds) {
        return VolumeMoment{&samples, std::make_shared<const SweptLight>(lightAt(seconds))};
      },
      samples.profile(), {}, 0);
  VolumeSlicer slicer(samples.profile());
  EXPECT_EQ(*source.volumeFor(kFirstSeen).volume, slicer.slice(samples, lightAt(0)));
  EXPECT_EQ(*source.volumeFor(kFirstSeen + 500ms).volume, slicer.slice(samples, lightAt(0.5)));
}

TEST(TurningVolumeSource, ShowsOneVolumeAfterAnotherAndEnds) {
  const VolumeScene first = wavyScene();
  VolumeScene second = first;
  second.worldFromIndex[3].y += 0.2;
  const DisplayProfile profile = loadProfile("test");
  const SweptSamples samples[] = {SweptSamples(first, profile), SweptSamples(second, profile)};
  const auto light =
      std::make_shared<const SweptLight>(first.appearance.transfer, samples[0].range(), 1, samples[0].sweep());
  TurningVolumeSource source(
      [&](double seconds) -> std::optional<VolumeMoment> {
        return seconds < 2 ? std::optional(VolumeMoment{&samples[seconds < 1 ? 0 : 1], light}) : std::nullopt;
      },
      profile, {}, 0);
  const SourcedVolume early = source.volumeFor(kFirstSeen);
  EXPECT_EQ(source.volumeFor(kFirstSeen + 900ms).kind, SourcedVolume::Kind::kSame);
  const SourcedVolume late = source.volumeFor(kFirstSeen + 1100ms);
  ASSERT_EQ(late.kind, SourcedVolume::Kind::kNew);
  EXPECT_NE(*late.volume, *early.volume);
  EXPECT_EQ(source.volumeFor(kFirstSeen + 2s).kind, SourcedVolume::Kind::kEnd);
}

}  // namespace
}  // namespace ocelli
