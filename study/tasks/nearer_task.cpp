// Which of two is nearer: two objects that look alike stand in sight, one to the left of the other in the image, and
// one says which of them is nearer to where one stands. Nobody walks. It asks how well distances can be judged in the
// views of a camera whose rays bend.
//
// Not of the source: the smallest task that uses all of a row. The answer is that of straight lines on the floor.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "oc_core/base/check.h"
#include "oc_core/base/json_fields.h"
#include "oc_core/base/random.h"
#include "oc_core/render/identity_image.h"
#include "oc_core/worlds/maze_file.h"
#include "oc_core/worlds/maze_validate.h"
#include "study/task/eye_camera.h"
#include "study/task/task_fields.h"
#include "study/task/task_layout.h"
#include "study/task/trial_image.h"
#include "study/tasks/task_registry.h"
#include "study/tasks/two_sides.h"

namespace ocelli {
namespace {

constexpr double kTypicalNearerSeconds = 3;
/// Distances that differ by less have no right answer, metres.
constexpr double kMinDistanceDifference = 0.1;
/// What a case is tried on when it is read. Each object must show with so many pixels.
constexpr TrialScreen kNearerTrialScreen{640, 400, 60};
constexpr size_t kMinNearerPixels = 40;

struct NearerCase {
  std::string label;
  std::array<Landmark, 2> objects;  ///< by Side
};

/// A case with left and right swapped: mirrored across the line along which one looks.
NearerCase mirrorOf(const NearerCase& of, const Maze& maze, const WalkerPose& start, const std::string& where) {
  const glm::dvec2 ahead(std::sin(start.headingRadians), -std::cos(start.headingRadians));
  const glm::dvec2 from(start.x, start.z);
  const auto mirrored = [&](const Landmark& object) {
    const glm::vec3 middle = maze.centerOf(object.cell) + maze.cellSize * glm::vec3(object.east, 0, object.south);
    const glm::dvec2 way = glm::dvec2(middle.x, middle.z) - from;
    const glm::dvec2 place = from + 2 * glm::dot(way, ahead) * ahead - way;
    const std::optional<MazeCell> cell = maze.cellAt({place.x, 0, place.y});
    if (!cell) {
      throw InputError("the mirror image of an object lies outside of the maze", where,
                       "move it, or leave out \"mirrored\"");
    }
    const glm::vec3 center = maze.centerOf(*cell);
    Landmark image = object;
    image.cell = *cell;
    image.east = (static_cast<float>(place.x) - center.x) / maze.cellSize;
    image.south = (static_cast<float>(place.y) - center.z) / maze.cellSize;
    return image;
  };
  return {of.label, {mirrored(of.objects[kRightSide]), mirrored(of.objects[kLeftSide])}};
}

struct NearerOptions {
  double answerLimitSeconds = 20;
  WalkerPose start{};
  EyeCameraOptions camera{};
  bool mirrored = false;  ///< half of the trials, by their seeds, show the mirror image of their case
};

/// One scene shows all cases: its objects are moved to where they stand.
class NearerBlock : public TaskBlock {
 public:
  NearerBlock(const Maze& maze, const TaskSetting& setting, const NearerOptions& options, std::vector<NearerCase> cases,
              std::vector<NearerCase> mirrored)
      : maze_(maze),
        controls_(setting.controls),
        conditions_(setting.conditions.names),
        options_(options),
        cases_(std::move(cases)),
        mirrored_(std::move(mirrored)),
        camera_(maze, setting.controls, options.camera, setting.conditions),
        scene_(withObjects(maze, cases_.front())) {}

  int caseCount() const override { return static_cast<int>(cases_.size()); }
  CaseInfo caseInfo(int caseIndex) const override {
    CaseInfo info;
    info.label = caseOf(caseIndex).label;
    info.objects = 2;
    info.longestSeconds = options_.answerLimitSeconds;
    info.typicalSeconds = std::min(kTypicalNearerSeconds, options_.answerLimitSeconds);
    return info;
  }
  bool isStill() const override { return true; }
  std::string answerOf(const TrialPlan& plan) const override { return kSideNames[nearerSide(caseOf(plan))]; }
  int choiceCount() const override { return static_cast<int>(kSideNames.size()); }
  std::unique_ptr<TrialRun> start(const TrialPlan& plan, const TrialScreen& screen) const override;

  static Maze withObjects(Maze maze, const NearerCase& of) {
    maze.landmarks.assign(of.objects.begin(), of.objects.end());
    return maze;
  }

