// Find an object (section 7.3.1): one walks through a maze and clicks on it, as soon as possible. It stands in a place,
// or walks about from there.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <vector>

#include "oc_core/base/check.h"
#include "oc_core/base/json_fields.h"
#include "oc_core/base/random.h"
#include "oc_core/worlds/maze_validate.h"
#include "study/outline/usual_values.h"
#include "study/task/eye_camera.h"
#include "study/task/hidden_cells.h"
#include "study/task/object_picker.h"
#include "study/task/object_walk.h"
#include "study/task/task_fields.h"
#include "study/task/task_layout.h"
#include "study/task/task_pointer.h"
#include "study/task/walker.h"
#include "study/tasks/find_images.h"
#include "study/tasks/find_policy.h"
#include "study/tasks/task_registry.h"

namespace ocelli {
namespace {

constexpr double kTypicalSeconds = 20;
constexpr int kMaxDistanceBands = 12;
constexpr int kUsualDistanceBands = 4;
constexpr const char* kDrawnCases = "cases";

struct FindCase {
  std::string label;
  Landmark object;
  std::vector<MazeCell> cells{};  ///< one of them is drawn for each trial; empty where the object's own is meant
};

struct FindOptions {
  double limitSeconds = kUsualFindLimitSeconds;
  double clickTolerancePixels = 6;
  std::optional<double> movingMetersPerSecond{};
  WalkerPose start{};
  EyeCameraOptions camera{};
};

/// All that the trials of a block share. One scene shows all cases: its object is moved to where it stands.
class FindBlock : public TaskBlock {
 public:
  FindBlock(const Maze& maze, const TaskSetting& setting, const FindOptions& options, std::vector<FindCase> cases)
      : maze_(maze),
        controls_(setting.controls),
        options_(options),
        cases_(std::move(cases)),
        plan_(maze, setting.controls.bodyRadiusMeters),
        camera_(maze, setting.controls, options.camera, setting.conditions),
        scene_(withObject(maze, cases_.front().object)),
        picker_(scene_) {}

  int caseCount() const override { return static_cast<int>(cases_.size()); }
  CaseInfo caseInfo(int caseIndex) const override {
    CaseInfo info;
    info.label = caseOf(caseIndex).label;
    info.moving = options_.movingMetersPerSecond.has_value();
    info.objects = 1;
    info.longestSeconds = options_.limitSeconds;
    info.typicalSeconds = std::min(kTypicalSeconds, options_.limitSeconds);
    return info;
  }
  std::string answerOf(const TrialPlan& plan) const override { return "object at " + placeName(objectOf(plan).cell); }
  std::unique_ptr<TrialRun> start(const TrialPlan& plan, const TrialScreen& screen) const override;

  const Maze& maze() const { return maze_; }
  const Controls& controls() const { return controls_; }
  const FindOptions& options() const { return options_; }
  const FloorPlan& plan() const { return plan_; }
  const EyeCamera& camera() const { return camera_; }
  const StudyScene& scene() const { return scene_; }
  const ObjectPicker& picker() const { return picker_; }
  const FindCase& caseOf(int index) const {
    OC_CHECK(index >= 0 && index < caseCount(), "a trial is of a case of its block");
    return cases_[static_cast<size_t>(index)];
  }
  /// What is to be found, where it stands at first.
  Landmark objectOf(const TrialPlan& plan) const {
    const FindCase& of = caseOf(plan.caseIndex);
    Landmark object = of.object;
    if (!of.cells.empty()) {
      // Another seed than that of its walk.
      object.cell = of.cells[Random(Random(plan.seed).next()).below(of.cells.size())];
    }
    return object;
  }
  /// (x, z) of an object.
  glm::dvec2 placeOf(const Landmark& object) const {
    const glm::vec3 place = maze_.centerOf(object.cell) + maze_.cellSize * glm::vec3(object.east, 0, object.south);
    return {static_cast<double>(place.x), static_cast<double>(place.z)};
  }
  /// From where the object of the scene stands.
  glm::vec3 offsetTo(const glm::dvec2& place) const {
    const glm::dvec2 by = place - placeOf(cases_.front().object);
    return {static_cast<float>(by.x), 0, static_cast<float>(by.y)};
  }

 private:
  static Maze withObject(Maze maze, const Landmark& object) {
    maze.landmarks = {object};
    return maze;
  }

