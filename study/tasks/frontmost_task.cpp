// Which of two is in front: two objects stand ahead, one of which covers a part of the other, and one says which. It
// asks how solid things look: where things shine through one another, as on a display that hides nothing, what is
// covered does not tell. Both objects float, so that no floor tells how far away they are.
//
// Not of the source, which judges by photographs whether images of a display look solid (section 3.5.5.6): a measure of
// that from people which has a right answer.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "oc_core/base/check.h"
#include "oc_core/base/json_fields.h"
#include "oc_core/worlds/landmark_solids.h"
#include "oc_core/worlds/maze_file.h"
#include "study/task/eye_camera.h"
#include "study/task/task_fields.h"
#include "study/task/task_layout.h"
#include "study/task/trial_image.h"
#include "study/tasks/frontmost_policy.h"
#include "study/tasks/task_registry.h"
#include "study/tasks/two_sides.h"

namespace ocelli {
namespace {

constexpr double kTypicalFrontSeconds = 4;
constexpr double kMaxAheadMeters = 60;
/// What a case is tried on when it is read, through the pinhole at the start.
constexpr TrialScreen kFrontTrialScreen{640, 400, 60};
constexpr size_t kMinFrontPixels = 100;
/// Of the pixels of the object behind, the part that the other one covers.
constexpr double kMinCoveredShare = 0.05;
constexpr double kMaxCoveredShare = 0.7;
/// Of the pixels of the object in front, that must show.
constexpr double kMinShownShare = 0.98;

/// Where the middle of an object is, from the eye at the start.
struct FrontObject {
  ObjectLook look{};
  double ahead = 0;  ///< metres, as those below
  double right = 0;
  double up = 0;
};

struct FrontCase {
  std::string label;
  std::array<FrontObject, 2> objects;  ///< by Side
};

struct FrontOptions {
  double answerLimitSeconds = 20;
  WalkerPose start{};
  MazeCell startCell{};
  EyeCameraOptions camera{};
};

/// A case as it is shown: objects of a scene, moved to where they float.
struct FrontScene {
  std::shared_ptr<const StudyScene> scene;
  std::vector<glm::vec3> offsets;
  std::array<Box, 2> boxes;  ///< where the objects are
  std::array<double, 2> distances{};
  double coveredShare = 0;  ///< of the object behind, by the pinhole

  Side front() const { return distances[kLeftSide] < distances[kRightSide] ? kLeftSide : kRightSide; }
};

class FrontBlock : public TaskBlock {
 public:
  FrontBlock(const Maze& maze, const TaskSetting& setting, const FrontOptions& options)
      : maze_(maze),
        controls_(setting.controls),
        conditions_(setting.conditions),
        options_(options),
        camera_(maze, setting.controls, options.camera, setting.conditions) {}

  /// Throws InputError, saying `where`, for a case without a right answer, and for one that a condition cannot show.
  void add(const FrontCase& of, const std::string& where);

  int caseCount() const override { return static_cast<int>(cases_.size()); }
  CaseInfo caseInfo(int caseIndex) const override {
    CaseInfo info;
    info.label = cases_.at(static_cast<size_t>(caseIndex)).label;
    info.objects = 2;
    info.longestSeconds = options_.answerLimitSeconds;
    info.typicalSeconds = std::min(kTypicalFrontSeconds, options_.answerLimitSeconds);
    return info;
  }
  bool isStill() const override { return true; }
  std::string answerOf(const TrialPlan& plan) const override { return kSideNames[sceneOf(plan.caseIndex).front()]; }
  int choiceCount() const override { return static_cast<int>(kSideNames.size()); }
  std::unique_ptr<TrialRun> start(const TrialPlan& plan, const TrialScreen& screen) const override;

