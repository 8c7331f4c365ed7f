#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <mutex>
#include <thread>

#include "display_driver/pacing/eyes_source.h"
#include "display_driver/pacing/motion_source.h"
#include "display_driver/pacing/moving_view.h"
#include "display_driver/pacing/recording_source.h"
#include "display_driver/pacing/still_source.h"
#include "display_driver/pacing/turning_source.h"
#include "display_sim/frames/svol_writer.h"
#include "display_sim/slicing/turn_about_axis.h"
#include "oc_core/base/error.h"
#include "oc_core/ocri/camera_choice.h"
#include "oc_core/ocri/union_mesh.h"
#include "oc_core/scene/ply_file.h"
#include "oc_core/scene/scene.h"
#include "tests/base/temporary_folder.h"
#include "tests/display_driver_wire/made_volumes.h"

namespace ocelli {
namespace {

using namespace std::chrono_literals;
using Kind = SourcedVolume::Kind;

const HostTime kStart(100s);

Mesh teapot() {
  return loadScene("builtin:teapot,segments=4");
}

DisplayProfile smallDisplay() {
  return loadProfile("test");
}

/// Slices that differ are among those that the source says.
void expectListed(const Volume& before, const SourcedVolume& now) {
  ASSERT_TRUE(now.changed);
  for (int slice = 0; slice < before.slices(); ++slice) {
    const bool same = std::ranges::equal(before.slice(slice), now.volume->slice(slice));
    EXPECT_TRUE(same || std::ranges::count(*now.changed, slice) > 0) << slice;
  }
}

TEST(StillSourceTest, givesItsVolumeOnce) {
  StillSource source(madeVolume(smallDisplay(), 1));
  const SourcedVolume first = source.volumeFor(kStart);
  ASSERT_EQ(first.kind, Kind::kNew);
  EXPECT_EQ(*first.volume, madeVolume(smallDisplay(), 1));
  EXPECT_EQ(source.volumeFor(kStart + 1s).kind, Kind::kSame);
}

class RecordingSourceTest : public testing::Test {
 protected:
  void SetUp() override {
    SvolWriter writer(path, smallDisplay());
    for (const uint64_t milliseconds : {500, 600, 800}) {  // what is first is seen first
      volumes.push_back(madeVolume(smallDisplay(), milliseconds));
      writer.append(volumes.back(), 1000 * milliseconds);
    }
    writer.finish();
  }
  const test::TemporaryFolder folder;
  const std::filesystem::path path = folder / "a.svol";
  std::vector<Volume> volumes;
};

TEST_F(RecordingSourceTest, framesComeAtTheirOwnTimes) {
  RecordingSource source(path, false);
  EXPECT_EQ(source.profile(), smallDisplay());
  const SourcedVolume first = source.volumeFor(kStart);
  EXPECT_EQ(*first.volume, volumes[0]);
  EXPECT_FALSE(first.changed);
  EXPECT_EQ(source.volumeFor(kStart + 99ms).kind, Kind::kSame);
  const SourcedVolume second = source.volumeFor(kStart + 100ms);
  ASSERT_EQ(second.kind, Kind::kNew);
  EXPECT_EQ(*second.volume, volumes[1]);
  expectListed(volumes[0], second);
  EXPECT_EQ(*source.volumeFor(kStart + 320ms).volume, volumes[2]);
  // The last one stays for one refresh, 1/24 s.
  EXPECT_EQ(source.volumeFor(kStart + 341ms).kind, Kind::kSame);
  EXPECT_EQ(source.volumeFor(kStart + 342ms).kind, Kind::kEnd);
}

TEST_F(RecordingSourceTest, inALoopItBeginsAgain) {
  RecordingSource source(path, true);
  source.volumeFor(kStart);
  source.volumeFor(kStart + 310ms);
  const SourcedVolume again = source.volumeFor(kStart + 342ms);  // 0.3 ms after its end
  ASSERT_EQ(again.kind, Kind::kNew);
  EXPECT_EQ(*again.volume, volumes[0]);
  expectListed(volumes[2], again);
}

TEST_F(RecordingSourceTest, filesWithoutFramesAreRefused) {
  SvolWriter(folder / "empty.svol", smallDisplay()).finish();
  EXPECT_THROW(RecordingSource(folder / "empty.svol", false), InputError);
}

TEST(TurningSourceTest, isTheSliceOfTheTurnedMesh) {
  const Mesh mesh = teapot();
  TurningSource source(mesh, smallDisplay(), {}, 90);
  EXPECT_EQ(*source.volumeFor(kStart).volume, slice(mesh, smallDisplay()));
  // A quarter turn, counter-clockwise seen from above: what was at +z is at +x.
  Mesh turned = mesh;
  for (glm::vec3& p : turned.positions) {
    p = {p.z, p.y, -p.x};
  }
  const Volume expected = slice(turned, smallDisplay());
  const std::shared_ptr<const Volume> found = source.volumeFor(kStart + 1s).volume;
  size_t differs = 0;
  for (int i = 0; i < expected.slices(); ++i) {
    for (int y = 0; y < expected.height(); ++y) {
      for (int x = 0; x < expected.width(); ++x) {
        differs += found->colorBits(i, x, y) != expected.colorBits(i, x, y) ? 1 : 0;
      }
    }
  }
  // The cosine of the angle is a rounding away from 0: samples on the border of two voxels may change sides.
  EXPECT_LT(differs, expected.litVoxels() / 50);
  // After a whole turn the angle is 0 again.
  EXPECT_EQ(*source.volumeFor(kStart + 4s).volume, slice(mesh, smallDisplay()));
}

// What turning_bench relies on: an eye that walks the other way round sees what the eye at rest sees of the turned
// scene.
TEST(TurningSourceTest, turningTheSceneIsTurningTheEyeTheOtherWay) {
  constexpr double kAngle = 0.4;
  const Mesh mesh = teapot();
  Mesh turned = mesh;
  turnAboutAxis(mesh.positions, kAngle, turned.positions);
  View view;
  const ReferenceImages ofTurned = buildReferenceImages(cameraChoice("di"), {view, 90, 60}, turned);
  for (glm::vec3* each : {&view.eye, &view.target, &view.up}) {
    *each = turnedAboutAxis(*each, -kAngle);
  }
  const ReferenceImages fromTurnedEye = buildReferenceImages(cameraChoice("di"), {view, 90, 60}, mesh);
  const PinholeCamera walking(view, 90, 60);
  const PinholeCamera resting(View{}, 90, 60);
  size_t held = 0;
  size_t differs = 0;
  for (int y = 0; y < 60; ++y) {
    for (int x = 0; x < 90; ++x) {
      const std::optional<glm::vec3> expected = ofTurned[0].pointOf(x, y, resting);
      const std::optional<glm::vec3> found = fromTurnedEye[0].pointOf(x, y, walking);
      held += expected ? 1 : 0;
      differs += expected.has_value() != found.has_value() ||
                         (found && glm::distance(turnedAboutAxis(*found, kAngle), *expected) > 1e-4f)
                     ? 1
                     : 0;
    }
  }
  EXPECT_GT(held, 500u);
  // Rounding may take a silhouette across the centre of a pixel.
  EXPECT_LT(differs, held / 200);
}

class MotionSourceTest : public testing::Test {
 protected:
  void add(const std::string& name, float size) {
    Mesh mesh = teapot();
    transform(mesh, glm::scale(glm::mat4(1), glm::vec3(size)));
    writePly(folder / name, mesh);
  }
  std::unique_ptr<SceneMotion> series(bool fit = true) const {
    SceneOptions options;
    options.fit = fit;
    options.motion.meshesPerSecond = 10;
    return loadMotion(folder.path().string(), options);
  }
  const test::TemporaryFolder folder;
};

TEST_F(MotionSourceTest, meshesComeAtTheRateAndKeepTheirSizes) {
  add("a1.ply", 0.5f);
  add("a2.ply", 1);
  MotionSource source(series(), smallDisplay(), {}, {});
  const SourcedVolume first = source.volumeFor(kStart);
  ASSERT_EQ(first.kind, Kind::kNew);
  const size_t small = first.volume->litVoxels();
  EXPECT_EQ(source.volumeFor(kStart + 99ms).kind, Kind::kSame);
  const SourcedVolume second = source.volumeFor(kStart + 101ms);
  ASSERT_EQ(second.kind, Kind::kNew);
  // One scale for both: the second has four times the surface, though not quite as many times the voxels.
  EXPECT_GT(second.volume->litVoxels(), 2 * small);
  EXPECT_EQ(source.volumeFor(kStart + 201ms).kind, Kind::kEnd);
  MotionSource again(series(), smallDisplay(), {}, {.loop = true});
  again.volumeFor(kStart);
  again.volumeFor(kStart + 101ms);
  EXPECT_EQ(again.volumeFor(kStart + 201ms).volume->litVoxels(), small);
}

TEST_F(MotionSourceTest, tellsWhetherAPartOfAnyMeshIsCutOff) {
  add("a1.ply", 0.1f);
  EXPECT_FALSE(MotionSource(series(false), smallDisplay(), {}, {}).isCutOff());
  add("a2.ply", 5);
  EXPECT_TRUE(MotionSource(series(false), smallDisplay(), {}, {}).isCutOff());
  EXPECT_FALSE(MotionSource(series(), smallDisplay(), {}, {}).isCutOff());
}

// The mesh of each time in the slicer's order, which a slicer that begins anew makes the same volume of.
TEST_F(MotionSourceTest, isWhatSlicingEachMomentByItselfGives) {
  const std::string source = "builtin:waving,seconds=2";
  MotionSource played(loadMotion(source, {}), smallDisplay(), {}, {.speed = 2});
  const auto motion = loadMotion(source, {});
  std::vector<glm::uvec3> order;
  for (const double seconds : {0.0, 0.3, 0.6, 0.9}) {
    const HostTime seen = kStart + std::chrono::milliseconds(static_cast<int>(1000 * seconds));
    const SourcedVolume volume = played.volumeFor(seen);
    ASSERT_EQ(volume.kind, Kind::kNew) << seconds;
    Mesh mesh = motion->at(2 * std::chrono::duration<double>(seen - kStart).count());
    order = order.empty() ? trianglesForSlicing(mesh) : order;
    mesh.triangles = order;
    EXPECT_EQ(*volume.volume, slice(mesh, smallDisplay())) << seconds;
    EXPECT_EQ(played.volumeFor(seen).kind, Kind::kSame);
  }
  EXPECT_EQ(played.volumeFor(kStart + 1s).kind, Kind::kEnd);
}

TEST(MotionClockTest, runsAtItsSpeedFromTheFirstQuestionOn) {
  MotionClock once(3, {.speed = 2});
  EXPECT_EQ(once.at(kStart), 0);
  EXPECT_EQ(once.at(kStart + 1s), 2);
  EXPECT_EQ(once.at(kStart + 1500ms), std::nullopt);
  MotionClock again(3, {.speed = 2, .loop = true});
  again.at(kStart);
  EXPECT_EQ(again.at(kStart + 2s), 1);
}

/// Eyes that a test sets.
class SetEyes final : public EyeFeed {
 public:
  std::optional<glm::vec3> eyeAt(HostTime) override {
    const std::lock_guard lock(mutex);
    return eye;
  }
  bool ended(HostTime) override { return over; }
  std::mutex mutex;
  std::optional<glm::vec3> eye;
  bool over = false;
};

class EyesSourceTest : public testing::Test {
 protected:
  EyesSource sourceFor(const char* camera, double minImageScale = 1) {
    return EyesSource(imagesBy(camera), smallDisplay(),
                      {.width = 90, .height = 60, .slicing = {}, .minImageScale = minImageScale, .refreshesToMake = 1},
                      eyes);
  }
  EyesSource::ImagesFor imagesBy(const char* camera) const {
    return [this, choice = cameraChoice(camera)](const PinholeCamera& reference) {
      return buildReferenceImages(choice, reference, mesh);
    };
  }
  const Mesh mesh = teapot();
  SetEyes eyes;
};

TEST_F(EyesSourceTest, isTheSlicedMeshOfTheReferenceImageFromThere) {
  EyesSource source = sourceFor("ddoc");
  EXPECT_EQ(source.volumeFor(kStart).kind, Kind::kSame);  // nobody is there
  for (const glm::vec3 eye : {glm::vec3(0, 0, 10), glm::vec3(3, 1, 9), glm::vec3(0, 10, 0)}) {
    eyes.eye = eye;
    const SourcedVolume seen = source.volumeFor(kStart);
    ASSERT_EQ(seen.kind, Kind::kNew);
    View view;
    view.eye = eye;
    if (eye.y == 10) {
      view.up = {0, 0, -1};
    }
    const PinholeCamera reference(view, 90, 60);
    const Mesh expected = unionMesh(buildReferenceImages(cameraChoice("ddoc"), reference, mesh));
    EXPECT_EQ(*seen.volume, slice(expected, smallDisplay()));
    EXPECT_EQ(source.volumeFor(kStart + 1s).kind, Kind::kSame);
  }
  EXPECT_EQ(source.eyesLeftOut(), 0u);
  for (const auto& stage : source.stages()) {
    EXPECT_FALSE(stage.times.empty()) << stage.name;
  }
}

TEST_F(EyesSourceTest, eyesThatSeeNothingAreLeftOut) {
  EyesSource source = sourceFor("di");
  for (const glm::vec3 inside : {glm::vec3(0, 0, 0.5f), glm::vec3(0)}) {
    eyes.eye = inside;
    EXPECT_EQ(source.volumeFor(kStart).kind, Kind::kSame);
  }
  EXPECT_EQ(source.eyesLeftOut(), 2u);
  EXPECT_FALSE(source.firstLeftOut().empty());
  eyes.eye = glm::vec3(0, 0, 10);
  EXPECT_EQ(source.volumeFor(kStart).kind, Kind::kNew);
}

TEST_F(EyesSourceTest, endsWhenTheLastPlaceHasBeenShown) {
  EyesSource source = sourceFor("di");
  eyes.eye = glm::vec3(0, 0, 10);
  eyes.over = true;
  EXPECT_EQ(source.volumeFor(kStart).kind, Kind::kNew);
  EXPECT_EQ(source.volumeFor(kStart).kind, Kind::kEnd);
}

TEST_F(EyesSourceTest, makesTheSameBesideTheCaller) {
  EyesSource source = sourceFor("eoc-h");
  EyesSource beside = sourceFor("eoc-h");
  VolumeLine& line = *beside.line();
  const std::vector<glm::vec3> places{{0, 0, 10}, {3, 1, 9}, {0, 0, 0.5f}, {3, 1, 8}, {-3, 1, 9}};
  std::vector<SourcedVolume> made;
  for (const glm::vec3& place : places) {
    while (!line.ready()) {
      if (const auto volume = line.finished()) {
        made.push_back(*volume);
      }
      std::this_thread::sleep_for(1ms);
    }
    const std::lock_guard lock(eyes.mutex);
    eyes.eye = place;
    line.begin(kStart);
  }
  while (made.size() < places.size()) {
    if (const auto volume = line.finished()) {
      made.push_back(*volume);
    }
  }
  for (size_t i = 0; i < places.size(); ++i) {
    eyes.eye = places[i];
    const SourcedVolume expected = source.volumeFor(kStart);
    ASSERT_EQ(made[i].kind, expected.kind) << i;
    if (expected.kind == Kind::kNew) {
      EXPECT_EQ(*made[i].volume, *expected.volume) << i;
    }
  }
  EXPECT_EQ(beside.eyesLeftOut(), 1u);
}

TEST_F(EyesSourceTest, imagesAreSmallerWhileTimeIsShort) {
  const auto images = imagesBy("di");
  std::atomic<bool> slow = true;
  std::vector<int> widths;
  EyesSource source(
      [&](const PinholeCamera& reference) {
        widths.push_back(reference.width());
        std::this_thread::sleep_for(slow ? 70ms : 0ms);
        return images(reference);
      },
      smallDisplay(), {.width = 90, .height = 60, .slicing = {}, .minImageScale = 0.5, .refreshesToMake = 1}, eyes);
  float scale = 0;
  const auto next = [&](int i) {
    eyes.eye = glm::vec3(0.01f * static_cast<float>(i), 0, 10);
    const SourcedVolume made = source.volumeFor(kStart);
    ASSERT_EQ(made.kind, Kind::kNew);
    EXPECT_EQ(widths.back(), static_cast<int>(std::lround(90.0f * made.imageScale)));
    scale = made.imageScale;
  };
  for (int i = 0; i < 8; ++i) {
    next(i);
  }
  EXPECT_EQ(widths.front(), 45) << "it begins small";
  EXPECT_FLOAT_EQ(scale, 0.5f);
  slow = false;
  for (int i = 8; i < 80; ++i) {
    next(i);
  }
  EXPECT_FLOAT_EQ(scale, 1) << "it grows again, by more than one step";
}

TEST_F(EyesSourceTest, theLastPlaceIsShownWithAllPixels) {
  EyesSource source = sourceFor("di", 0.5);
  eyes.eye = glm::vec3(0, 0, 10);
  eyes.over = true;
  ASSERT_FLOAT_EQ(source.volumeFor(kStart).imageScale, 0.5f);
  const SourcedVolume last = source.volumeFor(kStart);
  ASSERT_EQ(last.kind, Kind::kNew);
  EXPECT_FLOAT_EQ(last.imageScale, 1);
  EXPECT_EQ(source.volumeFor(kStart).kind, Kind::kEnd);
}

TEST_F(EyesSourceTest, anEyeThatSeesNothingIsLeftOutOnce) {
  EyesSource source = sourceFor("di", 0.5);
  eyes.eye = glm::vec3(0, 0, 0.5f);
  for (int i = 0; i < 40; ++i) {
    EXPECT_EQ(source.volumeFor(kStart).kind, Kind::kSame);
  }
  EXPECT_EQ(source.eyesLeftOut(), 1u);
}

TEST_F(EyesSourceTest, anEyeThatRestsSeesAllPixels) {
  EyesSource source = sourceFor("di", 0.5);
  eyes.eye = glm::vec3(0, 0, 10);
  ASSERT_FLOAT_EQ(source.volumeFor(kStart).imageScale, 0.5f);
  std::vector<SourcedVolume> made;
  for (int i = 0; i < 40; ++i) {
    if (SourcedVolume volume = source.volumeFor(kStart); volume.kind != Kind::kSame) {
      made.push_back(std::move(volume));
    }
  }
  ASSERT_EQ(made.size(), 1u);
  EXPECT_FLOAT_EQ(made.front().imageScale, 1);
  EXPECT_EQ(*made.front().volume, *sourceFor("di").volumeFor(kStart).volume);
}

// What an eye sees that moves, too: for each time the image of the scene as it is then, by whichever construction.
TEST_F(EyesSourceTest, seesTheSceneAsItIsAtTheTime) {
  const std::string scene = "builtin:waving,seconds=2";
  for (const Construction construction : {Construction::kRaster, Construction::kRays}) {
    MovingImages images(cameraChoice("eoc-h"));
    MovingView view(loadMotion(scene, {}), images, {}, 90 * 60, construction);
    EyesSource source([&](const PinholeCamera& reference) { return view.imagesFrom(reference); }, smallDisplay(),
                      {.width = 90,
                       .height = 60,
                       .slicing = {},
                       .minImageScale = 1,
                       .moveScene = [&](HostTime seen) { return view.moveTo(seen); }},
                      eyes);
    const auto motion = loadMotion(scene, {});
    eyes.eye = glm::vec3(0, 0, 10);
    for (const double seconds : {0.0, 0.5, 1.0}) {
      const HostTime seen = kStart + std::chrono::milliseconds(static_cast<int>(1000 * seconds));
      const SourcedVolume volume = source.volumeFor(seen);
      ASSERT_EQ(volume.kind, Kind::kNew) << seconds;
      const Mesh& now = motion->at(seconds);
      View fromEye;
      fromEye.eye = *eyes.eye;
      const RayScene rays(now);
      const ReferenceImages expected =
          buildReferenceImages(cameraChoice("eoc-h"), PinholeCamera(fromEye, 90, 60), now, {}, construction,
                               construction == Construction::kRays ? &rays : nullptr);
      const Volume still = slice(unionMesh(expected), smallDisplay());
      if (construction == Construction::kRaster) {
        EXPECT_EQ(*volume.volume, still) << seconds;
      } else {
        // Rays that meet an edge may tell either of its triangles, as the structures were not built alike.
        EXPECT_NEAR(static_cast<double>(volume.volume->litVoxels()), static_cast<double>(still.litVoxels()),
                    0.002 * static_cast<double>(still.litVoxels()));
      }
      // The eye stands still, and so does the time.
      EXPECT_EQ(source.volumeFor(seen).kind, Kind::kSame);
      eyes.eye = *eyes.eye + glm::vec3(0.3f, 0, 0);
    }
    EXPECT_EQ(source.volumeFor(kStart + 2s).kind, Kind::kEnd);
    EXPECT_FALSE(source.stages().back().times.empty()) << "moving the scene is a stage";
    EXPECT_EQ(view.imagesMade(), 3);
    EXPECT_EQ(view.imagesByRays(), construction == Construction::kRays ? 3 : 0);
  }
}

}  // namespace
}  // namespace ocelli