  Maze maze_;
  Controls controls_;
  FindOptions options_;
  std::vector<FindCase> cases_;
  FloorPlan plan_;
  EyeCamera camera_;
  StudyScene scene_;
  ObjectPicker picker_;
};

class FindRun : public TrialRun {
 public:
  FindRun(const FindBlock& block, const TrialPlan& plan, const TrialScreen& screen)
      : block_(block),
        view_(plan.view),
        expected_(block.answerOf(plan)),
        isDrawn_(!block.caseOf(plan.caseIndex).cells.empty()),
        cell_(block.objectOf(plan).cell),
        stage_(stageOf(screen)),
        place_(block.placeOf(block.objectOf(plan))),
        walker_(block_.plan(), block_.controls(), block_.options().start),
        pointer_(stage_, block_.controls()) {
    if (const std::optional<double> speed = block.options().movingMetersPerSecond) {
      const ObjectWalk::Start start{block.objectOf(plan).cell, place_};
      walk_.emplace(block_.maze(), std::span(&start, 1), *speed, plan.seed);
    }
  }

  void handle(const InputEvent& event) override {
    if (outcome_) {
      return;
    }
    const bool isClick = pointer_.isClick(event);
    walker_.handle(event);
    pointer_.handle(event);
    if (isClick) {
      click();
    }
  }
  void advance() override {
    if (outcome_) {
      return;
    }
    ++tick_;
    walker_.advance();
    pointer_.advance();
    if (walk_) {
      walk_->advance();
      place_ = walk_->place(0);
    }
    if (tick_ >= ticksOf(block_.options().limitSeconds)) {
      finish(false);
    }
  }
  void frameShown(int64_t /*tick*/) override {}

  TrialLayout layout() const override {
    TrialLayout layout;
    layout.scene = &block_.scene();
    layout.objectOffsets = {block_.offsetTo(place_)};
    layout.views = views();
    layout.prompt = "Find the object and click on it";
    layout.targetObject = 0;
    layout.pointer = pointer_.place();
    return layout;
  }
  WalkerPose pose() const override { return walker_.pose(); }
  std::optional<TrialOutcome> outcome() const override { return outcome_; }

 private:
  std::vector<TrialLayout::View> views() const { return block_.camera().views(walker_.pose(), view_, stage_); }

  void click() {
    const std::vector<TrialLayout::View> shown = views();
    const bool hit = std::any_of(shown.begin(), shown.end(), [&](const TrialLayout::View& view) {
      const glm::dvec2 pixel = pointer_.place() - glm::dvec2(view.place.left, view.place.top);
      return block_.picker().isUnder(view.camera, pixel, block_.options().clickTolerancePixels, 0,
                                     block_.offsetTo(place_));
    });
    if (hit) {
      finish(true);
    } else {
      ++wrongClicks_;
    }
  }
  void finish(bool found) {
    TrialOutcome outcome;
    outcome.expected = expected_;
    outcome.answer = found ? expected_ : "";
    outcome.correct = found;
    outcome.censored = !found;
    outcome.responseTicks = tick_;
    outcome.measures = {{"wrong_clicks", wrongClicks_},
                        {"path_length_m", walker_.pathMeters()},
                        {"turned_degrees", walker_.turnedDegrees()},
                        {"collisions", walker_.collisions()}};
    if (isDrawn_) {  // the protocol does not tell
      outcome.measures["object_row"] = cell_.row;
      outcome.measures["object_column"] = cell_.column;
    }
    outcome_ = std::move(outcome);
  }

