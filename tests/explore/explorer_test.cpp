#include "oc_core/explore/explorer.h"

#include <gmock/gmock.h>

#include <atomic>
#include <chrono>
#include <thread>

#include "oc_core/base/error.h"
#include "oc_core/base/parallel.h"
#include "oc_core/explore/explore_renderer.h"
#include "oc_core/explore/explore_shapes.h"
#include "oc_core/walkable/walk_options.h"
#include "tests/explore/explore_scenes.h"

namespace ocelli {
namespace {

using testing::HasSubstr;
using testing::Not;

constexpr int kMaxFrames = 400;

void rest(Explorer& explorer) {
  explorer.advance({}, test::kExploreFrame);
  for (int i = 0; i < kMaxFrames && !explorer.atRest(); ++i) {
    explorer.advance({}, test::kExploreFrame);
  }
  EXPECT_TRUE(explorer.atRest());
}

std::string notesOf(const Explorer& explorer) {
  std::string text;
  for (const ExploreNote& note : explorer.frame().notes) {
    text += note.text + "; ";
  }
  return text;
}

size_t frustaOf(const Explorer& explorer) {
  return std::get<GraphCamera>(explorer.frame().camera).frusta().size();
}

TEST(LiveConstructors, haveNamesOfTheirOwnAndOptionsWithinTheirRanges) {
  std::set<std::string> names;
  const ExploreScene scene(test::twoRooms());
  EXPECT_STREQ(liveConstructors().front().name, "pinhole");
  for (const LiveConstructorRow& row : liveConstructors()) {
    EXPECT_TRUE(names.insert(row.name).second) << row.name;
    EXPECT_NE(std::string(row.description), "");
    const std::unique_ptr<LiveConstructor> made = row.make(scene);
    std::set<std::string> options;
    for (size_t i = 0; i < row.options.size(); ++i) {
      const LiveOption& option = row.options[i];
      EXPECT_TRUE(options.insert(option.name).second) << row.name << " " << option.name;
      EXPECT_LT(option.min, option.max) << option.name;
      EXPECT_TRUE(option.otherwise >= option.min && option.otherwise <= option.max) << option.name;
      EXPECT_TRUE(option.choices.empty() || static_cast<double>(option.choices.size()) == option.max - option.min + 1)
          << option.name;
      for (const double value : {option.min, option.max, option.otherwise}) {
        made->setOption(i, value);
        EXPECT_EQ(made->option(i), value) << row.name << " " << option.name;
      }
    }
  }
}

TEST(Explorer, beginsWithThePinhole) {
  ExploreScene scene(test::twoRooms());
  const Explorer explorer(scene, test::smallPictures());
  EXPECT_STREQ(explorer.chosen().name, "pinhole");
  EXPECT_EQ(frustaOf(explorer), 1u);
  EXPECT_EQ(explorer.frame().deployed, 0);
  EXPECT_TRUE(explorer.frame().outlines.empty());
}

TEST(Explorer, deploysAndCollapsesStepByStep) {
  ExploreScene scene(test::twoRooms());
  Explorer explorer(scene, test::smallPictures());
  explorer.jumpTo({{-5, 1.6, 0.5}, 55, 0});
  explorer.choose("portal");
  EXPECT_STREQ(explorer.chosen().name, "portal");
  double before = 0;
  double widest = 0;
  for (int i = 0; i < 60; ++i) {
    explorer.advance({}, test::kExploreFrame);
    widest = std::max(widest, std::abs(explorer.frame().deployed - before));
    before = explorer.frame().deployed;
  }
  EXPECT_EQ(before, 1);
  EXPECT_LE(widest, test::kExploreFrame / test::smallPictures().deploySeconds + 1e-9);
  EXPECT_GT(frustaOf(explorer), 1u);
  EXPECT_FALSE(explorer.frame().outlines.empty());

  explorer.choose("pinhole");
  explorer.advance({}, test::kExploreFrame);
  EXPECT_GT(frustaOf(explorer), 1u) << "collapsing yet";
  rest(explorer);
  EXPECT_EQ(frustaOf(explorer), 1u);
}

TEST(Explorer, choosingBackBeforeItCollapsedKeepsIt) {
  ExploreScene scene(test::hiddenBox());
  Explorer explorer(scene, test::smallPictures());
  explorer.jumpTo({{0, 1.6, 4}, 0, 0});
  explorer.choose("target");
  explorer.pick(ExplorePick{{0, 1, -7}, 2, true, false, {}, {}});
  rest(explorer);
  ASSERT_TRUE(explorer.picked());
  explorer.choose("pinhole");
  explorer.advance({}, test::kExploreFrame);
  explorer.choose("target");
  rest(explorer);
  EXPECT_TRUE(explorer.picked()) << "it is the same one";
}

TEST(Explorer, unknownNamesAreErrors) {
  ExploreScene scene(test::hall());
  Explorer explorer(scene, test::smallPictures());
  EXPECT_THROW(explorer.choose("telescope"), InputError);
  EXPECT_THROW(explorer.option("shadow"), InputError);
  explorer.choose("occluder");
  EXPECT_THROW(explorer.setOption("shadow", 1000), InputError);
  EXPECT_THROW(explorer.setOption("depth", 1), InputError);
  explorer.setOption("shadow", 2);
  EXPECT_EQ(explorer.option("shadow"), 2);
}

TEST(Explorer, picksWhatTheRayOfAPixelMeets) {
  ExploreScene scene(test::twoRooms());
  Explorer explorer(scene, test::smallPictures());
  explorer.jumpTo({{0, 1.6, 2}, 0, 0});
  explorer.advance({}, test::kExploreFrame);
  const std::optional<ExplorePick> through = explorer.probe({80, 47});
  ASSERT_TRUE(through);
  ASSERT_TRUE(through->portal);
  EXPECT_EQ(through->portal->center, glm::vec3(0, 1, -3));
  EXPECT_LT(through->position.z, -3);
  const std::optional<ExplorePick> wall = explorer.probe({20, 40});
  ASSERT_TRUE(wall);
  EXPECT_FALSE(wall->portal);
  EXPECT_FALSE(wall->floor);
  EXPECT_NEAR(wall->position.z, -2.9, 1e-3);
  const std::optional<ExplorePick> floor = explorer.probe({80, 89});
  ASSERT_TRUE(floor);
  EXPECT_TRUE(floor->floor);
  EXPECT_FALSE(explorer.probe({-1, 5}));
  EXPECT_FALSE(explorer.probe({5, 90}));
}

TEST(Explorer, aPickedPortalIsTheOnlyOne) {
  GuidedScene made = test::twoRooms();
  made.guides.portals.push_back({{9.9f, 1, 3}, {-1, 0, 0}, {0, 0, 0.5f}, {0, 1, 0}});
  ExploreScene scene(std::move(made));
  Explorer explorer(scene, test::smallPictures());
  explorer.jumpTo({{2, 1.6, 1}, 40, 0});
  explorer.choose("portal");
  rest(explorer);
  ExplorePick pick;
  pick.portal = scene.guides().portals[0];
  ASSERT_TRUE(explorer.pick(pick));
  rest(explorer);
  ASSERT_TRUE(explorer.picked());
  EXPECT_NEAR(explorer.picked()->center().z, -3, 1e-6);
  ASSERT_TRUE(explorer.pick(pick));
  rest(explorer);
  EXPECT_FALSE(explorer.picked()) << "a second click chooses all again";
}

TEST(Explorer, saysWhereAPortalLeadsNowhere) {
  GuidedScene made = test::hall();
  made.guides.portals = {{{0, 1, -9.99f}, {0, 0, 1}, {0.5f, 0, 0}, {0, 1, 0}}};
  ExploreScene scene(std::move(made));
  Explorer explorer(scene, test::smallPictures());
  explorer.jumpTo({{2, 1.6, 1}, 0, 0});
  explorer.choose("portal");
  ExplorePick pick;
  pick.portal = scene.guides().portals[0];
  ASSERT_TRUE(explorer.pick(pick));
  rest(explorer);
  EXPECT_THAT(notesOf(explorer), HasSubstr("leads nowhere"));
}

TEST(Explorer, tracksATargetAndSaysSo) {
  ExploreScene scene(test::hiddenBox());
  Explorer explorer(scene, test::smallPictures());
  explorer.jumpTo({{0, 1.6, 4}, 0, 0});
  explorer.choose("target");
  rest(explorer);
  EXPECT_THAT(notesOf(explorer), HasSubstr("click an object"));
  ASSERT_TRUE(explorer.pick(ExplorePick{{0, 1, -7}, 2, true, false, {}, {}}));
  rest(explorer);
  for (int i = 0; i < 60; ++i) {
    explorer.advance({}, test::kExploreFrame);
  }
  EXPECT_THAT(notesOf(explorer), HasSubstr("rays bend by"));
  const auto& camera = std::get<CurvedRayCamera>(explorer.frame().camera);
  ASSERT_EQ(camera.bends().size(), 1u);
  // Half of its box counts as in sight. Of its front, that much is seen.
  int seen = 0;
  for (int i = 0; i < 25; ++i) {
    const glm::vec3 point = glm::vec3(-0.28f, 0.55f, -6.7f) + glm::vec3(i % 5, i / 5, 0) * glm::vec3(0.14f, 0.3f, 0);
    const std::optional<ImagePoint> image = camera.project(point);
    const std::optional<ExplorePick> met = image ? explorer.probe({image->u, image->v}) : std::nullopt;
    seen += met && met->object == 2 ? 1 : 0;
  }
  EXPECT_GE(seen, 10);
}

TEST(Explorer, saysWhereNoBendShowsATarget) {
  GuidedScene made = test::hall();
  test::addBox(made, {{-9.5f, 0, -4.5f}, {9.5f, 3, -4}}, 1, {0.2f, 0.3f, 0.8f});
  test::addBox(made, {{-0.3f, 0.5f, -7.3f}, {0.3f, 1.8f, -6.7f}}, 2, {0.8f, 0.1f, 0.1f});
  ExploreScene scene(std::move(made));
  Explorer explorer(scene, test::smallPictures());
  explorer.jumpTo({{0, 1.6, 4}, 0, 0});
  explorer.choose("target");
  ASSERT_TRUE(explorer.pick(ExplorePick{{0, 1, -7}, 2, true, false, {}, {}}));
  rest(explorer);
  EXPECT_THAT(notesOf(explorer), HasSubstr("target hidden: no bend shows it"));
}

TEST(Explorer, theSceneGoesOnWhereAConstructorCannot) {
  ExploreScene scene(test::hall());
  Explorer explorer(scene, test::smallPictures());
  for (const char* name : {"path", "drawn", "maze", "comprehensive", "portal"}) {
    explorer.choose(name);
    explorer.advance({}, test::kExploreFrame);
    rest(explorer);
    const double before = explorer.walker().view().eye.z;
    WalkInput back;
    back.forward = explorer.walker().view().eye.z > 0 ? 1 : -1;
    explorer.jumpTo({{0, 1.6, 0}, 0, 0});
    explorer.advance(back, test::kExploreFrame);
    EXPECT_NE(explorer.walker().view().eye.z, before);
    EXPECT_EQ(frustaOf(explorer), 1u) << name << " shows the pinhole";
    EXPECT_EQ(explorer.frame().notes.front().kind, ExploreNote::Kind::kProblem) << name << ": " << notesOf(explorer);
  }
  explorer.choose("occluder");
  rest(explorer);
  EXPECT_THAT(notesOf(explorer), HasSubstr("click an object"));
}

/// Cannot bend its rays by more than half, unless the eye is to the right of x = 2.
class HalfConstructor final : public LiveConstructor {
 public:
  LiveCamera camera(const LiveMoment& moment) override {
    if (moment.deployed > 0.5 && moment.walker.eye.x < 2) {
      throw InputError("its rays cannot turn so far", "half camera", "go to the right");
    }
    return {GraphCamera(moment.view)};
  }
};

TEST(Explorer, aCameraThatFailsWhileItDeploysSettlesAndSaysWhy) {
  const LiveConstructorRow row{
      "half", "", "", {}, true, [](const ExploreScene&) { return std::make_unique<HalfConstructor>(); }, nullptr};
  ExploreScene scene(test::hall());
  Explorer explorer(scene, test::smallPictures());
  explorer.jumpTo({{0, 1.6, 0}, 0, 0});
  explorer.choose(row);
  rest(explorer);
  for (int i = 0; i < kMaxFrames; ++i) {
    explorer.advance({}, test::kExploreFrame);
    ASSERT_EQ(explorer.frame().deployed, 0) << "frame " << i;
    ASSERT_TRUE(explorer.atRest()) << "frame " << i;
    ASSERT_EQ(explorer.frame().notes.front().kind, ExploreNote::Kind::kProblem) << notesOf(explorer);
    ASSERT_THAT(notesOf(explorer), HasSubstr("its rays cannot turn so far"));
  }
  // Where they can, it deploys again.
  explorer.jumpTo({{3, 1.6, 0}, 0, 0});
  rest(explorer);
  EXPECT_EQ(explorer.frame().deployed, 1);
  EXPECT_THAT(notesOf(explorer), Not(HasSubstr("its rays cannot turn so far")));
}

TEST(Explorer, saysWhereThereIsNoFloor) {
  GuidedScene made;
  test::addBox(made, {{-3, -3, -3}, {3, 3, 3}}, 1, glm::vec3(0.5f));
  ExploreScene scene(std::move(made));
  Explorer explorer(scene, test::smallPictures());
  explorer.jumpTo({{0, 1, 9}, 0, 0});
  explorer.advance({}, test::kExploreFrame);
  EXPECT_THAT(notesOf(explorer), HasSubstr("no floor here"));
}

TEST(Explorer, followsThePath) {
  ExploreScene scene(test::hallWithPath());
  Explorer explorer(scene, test::smallPictures());
  explorer.jumpTo({{-5, 1.6, 3}, 70, 0});
  explorer.choose("path");
  rest(explorer);
  EXPECT_NEAR(explorer.walker().view().eye.x, -7, 0.1) << "the nearest place of the path";
  // The arcs of the path are chords of 1 m: the nearest place is on the first of them.
  EXPECT_NEAR(explorer.walker().view().eye.z, 3, 0.5);
  const double begin = explorer.walker().view().eye.z;
  WalkInput forward;
  forward.forward = 1;
  for (int i = 0; i < 60; ++i) {
    explorer.advance(forward, test::kExploreFrame);
  }
  // On the first arc, whose middle is at (-2, 3).
  const glm::dvec3 eye = explorer.walker().view().eye;
  EXPECT_NEAR(std::hypot(eye.x + 2, eye.z - 3), 5, 0.05);
  EXPECT_NEAR(5 * std::atan2(3 - eye.z, -2 - eye.x), 3 - begin + 2 * explorer.walker().options().speed, 0.1);
  EXPECT_GT(std::get<CurvedRayCamera>(explorer.frame().camera).bends().size(), 0u);
}

TEST(Explorer, leadsOnAlongThePathFromWhereOneGoes) {
  ExploreScene scene(test::hallWithPath());
  Explorer explorer(scene, test::smallPictures());
  explorer.jumpTo({{-5, 1.6, 3}, 70, 0});
  explorer.choose("path");
  rest(explorer);
  const glm::dvec3 begin = explorer.walker().view().eye;
  // As the plan and Home do, and as scripts do.
  explorer.glideTo({{5, 1.6, -3}, 0, 0});
  rest(explorer);
  const glm::dvec3 glided = explorer.walker().view().eye;
  EXPECT_GT(glm::distance(glided, begin), 3);
  explorer.jumpTo({{-5, 1.6, 3}, 70, 0});
  EXPECT_FALSE(explorer.atRest());
  rest(explorer);
  EXPECT_LT(glm::distance(explorer.walker().view().eye, begin), 0.1);
}

TEST(Explorer, theLastValueOfAnOptionThatWaitsCounts) {
  ExploreScene scene(test::hallWithPath());
  Explorer explorer(scene, test::smallPictures());
  explorer.choose("path");
  rest(explorer);
  const double usual = explorer.option("turns");
  for (const double last : {usual, usual + 2}) {
    explorer.setOption("turns", usual + 1);
    explorer.advance({}, test::kExploreFrame);
    explorer.setOption("turns", last);
    EXPECT_EQ(explorer.option("turns"), last);
    rest(explorer);
    EXPECT_EQ(explorer.option("turns"), last);
  }
}

TEST(ExploreScene, closesWhileTheSearchForWaysRuns) {
  std::atomic<bool> hasBegun = false;
  std::atomic<bool> hasEnded = false;
  ExploreSceneOptions options;
  options.findWays = [&](const Mesh&, double, const Progress& progress) {
    // Ends by itself after a while, so that the test fails rather than hangs.
    for (int i = 0; i < 2000; ++i) {
      progress("a search", 0.5);
      hasBegun = true;
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    hasEnded = true;
    return WalkMap();
  };
  {
    ExploreScene scene(test::hall(), options);
    scene.searchWays();
    while (!hasBegun) {
      std::this_thread::yield();
    }
  }
  EXPECT_FALSE(hasEnded);
}

TEST(ExploreScene, aSearchThatThrowsAnythingHasFailed) {
  ExploreSceneOptions options;
  options.findWays = [](const Mesh&, double, const Progress&) -> WalkMap { throw 3; };
  ExploreScene scene(test::hall(), options);
  scene.waitForWays();
  EXPECT_EQ(scene.waysStatus().state, WalkMapStatus::State::kFailed);
  EXPECT_NE(scene.waysStatus().problem, "");
}

TEST(Explorer, mazeCamerasWithAllSharesAtZeroHaveEqualOnes) {
  SceneOptions unfitted;
  unfitted.fit = false;
  ExploreScene scene(loadGuidedScene("builtin:maze,seed=5", unfitted));
  Explorer explorer(scene, test::smallPictures());
  explorer.choose("maze");
  rest(explorer);
  size_t parted = 1;  // frusta where rays part
  for (const WalkCell& cell : scene.walkMap()->cells) {
    explorer.jumpTo({glm::dvec3(cell.center) + glm::dvec3(0, 1.6, 0), headingDegreesOf(cell.axis), 0});
    rest(explorer);
    parted = frustaOf(explorer);
    if (parted > 2) {
      break;
    }
  }
  ASSERT_GT(parted, 2u);
  for (const char* side : {"left", "ahead", "right"}) {
    explorer.setOption(side, 0);
  }
  rest(explorer);
  EXPECT_EQ(frustaOf(explorer), parted);
}

TEST(Explorer, aConstructorSaysAnewWhereItBeginsAfterAJump) {
  ExploreScene scene(test::hallWithPath());
  Explorer explorer(scene, test::smallPictures());
  explorer.choose("path");
  rest(explorer);
  const WalkerView onPath = explorer.walker().view();
  explorer.jumpTo({onPath.eye + glm::dvec3(1, 0, 1), onPath.headingDegrees + 50, 20});
  EXPECT_FALSE(explorer.atRest());
  rest(explorer);
  EXPECT_LT(glm::distance(explorer.walker().view().eye, onPath.eye), 1.2);
  EXPECT_NEAR(explorer.walker().view().pitchDegrees, onPath.pitchDegrees, 1e-6);
}

TEST(ExploreScene, guessesMetresAsTheSearchForWaysDoes) {
  const GuidedScene hall = test::hall();
  EXPECT_EQ(ExploreScene(hall).metre(), metreOf("", hall).units);
  GuidedScene tiny = test::hall();
  for (glm::vec3& position : tiny.mesh.positions) {
    position *= 0.01f;
  }
  EXPECT_NEAR(ExploreScene(tiny).metre(), 0.01, 1e-6);  // 20 m long, as it was
}

// Section 4.3.1.4: "in front (right panel) and behind (left panel) the user".
TEST(Explorer, theMazeCameraShowsWhatIsBehindAtTheLeft) {
  SceneOptions unfitted;
  unfitted.fit = false;
  ExploreScene scene(loadGuidedScene("builtin:maze,seed=5", unfitted));
  Explorer explorer(scene, {.width = 320, .height = 180});
  explorer.choose("maze");
  rest(explorer);
  const ExploreFrame& frame = explorer.frame();
  ASSERT_TRUE(frame.behind);
  EXPECT_EQ(widthOf(*frame.behind), 160);
  EXPECT_EQ(heightOf(*frame.behind), 180);
  EXPECT_EQ(widthOf(frame.camera), 160);
  EXPECT_EQ(spotOf(frame, {10, 90}).camera, &*frame.behind);
  EXPECT_EQ(spotOf(frame, {310, 90}).camera, &frame.camera);
}

TEST(Explorer, whatIsBehindSlidesInEvenly) {
  SceneOptions unfitted;
  unfitted.fit = false;
  ExploreScene scene(loadGuidedScene("builtin:maze,seed=5", unfitted));
  const ExplorerOptions options{.width = 1280, .height = 720};
  Explorer explorer(scene, options);
  explorer.choose("maze");
  const auto widthBehind = [&] { return explorer.frame().behind ? widthOf(*explorer.frame().behind) : 0; };
  int before = 0;
  int widest = 0;
  int frames = 0;
  for (int i = 0; i < kMaxFrames && explorer.frame().deployed < 1; ++i) {
    explorer.advance({}, test::kExploreFrame);
    frames += explorer.frame().deployed > 0 ? 1 : 0;
    EXPECT_GE(widthBehind(), before);
    widest = std::max(widest, widthBehind() - before);
    before = widthBehind();
  }
  ASSERT_EQ(before, 640);
  // A pixel of rounding, and what the beginning and the end are slower. Were it eased all the way, it would be 1.5.
  EXPECT_LE(widest, 1.2 * 640 / frames + 1);
}

// The image behind begins a few pixels wide, so the middle of its rays begins above the ceiling of the tunnel.
TEST(Explorer, mazeCamerasComeToRestWhileTheImageBehindIsNarrow) {
  SceneOptions unfitted;
  unfitted.fit = false;
  ExploreScene scene(loadGuidedScene("builtin:maze,seed=2", unfitted));
  Explorer explorer(scene, {.width = 640, .height = 360});
  explorer.choose("maze");
  rest(explorer);
  EXPECT_EQ(explorer.frame().deployed, 1);
  EXPECT_TRUE(explorer.frame().behind);
}

// Section 4.3.1.4: at a crossing the maze camera turns in four steps, into the way that one wants.
TEST(Explorer, turnsAtACrossingInFourSteps) {
  SceneOptions unfitted;
  unfitted.fit = false;
  ExploreScene scene(loadGuidedScene("builtin:maze,seed=5", unfitted));
  Explorer explorer(scene, test::smallPictures());
  explorer.choose("maze");
  rest(explorer);
  // From the middle of the first tunnel before a crossing with a way to the right.
  WalkInput right;
  right.turnRight = 1;
  WalkerView before;
  const auto turns = [&](const WalkCell& cell, const glm::vec3& axis) {
    before = {glm::dvec3(cell.center) + glm::dvec3(0, 1.6, 0), headingDegreesOf(axis), 0};
    explorer.jumpTo(before);
    explorer.advance({}, test::kExploreFrame);
    explorer.advance(right, test::kExploreFrame);
    return notesOf(explorer).find("turning: step 1 of 4") != std::string::npos;
  };
  const std::vector<WalkCell>& cells = scene.walkMap()->cells;
  ASSERT_TRUE(std::any_of(cells.begin(), cells.end(), [&](const WalkCell& cell) {
    return cell.kind == WalkCellKind::kTunnel && (turns(cell, cell.axis) || turns(cell, -cell.axis));
  }));
  std::string steps;
  for (int i = 0; i < kMaxFrames && !explorer.atRest(); ++i) {
    explorer.advance({}, test::kExploreFrame);
    steps += notesOf(explorer);
  }
  for (const char* step : {"step 2", "step 3", "step 4"}) {
    EXPECT_THAT(steps, HasSubstr(step));
  }
  EXPECT_NEAR(glm::dot(headingOf(explorer.walker().view()), headingOf({{}, before.headingDegrees + 90, 0})), 1, 1e-9)
      << "from " << before.eye.x << ", " << before.eye.z << ", heading " << before.headingDegrees;
  EXPECT_GT(glm::distance(explorer.walker().view().eye, before.eye), 1);
  EXPECT_THAT(notesOf(explorer), Not(HasSubstr("turning")));
}

TEST(Explorer, aCameraOfAnotherSceneIsAState) {
  ExploreScene scene(test::hall());
  Explorer explorer(scene, test::smallPictures());
  View far;
  far.eye = {500, 2, 0};
  far.target = {600, 2, 0};
  far.fovVerticalDegrees = 40;
  explorer.showDrawn(GraphCamera(PinholeCamera(far, 160, 90)), "far.json");
  rest(explorer);
  EXPECT_THAT(notesOf(explorer), HasSubstr("may be of another scene"));
  View up = far;
  up.eye = {0, 1.6f, 0};
  up.target = {0, 50, 0.1f};
  explorer.showDrawn(GraphCamera(PinholeCamera(up, 160, 90)), "up.json");
  rest(explorer);
  EXPECT_THAT(notesOf(explorer), HasSubstr("sees nothing here"));
  View good = up;
  good.target = {0, 1, -5};
  explorer.showDrawn(GraphCamera(PinholeCamera(good, 160, 90)), "good.json");
  rest(explorer);
  EXPECT_THAT(notesOf(explorer), HasSubstr("good.json"));
}

// The same script, the same frames: whatever the number of threads.
TEST(Explorer, framesDependOnNothingElse) {
  std::vector<Image<Rgb8>> first;
  for (const int threads : {1, 2, 4}) {
    setThreadCount(threads);
    ExploreScene scene(test::twoRooms());
    Explorer explorer(scene, test::smallPictures());
    ExploreRenderer renderer(scene);
    explorer.jumpTo({{6, 1.6, 0.5}, -55, 0});
    explorer.choose("portal");
    std::vector<Image<Rgb8>> pictures;
    WalkInput input;
    input.forward = 0.6;
    input.turnRight = -0.3;
    for (int i = 0; i < 90; ++i) {
      explorer.advance(input, test::kExploreFrame);
      if (i % 15 == 0) {
        pictures.push_back(renderer.draw(explorer.frame()).image);
      }
    }
    if (first.empty()) {
      first = pictures;
    }
    EXPECT_EQ(pictures, first) << threads << " threads";
  }
  setThreadCount(0);
}

TEST(Explorer, resizes) {
  ExploreScene scene(test::twoRooms());
  Explorer explorer(scene, test::smallPictures());
  explorer.resize(100, 80);
  EXPECT_EQ(explorer.frame().pinhole.width(), 100);
  EXPECT_EQ(explorer.frame().pinhole.height(), 80);
  EXPECT_THROW(explorer.resize(0, 80), InputError);
  EXPECT_EQ(explorer.frame().pinhole.width(), 100);
}

}  // namespace
}  // namespace ocelli