  const ViewConditions& conditions() const { return conditions_; }
  /// What a trial shows.
  const NearerCase& caseOf(const TrialPlan& plan) const {
    const bool isMirrored = options_.mirrored && (Random(plan.seed).next() & 1) != 0;
    return isMirrored ? mirrored_.at(static_cast<size_t>(plan.caseIndex)) : caseOf(plan.caseIndex);
  }
  /// Those of the protocol, and their mirror images where trials show these too.
  std::vector<NearerCase> shownCases() const {
    std::vector<NearerCase> shown = cases_;
    shown.insert(shown.end(), mirrored_.begin(), mirrored_.end());
    return shown;
  }
  /// Metres on the floor.
  double distanceTo(const NearerCase& of, Side side) const {
    return glm::distance(placeOf(of.objects[side]), {options_.start.x, options_.start.z});
  }
  Side nearerSide(const NearerCase& of) const {
    return distanceTo(of, kLeftSide) < distanceTo(of, kRightSide) ? kLeftSide : kRightSide;
  }
  /// All but choices and prompt.
  TrialLayout layoutOf(const NearerCase& of, TrialView view, const TwoSidesStage& stage) const {
    TrialLayout layout;
    layout.scene = &scene_;
    for (const Side side : kBothSides) {
      const glm::dvec2 by = placeOf(of.objects[side]) - placeOf(cases_.front().objects[side]);
      layout.objectOffsets.emplace_back(by.x, 0, by.y);
    }
    layout.views = camera_.views(options_.start, view, stage.view);
    return layout;
  }

 private:
  const NearerCase& caseOf(int index) const {
    OC_CHECK(index >= 0 && index < caseCount(), "a trial is of a case of its block");
    return cases_[static_cast<size_t>(index)];
  }
  /// (x, z).
  glm::dvec2 placeOf(const Landmark& object) const {
    const glm::vec3 place = maze_.centerOf(object.cell) + maze_.cellSize * glm::vec3(object.east, 0, object.south);
    return {static_cast<double>(place.x), static_cast<double>(place.z)};
  }