  const FindBlock& block_;
  TrialView view_;
  std::string expected_;
  bool isDrawn_;   ///< where the object stands
  MazeCell cell_;  ///< in which it does at first
  PixelRect stage_;
  glm::dvec2 place_;  ///< of the object, (x, z)
  Walker walker_;
  TaskPointer pointer_;
  std::optional<ObjectWalk> walk_{};
  int64_t tick_ = 0;
  int wrongClicks_ = 0;
  std::optional<TrialOutcome> outcome_{};
};

std::unique_ptr<TrialRun> FindBlock::start(const TrialPlan& plan, const TrialScreen& screen) const {
  return std::make_unique<FindRun>(*this, plan, screen);
}

/// Throws InputError where the object reaches into a wall.
void checkObject(Maze maze, const Landmark& object, const std::string& where) {
  maze.landmarks = {object};
  validate(maze, where);
}

/// Of the cells of its band, from which case `i` of `count` draws: every so many, so that no two draw the same one.
void giveCells(const std::vector<MazeCell>& cells, size_t i, size_t count, const Maze& maze, const std::string& where,
               FindCase& of) {
  for (size_t k = i; k < cells.size(); k += count) {
    of.cells.push_back(cells[k]);
    of.object.cell = cells[k];
    checkObject(maze, of.object, fmt::format("{}, case \"{}\"", where, of.label));
  }
  of.object.cell = of.cells.front();
}

/// The cells that any case of the block names, those of practice and examples too: where a subject may have been.
std::set<MazeCell> namedCells(JsonFields& fields) {
  std::set<MazeCell> cells;
  for (const char* list : {"cases", "practice_cases", "example_cases"}) {
    if (!fields.has(list)) {
      continue;
    }
    for (const nlohmann::json& each : fields.value(list)) {
      if (each.is_object() && each.contains("row") && each.contains("column") && each["row"].is_number_integer() &&
          each["column"].is_number_integer()) {
        cells.insert({each["row"].get<int>(), each["column"].get<int>()});
      }
    }
  }
  return cells;
}

std::shared_ptr<const TaskBlock> readFindTask(JsonFields& fields, const std::string& caseField,
                                              const TaskSetting& setting) {
  const Maze& maze = readMazeOf(fields, setting);
  FindOptions options;
  options.limitSeconds = fields.number("limit_seconds", 1, 3600, options.limitSeconds);
  options.clickTolerancePixels = fields.number("click_tolerance_pixels", 0, 200, options.clickTolerancePixels);
  options.movingMetersPerSecond = readMoving(fields);
  options.start = readStart(fields, maze);
  options.camera = readEyeCameraOptions(fields);
  const ObjectLook look = readObjectLook(fields, true);
  const int bands = fields.integer("distance_bands", 1, kMaxDistanceBands, kUsualDistanceBands);
  std::vector<FindCase> cases;
  std::map<int, std::vector<size_t>> casesOfBand;
  readCases(fields, caseField, [&](JsonFields& each, const std::string& label) {
    Landmark object;
    if (each.has("distance_band")) {
      if (each.has("row") || each.has("column")) {
        each.fail("distance_band", "draws the cell, which \"row\" and \"column\" name: give one or the other");
      }
      if (caseField != kDrawnCases) {
        each.fail("distance_band", "is for the trials: practice and examples name their cells, which are not drawn");
      }
      casesOfBand[each.integer("distance_band", 1, bands)].push_back(cases.size());
    } else {
      object.cell = readCell(each, maze);
    }
    object.shape = look.shape;
    object.color = look.color;
    object.east = static_cast<float>(each.number("east", -0.5, 0.5, 0));
    object.south = static_cast<float>(each.number("south", -0.5, 0.5, 0));
    cases.push_back({label, object});
    if (!each.has("distance_band")) {
      checkObject(maze, object, each.where());
    }
  });
  if (!casesOfBand.empty()) {
    const SightSetting sight{EyeCamera(maze, setting.controls, options.camera, setting.conditions), options.start,
                             cases.front().object};
    std::vector<MazeCell> hidden = hiddenCells(maze, sight);
    const std::set<MazeCell> named = namedCells(fields);
    std::erase_if(hidden, [&](const MazeCell& cell) { return named.contains(cell); });
    for (const auto& [band, list] : casesOfBand) {
      const std::vector<MazeCell> cells = cellsOfBand(hidden, band - 1, bands);
      if (cells.size() < list.size()) {
        fields.fail(caseField,
                    fmt::format("has {} cases in band {} of {}, but of the {} cells that are out of sight at "
                                "the start {} are in it: fewer cases or bands, or a larger maze",
                                list.size(), band, bands, hidden.size(), cells.size()));
      }
      for (size_t i = 0; i < list.size(); ++i) {
        giveCells(cells, i, list.size(), maze, fields.where(), cases[list[i]]);
      }
    }
  }
  return std::make_shared<FindBlock>(maze, setting, options, std::move(cases));
}

std::unique_ptr<TaskPolicy> findPolicy(const PolicySetting& setting) {
  return std::make_unique<FindPolicy>(setting.vision, setting.controls, setting.memory(), setting.seed);
}

double movingCovariate(const GeneratedTrial& trial) {
  return trial.info.moving ? 1 : 0;
}

}  // namespace

TaskKind findTask() {
  return {.name = "find",
          .description = "walk through a maze and click on an object",
          .outcome = OutcomeKind::kTime,
          .read = readFindTask,
          .policy = findPolicy,
          .generator = {.effects = {{"log_seconds", 2.5, "log seconds with the reference in the first session",
                                     levelCovariate},
                                    {kGraphEffect, -0.3, "the condition that is not the reference", graphCovariate},
                                    {"moving", -0.3, "moving objects", movingCovariate},
                                    {"session", -0.1, "each further session", sessionCovariate},
                                    {kSubjectSd, 0.25, "between subjects"},
                                    {kSubjectGraphSd, 0.1, "between subjects in that effect"},
                                    {kItemSd, 0.35, "between cases"},
                                    {kItemViewSd, 0, "between cases in the effect of the view"},
                                    {kResidualSd, 0.45, "between searches of one subject for one case"}},
                        .recordedAlways = true},
          .images = findImages()};
}

}  // namespace ocelli