  const FrontScene& sceneOf(int index) const {
    OC_CHECK(index >= 0 && index < caseCount(), "a trial is of a case of its block");
    return scenes_[static_cast<size_t>(index)];
  }
  /// All but choices and prompt.
  TrialLayout layoutOf(int caseIndex, TrialView view, const TwoSidesStage& stage) const {
    TrialLayout layout;
    layout.scene = sceneOf(caseIndex).scene.get();
    layout.objectOffsets = sceneOf(caseIndex).offsets;
    layout.views = camera_.views(options_.start, view, stage.view);
    return layout;
  }

 private:
  FrontScene makeScene(const FrontCase& of, const PinholeCamera& eye) const;
  void checkPlaces(const FrontScene& scene, const PinholeCamera& eye, const std::string& where) const;
  void checkImage(FrontScene& scene, const PinholeCamera& eye, const std::string& where) const;

  Maze maze_;
  Controls controls_;
  StudyConditions conditions_;
  FrontOptions options_;
  EyeCamera camera_;
  std::vector<FrontCase> cases_{};
  std::vector<FrontScene> scenes_{};
};

FrontScene FrontBlock::makeScene(const FrontCase& of, const PinholeCamera& eye) const {
  Maze maze = maze_;
  maze.landmarks.clear();
  for (const FrontObject& object : of.objects) {
    maze.landmarks.push_back({options_.startCell, object.look.shape, object.look.color});
  }
  FrontScene made;
  made.scene = std::make_shared<const StudyScene>(maze);
  for (size_t side = 0; side < of.objects.size(); ++side) {
    const FrontObject& object = of.objects[side];
    const glm::vec3 place =
        eye.eye() + glm::vec3(object.ahead * glm::dvec3(eye.forward()) + object.right * glm::dvec3(eye.right()) -
                              object.up * glm::dvec3(eye.down()));
    const Box& box = made.scene->boxOf(side);
    made.offsets.push_back(place - box.center());
    made.boxes[side] = {box.lower + made.offsets[side], box.upper + made.offsets[side]};
    made.distances[side] = std::hypot(object.ahead, object.right, object.up);
  }
  return made;
}

void FrontBlock::checkPlaces(const FrontScene& scene, const PinholeCamera& eye, const std::string& where) const {
  std::array<std::array<double, 2>, 2> ahead{};  // from where to where, by Side
  for (const Side side : kBothSides) {
    const auto corners = cornersOf(scene.boxes[side]);
    const auto isStuck = [&](const glm::vec3& corner) {
      return corner.y < maze_.origin.y || maze_.isInWall(corner) || !maze_.cellAt(corner);
    };
    if (std::any_of(corners.begin(), corners.end(), isStuck)) {
      throw InputError(
          fmt::format("the {} object reaches into a wall or the floor, or out of the maze", kSideNames[side]), where,
          "change its place, or take a maze with a larger hall");
    }
    ahead[side] = {1e30, -1e30};
    for (const glm::vec3& corner : corners) {
      const double distance = glm::dot(glm::dvec3(corner - eye.eye()), glm::dvec3(eye.forward()));
      ahead[side] = {std::min(ahead[side][0], distance), std::max(ahead[side][1], distance)};
    }
    for (const TrialView view : conditions_.names.all()) {
      if (!conditions_.views[indexOfCondition(view)]->reaches(eye, scene.boxes[side])) {
        throw InputError(
            fmt::format("the view {} does not reach the {} object", conditions_.names.nameOf(view), kSideNames[side]),
            where, "bring it nearer to the middle of the display, or change \"radius_meters\" of the view");
      }
    }
  }
  const Side front = scene.front();
  const Side behind = otherSide(front);
  if (ahead[front][1] >= ahead[behind][0]) {
    throw InputError(
        fmt::format("the {} object is from {:.2f} to {:.2f} m ahead and the {} one from {:.2f} m: neither is "
                    "wholly in front",
                    kSideNames[front], ahead[front][0], ahead[front][1], kSideNames[behind], ahead[behind][0]),
        where, "let their \"ahead_meters\" differ by more than they are thick");
  }
}

/// By images of each object alone, and of both in the maze.
void FrontBlock::checkImage(FrontScene& scene, const PinholeCamera& eye, const std::string& where) const {
  TrialLayout layout;
  layout.scene = scene.scene.get();
  layout.objectOffsets = scene.offsets;
  const Mesh mesh = meshOf(layout);
  const std::vector<uint32_t>& objects = scene.scene->objectOfTriangle();
  const FragmentImage all = rasterizeStudy(eye, mesh);
  std::array<size_t, 2> alone{};
  std::array<size_t, 2> shown{};
  std::array<double, 2> middle{};
  for (const Side side : kBothSides) {
    Mesh part = mesh;
    part.triangles.clear();
    for (size_t i = 0; i < objects.size(); ++i) {
      if (objects[i] == side + 1) {
        part.triangles.push_back(mesh.triangles[i]);
      }
    }
    const FragmentImage only = rasterizeStudy(eye, part);
    bool atBorder = false;
    for (int y = 0; y < only.height(); ++y) {
      for (int x = 0; x < only.width(); ++x) {
        if (only(x, y).covered()) {
          ++alone[side];
          middle[side] += x;
          atBorder |= x == 0 || y == 0 || x + 1 == only.width() || y + 1 == only.height();
          shown[side] += all(x, y).covered() && objects[all(x, y).triangle] == side + 1 ? 1 : 0;
        }
      }
    }
    if (alone[side] < kMinFrontPixels || atBorder) {
      throw InputError(
          fmt::format("the {} object has {} pixels in a pinhole's image of {} x {}{}", kSideNames[side], alone[side],
                      only.width(), only.height(), atBorder ? ", and the border cuts it off" : ""),
          where, "change its place, or \"fov_horizontal_degrees\" of the block");
    }
    middle[side] /= static_cast<double>(alone[side]);
  }
  const Side front = scene.front();
  const Side behind = otherSide(front);
  const auto shareOf = [&](Side side) { return static_cast<double>(shown[side]) / static_cast<double>(alone[side]); };
  if (shareOf(front) < kMinShownShare) {
    throw InputError(fmt::format("{:.0f} % of the object in front show: a wall hides it", 100 * shareOf(front)), where,
                     "change its place, \"start\" or the maze");
  }
  scene.coveredShare = 1 - shareOf(behind);
  if (scene.coveredShare < kMinCoveredShare || scene.coveredShare > kMaxCoveredShare) {
    throw InputError(fmt::format("{:.0f} % of the object behind are covered: between {:.0f} and {:.0f} % must be",
                                 100 * scene.coveredShare, 100 * kMinCoveredShare, 100 * kMaxCoveredShare),
                     where, "change \"right_meters\" of the objects");
  }
  if (middle[kLeftSide] >= middle[kRightSide]) {
    throw InputError("the left object is not to the left of the right one", where, "change their \"right_meters\"");
  }
}

void FrontBlock::add(const FrontCase& of, const std::string& where) {
  const TwoSidesStage stage(kFrontTrialScreen);
  const PinholeCamera eye = camera_.pinhole(options_.start, sizeOf(stage.view));
  if (of.objects[kLeftSide].look.color == of.objects[kRightSide].look.color) {
    throw InputError(fmt::format("both objects are {}", nameOf(of.objects[kLeftSide].look.color)), where,
                     "give them two colours, so that one can tell them apart where they overlap");
  }
  FrontScene scene = makeScene(of, eye);
  checkPlaces(scene, eye, where);
  checkImage(scene, eye, where);
  cases_.push_back(of);
  scenes_.push_back(std::move(scene));
}

std::unique_ptr<TrialRun> FrontBlock::start(const TrialPlan& plan, const TrialScreen& screen) const {
  const FrontScene& scene = sceneOf(plan.caseIndex);
  // The pointer begins in the middle, where the two overlap.
  TwoSidesTrial trial{layoutOf(plan.caseIndex, plan.view, TwoSidesStage(screen)),
                      scene.front(),
                      options_.answerLimitSeconds,
                      {{"left_distance_m", scene.distances[kLeftSide]},
                       {"right_distance_m", scene.distances[kRightSide]},
                       {"covered_share", scene.coveredShare}},
                      options_.start,
                      false};
  trial.layout.prompt = "Which of the two is in front?";
  return std::make_unique<TwoSidesRun>(std::move(trial), screen, controls_);
}

FrontObject readFrontObject(JsonFields& fields, Side side, const ObjectLook& usual) {
  constexpr std::array kUsualColors{LandmarkColor::kOrange, LandmarkColor::kSkyBlue};
  JsonFields of = fields.inner(kSideNames[side]);
  FrontObject object;
  object.look = {of.choiceOf("shape", kLandmarkShapes, usual.shape),
                 of.choiceOf("color", kLandmarkColors, kUsualColors[side])};
  if (object.look.shape == LandmarkShape::kArch) {
    of.fail("shape", "is \"arch\", which spans a passage");
  }
  object.ahead = of.number("ahead_meters", 0.1, kMaxAheadMeters);
  object.right = of.number("right_meters", -kMaxAheadMeters, kMaxAheadMeters);
  object.up = of.number("up_meters", -kMaxAheadMeters, kMaxAheadMeters, 0);
  of.rejectUnknown();
  return object;
}

std::shared_ptr<const TaskBlock> readFrontTask(JsonFields& fields, const std::string& caseField,
                                               const TaskSetting& setting) {
  const Maze& maze = readMazeOf(fields, setting);
  FrontOptions options;
  options.answerLimitSeconds = fields.number("answer_limit_seconds", 1, 3600, options.answerLimitSeconds);
  options.start = readStart(fields, maze);
  options.startCell =
      *maze.cellAt({static_cast<float>(options.start.x), maze.origin.y, static_cast<float>(options.start.z)});
  options.camera = readEyeCameraOptions(fields);
  const ObjectLook look = readObjectLook(fields, false);
  auto block = std::make_shared<FrontBlock>(maze, setting, options);
  readCases(fields, caseField, [&](JsonFields& each, const std::string& label) {
    const FrontCase of{label, {readFrontObject(each, kLeftSide, look), readFrontObject(each, kRightSide, look)}};
    block->add(of, each.where());
  });
  return block;
}

/// A ball before a cube, in a hall.
InstructionExample frontExample(const glm::ivec2& size) {
  Maze maze = mazeFromJsonText(R"({"plan": [
    "+-+-+-+-+",
    "|       |",
    "+ +-+-+-+"]})",
                               "an example");
  maze.landmarks = {{{0, 2}, LandmarkShape::kSphere, LandmarkColor::kOrange, -0.2f, -0.06f},
                    {{0, 2}, LandmarkShape::kCube, LandmarkColor::kSkyBlue, 0.25f, 0.12f}};
  InstructionExample example{std::make_shared<StudyScene>(maze), {}};
  example.layout.scene = example.scene.get();
  example.layout.views.emplace_back(wholeImage(size), exampleEye(maze, {0, 0}, Direction::kEast, 0, size));
  return example;
}

std::unique_ptr<TaskPolicy> frontPolicy(const PolicySetting& setting) {
  return std::make_unique<FrontPolicy>(setting.vision, setting.seed);
}

}  // namespace

TaskKind frontmostTask() {
  return {.name = "frontmost",
          .description = "say which of two objects is in front of the other, the left one or the right one",
          .outcome = OutcomeKind::kAnswer,
          .read = readFrontTask,
          .policy = frontPolicy,
          .generator = {.effects = {{"right", 1, "logit of a right answer with the reference in the first session",
                                     levelCovariate},
                                    {kGraphEffect, 0.5, "a condition that is not the reference", graphCovariate},
                                    {"session", 0.1, "each further session", sessionCovariate},
                                    {kSubjectSd, 0.5, "between subjects"},
                                    {kItemSd, 0.4, "between cases"},
                                    {kItemViewSd, 0, "between cases in the effect of the view"}},
                        .wrongAnswer = otherSideName},
          .images = {{"frontmost_pair", true, frontExample}}};
}

}  // namespace ocelli