  Maze maze_;
  Controls controls_;
  ViewConditions conditions_;
  NearerOptions options_;
  std::vector<NearerCase> cases_;
  std::vector<NearerCase> mirrored_;  ///< of each case, where trials show them; else empty
  EyeCamera camera_;
  StudyScene scene_;
};

std::unique_ptr<TrialRun> NearerBlock::start(const TrialPlan& plan, const TrialScreen& screen) const {
  const NearerCase& of = caseOf(plan);
  TwoSidesTrial trial{
      layoutOf(of, plan.view, TwoSidesStage(screen)),
      nearerSide(of),
      options_.answerLimitSeconds,
      {{"left_distance_m", distanceTo(of, kLeftSide)}, {"right_distance_m", distanceTo(of, kRightSide)}},
      options_.start};
  trial.layout.prompt = "Which of the two is nearer to you?";
  return std::make_unique<TwoSidesRun>(std::move(trial), screen, controls_);
}

/// Throws unless the case has a right answer that each view can show: distances that differ, and both objects in the
/// image, one wholly to the left of the other.
void checkCase(const NearerBlock& block, const NearerCase& shown, const std::string& where) {
  const std::string of = fmt::format("{}, case \"{}\"", where, shown.label);
  const double difference = block.distanceTo(shown, kLeftSide) - block.distanceTo(shown, kRightSide);
  if (std::abs(difference) < kMinDistanceDifference) {
    throw InputError(fmt::format("the two objects are {:.2f} m and {:.2f} m away: neither is nearer",
                                 block.distanceTo(shown, kLeftSide), block.distanceTo(shown, kRightSide)),
                     of, fmt::format("let them differ by {:g} m or more", kMinDistanceDifference));
  }
  for (const TrialView view : block.conditions().all()) {
    const TrialLayout layout = block.layoutOf(shown, view, TwoSidesStage(kNearerTrialScreen));
    std::array<ObjectSighting, 2> seen{};  // by Side
    for (const ObjectSighting& each : sightings(objectsIn(layout, layout.views.front()))) {
      seen[each.object - 1] = each;
    }
    for (const Side side : kBothSides) {
      if (seen[side].pixels < kMinNearerPixels) {
        throw InputError(fmt::format("the view {} shows {} pixels of the {} object on a screen of {} x {}",
                                     block.conditions().nameOf(view), seen[side].pixels, kSideNames[side],
                                     kNearerTrialScreen.width, kNearerTrialScreen.height),
                         of, "move it to where both views show it, or change \"start\", \"portals\" or the maze");
      }
      if (seen[side].atBorder) {
        throw InputError(fmt::format("the border of the image of the view {} cuts off the {} object",
                                     block.conditions().nameOf(view), kSideNames[side]),
                         of, "move it farther away, or to the middle");
      }
    }
    if (seen[kLeftSide].upper.x >= seen[kRightSide].lower.x) {
      throw InputError(fmt::format("the view {} does not show the left object wholly to the left of the right one",
                                   block.conditions().nameOf(view)),
                       of, "change their \"east\" and \"south\", or which of them is \"left\"");
    }
  }
}

Landmark readObject(JsonFields& fields, const char* name, const Maze& maze, const ObjectLook& look) {
  JsonFields of = fields.inner(name);
  Landmark object;
  object.cell = readCell(of, maze);
  object.shape = look.shape;
  object.color = look.color;
  object.east = static_cast<float>(of.number("east", -0.5, 0.5, 0));
  object.south = static_cast<float>(of.number("south", -0.5, 0.5, 0));
  of.rejectUnknown();
  return object;
}

std::shared_ptr<const TaskBlock> readNearerTask(JsonFields& fields, const std::string& caseField,
                                                const TaskSetting& setting) {
  const Maze& maze = readMazeOf(fields, setting);
  NearerOptions options;
  options.answerLimitSeconds = fields.number("answer_limit_seconds", 1, 3600, options.answerLimitSeconds);
  options.start = readStart(fields, maze);
  options.camera = readEyeCameraOptions(fields);
  options.mirrored = fields.boolean("mirrored", options.mirrored);
  const ObjectLook look = readObjectLook(fields, true);
  std::vector<NearerCase> cases;
  std::vector<NearerCase> mirrored;
  readCases(fields, caseField, [&](JsonFields& each, const std::string& label) {
    const NearerCase of{
        label,
        {readObject(each, kSideNames[kLeftSide], maze, look), readObject(each, kSideNames[kRightSide], maze, look)}};
    validate(NearerBlock::withObjects(maze, of), each.where());
    cases.push_back(of);
    if (options.mirrored) {
      const std::string where = each.where() + ", mirrored";
      mirrored.push_back(mirrorOf(of, maze, options.start, where));
      validate(NearerBlock::withObjects(maze, mirrored.back()), where);
    }
  });
  auto block = std::make_shared<NearerBlock>(maze, setting, options, std::move(cases), std::move(mirrored));
  for (const NearerCase& shown : block->shownCases()) {
    checkCase(*block, shown, fields.where());
  }
  return block;
}

/// How a simulated observer does it: it looks at one object after the other and takes the taller one for the nearer, as
/// they look alike. It misjudges heights by a share that is a guess, and does not know of bent rays.
class NearerPolicy final : public TaskPolicy {
 public:
  NearerPolicy(const Vision& vision, uint64_t seed) : vision_(vision), random_(seed) {}

  bool wantsFloor() const override { return false; }
  double effort(double seconds) const override { return seconds; }

  double think(const Percept& seen, int64_t from, int64_t now, MotorModel& motor) override {
    if (seen.views.empty() || seen.choices.size() != judged_.size() || now < answersAgainAt_) {
      return 0;
    }
    if (!began_) {
      began_ = from;
      gaze_ = seen.views.front().center();
    }
    const std::array<const Sighting*, 2> objects = objectsOf(seen);
    for (const Side side : kBothSides) {
      const Sighting* object = objects[side];
      if (object != nullptr && vision_.degrees(object->centroid, gaze_) <= kJudgedDegrees) {
        judged_[side] = std::log(object->upper.y - object->lower.y) + normal(random_, 0, kHeightSpread);
      }
    }
    if ((judged_[kLeftSide] && judged_[kRightSide]) || secondsOf(now - *began_) > kMaxLookSeconds) {
      answer(seen, now, motor);
      return 0;
    }
    const Side next = judged_[kLeftSide] ? kRightSide : kLeftSide;
    // What does not stand out from here may do so from elsewhere: the middle of its side.
    const PixelRect& view = seen.views.front();
    const double side = next == kLeftSide ? -0.25 : 0.25;
    gaze_ = objects[next] != nullptr ? objects[next]->centroid : view.center() + glm::dvec2(side * view.width, 0);
    return 0;
  }

 private:
  static constexpr double kJudgedDegrees = 2;
  static constexpr double kHeightSpread = 0.06;  ///< of the logarithm of a height; a guess
  static constexpr double kMaxLookSeconds = 4;   ///< then it guesses
  static constexpr double kNearerAgainSeconds = 4;

  /// The two largest things that are noticed, by Side; with one alone, its side of the view tells which it is.
  std::array<const Sighting*, 2> objectsOf(const Percept& seen) const {
    std::vector<const Sighting*> noticed;
    for (const Sighting& each : seen.objects) {
      if (vision_.notices(each, gaze_)) {
        noticed.push_back(&each);
      }
    }
    std::stable_sort(noticed.begin(), noticed.end(),
                     [](const Sighting* a, const Sighting* b) { return a->pixels > b->pixels; });
    if (noticed.empty()) {
      return {};
    }
    if (noticed.size() == 1) {
      const bool isLeft = noticed.front()->centroid.x < seen.views.front().center().x;
      return isLeft ? std::array<const Sighting*, 2>{noticed.front(), nullptr}
                    : std::array<const Sighting*, 2>{nullptr, noticed.front()};
    }
    const bool inOrder = noticed[0]->centroid.x < noticed[1]->centroid.x;
    return {noticed[inOrder ? 0 : 1], noticed[inOrder ? 1 : 0]};
  }

  void answer(const Percept& seen, int64_t now, MotorModel& motor) {
    const HumanFactors& factors = vision_.factors();
    const bool isSure = judged_[kLeftSide] && judged_[kRightSide];
    const bool isLeft = isSure ? *judged_[kLeftSide] > *judged_[kRightSide] : happens(random_, 0.5);
    const bool slips = happens(random_, factors.slip);
    const Side pressed = isLeft != slips ? kLeftSide : kRightSide;
    motor.tap(seen.choices[pressed].key,
              now + nanosecondsOf(factors.decideSeconds * normalWithin(random_, 1, 0.25, 0.4, 2.5)));
    answersAgainAt_ = now + nanosecondsOf(kNearerAgainSeconds);
  }

  Vision vision_;
  Random random_;
  std::optional<int64_t> began_{};
  glm::dvec2 gaze_{0};
  std::array<std::optional<double>, 2> judged_{};  ///< by Side: the logarithm of the height, as it seems
  int64_t answersAgainAt_ = 0;
};

/// Two objects in a hall, with corridors to its sides.
InstructionExample nearerExample(TrialView view, const glm::ivec2& size) {
  Maze maze = mazeFromJsonText(R"({"plan": [
    "+-+-+-+-+-+",
    "|   |   | |",
    "+ +-+ +-+ +",
    "|         |",
    "+ + +-+ +-+",
    "| |   |   |",
    "+ +-+-+-+-+"]})",
                               "an example");
  maze.landmarks = {{{1, 2}, LandmarkShape::kSphere, LandmarkColor::kOrange, 0, -0.2f},
                    {{1, 3}, LandmarkShape::kSphere, LandmarkColor::kOrange, 0, 0.2f}};
  const glm::vec3 start = maze.centerOf({1, 0});
  const WalkerPose pose{static_cast<double>(start.x), static_cast<double>(start.z), radiansOf(Direction::kEast)};
  InstructionExample example{std::make_shared<StudyScene>(maze), {}};
  example.layout.scene = example.scene.get();
  example.layout.views = EyeCamera(maze, {}, {}).views(pose, view, wholeImage(size));
  return example;
}

std::unique_ptr<TaskPolicy> nearerPolicy(const PolicySetting& setting) {
  return std::make_unique<NearerPolicy>(setting.vision, setting.seed);
}

/// Of cases of a staircase: how far their level is above 0.1, times e. Others have none.
double logLevelCovariate(const GeneratedTrial& trial) {
  constexpr double kUsualLevel = 0.1;
  return trial.info.level ? std::log(*trial.info.level / kUsualLevel) : 0;
}

}  // namespace

TaskKind nearerTask() {
  return {.name = "nearer",
          .description = "say which of two objects is nearer, the left one or the right one",
          .outcome = OutcomeKind::kAnswer,
          .read = readNearerTask,
          .policy = nearerPolicy,
          .generator = {.effects = {{"right", 1.5, "logit of a right answer with the reference in the first session",
                                     levelCovariate},
                                    {kGraphEffect, -0.5, "the condition that is not the reference", graphCovariate},
                                    {"session", 0.1, "each further session", sessionCovariate},
                                    {"level", 1.2, "e times the level, of a staircase's cases", logLevelCovariate},
                                    {kSubjectSd, 0.5, "between subjects"},
                                    {kItemSd, 0.6, "between cases"},
                                    {kItemViewSd, 0, "between cases in the effect of the view"}},
                        .wrongAnswer = otherSideName},
          .images = {
              {"nearer_ppc", false, [](const glm::ivec2& size) { return nearerExample(TrialView::kReference, size); }},
              {"nearer_gc", true, [](const glm::ivec2& size) { return nearerExample(TrialView::kOther, size); }}}};
}

}  // namespace ocelli
