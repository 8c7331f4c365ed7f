// Match a path (section 7.3.3): one is walked along a random path, then chooses its map from several.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "oc_core/base/check.h"
#include "oc_core/base/error.h"
#include "oc_core/base/json_fields.h"
#include "oc_core/base/random.h"
#include "study/outline/usual_values.h"
#include "study/task/choice_list.h"
#include "study/task/eye_camera.h"
#include "study/task/maze_path.h"
#include "study/task/task_fields.h"
#include "study/task/task_layout.h"
#include "study/tasks/path_policy.h"
#include "study/tasks/task_registry.h"

namespace ocelli {
namespace {

constexpr double kTypicalPathSeconds = 6;
constexpr int kMaxWalkSteps = 400;

struct PathOptions {
  int turns = 5;
  double minSeconds = 20;
  double maxSeconds = 40;
  PathWalk::Speed speed{};
  int maps = kUsualPathMaps;
  double answerLimitSeconds = 60;
  EyeCameraOptions camera{};
};

struct StepRange {
  int least = 1;
  int most = 0;
};

/// Of paths that last as long as asked for.
StepRange stepsOf(const PathOptions& options, const Maze& maze) {
  StepRange range{kMaxWalkSteps + 1, 0};
  for (int steps = options.turns + 1; steps <= kMaxWalkSteps; ++steps) {
    const double seconds = PathWalk::secondsOf(steps, options.turns, maze, options.speed);
    if (seconds >= options.minSeconds && seconds <= options.maxSeconds) {
      range = {std::min(range.least, steps), steps};
    }
  }
  return range;
}

/// What one trial shows.
struct PathItem {
  std::vector<MazePath> paths{};  ///< as they are offered
  int right = 0;                  ///< of these, the one that is walked
};

class PathBlock : public TaskBlock {
 public:
  PathBlock(const Maze& maze, const TaskSetting& setting, const PathOptions& options, const StepRange& steps,
            std::vector<std::string> labels)
      : maze_(maze),
        controls_(setting.controls),
        options_(options),
        labels_(std::move(labels)),
        paths_(maze_, steps.least, steps.most),
        sequences_(paths_.sequences(options.turns)),
        camera_(maze, setting.controls, options.camera, setting.conditions),
        scene_(maze) {}

  int caseCount() const override { return static_cast<int>(labels_.size()); }
  CaseInfo caseInfo(int caseIndex) const override {
    OC_CHECK(caseIndex >= 0 && caseIndex < caseCount(), "a trial is of a case of its block");
    CaseInfo info;
    info.label = labels_[static_cast<size_t>(caseIndex)];
    info.longestSeconds = options_.maxSeconds + options_.answerLimitSeconds;
    info.typicalSeconds =
        (options_.minSeconds + options_.maxSeconds) / 2 + std::min(kTypicalPathSeconds, options_.answerLimitSeconds);
    return info;
  }
  std::string answerOf(const TrialPlan& plan) const override {
    const PathItem item = itemOf(plan);
    return item.paths[static_cast<size_t>(item.right)].turns;
  }
  int choiceCount() const override { return options_.maps; }
  std::unique_ptr<TrialRun> start(const TrialPlan& plan, const TrialScreen& screen) const override;

  const Maze& maze() const { return maze_; }
  const Controls& controls() const { return controls_; }
  const PathOptions& options() const { return options_; }
  const EyeCamera& camera() const { return camera_; }
  const StudyScene& scene() const { return scene_; }
  const std::vector<std::string>& sequences() const { return sequences_; }

  PathItem itemOf(const TrialPlan& plan) const {
    Random random(plan.seed);
    std::vector<std::string> sequences = sequences_;
    random.shuffle(sequences);
    PathItem item;
    for (int i = 0; i < options_.maps; ++i) {
      item.paths.push_back(*paths_.random(sequences[static_cast<size_t>(i)], random));
    }
    item.right = static_cast<int>(random.below(item.paths.size()));
    std::swap(item.paths.front(), item.paths[static_cast<size_t>(item.right)]);
    return item;
  }

 private:
  Maze maze_;
  Controls controls_;
  PathOptions options_;
  std::vector<std::string> labels_;
  MazePaths paths_;
  std::vector<std::string> sequences_;  ///< of turns that paths have
  EyeCamera camera_;
  StudyScene scene_;
};

/// Maps in a row, below their keys.
std::vector<TrialLayout::Choice> mapChoices(const PixelRect& stage, int count) {
  constexpr double kSpace = 0.1;  // of a map, between them
  constexpr double kLabel = 0.2;  // of a map, above it
  const double side =
      std::floor(std::min(stage.width / (count + (count + 1) * kSpace), stage.height / (1 + kLabel + 2 * kSpace)));
  const double space = std::floor(kSpace * side);
  const double height = std::floor((1 + kLabel) * side);
  const double left = stage.left + std::floor((stage.width - count * side - (count - 1) * space) / 2);
  const double top = stage.top + std::floor((stage.height - height) / 2);
  std::vector<TrialLayout::Choice> choices;
  for (int i = 0; i < count; ++i) {
    choices.push_back({{left + i * (side + space), top, side, height},
                       std::to_string(i + 1),
                       static_cast<Key>(static_cast<int>(Key::k1) + i)});
  }
  return choices;
}

/// Below the key of its choice.
PixelRect mapPlace(const TrialLayout::Choice& choice) {
  PixelRect place = choice.place;
  place.top = place.bottom() - place.width;
  place.height = place.width;
  return place;
}

class PathRun : public TrialRun {
 public:
  PathRun(const PathBlock& block, const TrialPlan& plan, const TrialScreen& screen)
      : block_(block),
        view_(plan.view),
        item_(block.itemOf(plan)),
        walk_(item_.paths[static_cast<size_t>(item_.right)], block.maze(), block.options().speed),
        stage_(stageOf(screen)),
        pointer_(wholeScreen(screen), block.controls()),
        choices_(mapChoices(stage_, block.options().maps)),
        walkTicks_(static_cast<int64_t>(std::ceil(walk_.seconds() * static_cast<double>(kTicksPerSecond)))) {}

  void handle(const InputEvent& event) override {
    if (outcome_) {
      return;
    }
    const std::optional<int> chosen = isWalking() ? std::nullopt : choices_.handle(event, pointer_);
    pointer_.handle(event);
    if (chosen) {
      finish(chosen);
    }
  }
  void advance() override {
    if (outcome_) {
      return;
    }
    ++tick_;
    pointer_.advance();
    if (tick_ >= walkTicks_ + ticksOf(block_.options().answerLimitSeconds)) {
      finish(std::nullopt);
    }
  }
  void frameShown(int64_t /*tick*/) override {}

  TrialLayout layout() const override {
    TrialLayout layout;
    layout.scene = &block_.scene();
    if (isWalking()) {
      layout.views = block_.camera().views(pose(), view_, stage_);
      layout.prompt = "Watch the path";
      return layout;
    }
    layout.prompt = "Which path was it?";
    layout.choices = choices_.choices();
    layout.pointer = pointer_.place();
    for (size_t i = 0; i < item_.paths.size(); ++i) {
      layout.maps.push_back({mapPlace(layout.choices[i]), mapOf(item_.paths[i], block_.maze())});
    }
    return layout;
  }
  WalkerPose pose() const override {
    return walk_.at(static_cast<double>(std::min(tick_, walkTicks_)) / static_cast<double>(kTicksPerSecond));
  }
  std::optional<TrialOutcome> outcome() const override { return outcome_; }

 private:
  bool isWalking() const { return tick_ < walkTicks_; }

  void finish(std::optional<int> chosen) {
    TrialOutcome outcome;
    outcome.expected = item_.paths[static_cast<size_t>(item_.right)].turns;
    outcome.answer = chosen ? item_.paths[static_cast<size_t>(*chosen)].turns : "";
    outcome.correct = chosen == item_.right;
    outcome.censored = !chosen;
    outcome.responseTicks = tick_ - walkTicks_;
    outcome.measures = {{"playback_seconds", walk_.seconds()}, {"right_map", item_.right + 1}};
    if (chosen) {
      outcome.measures["chosen_map"] = *chosen + 1;
    }
    outcome_ = std::move(outcome);
  }

  const PathBlock& block_;
  TrialView view_;
  PathItem item_;
  PathWalk walk_;
  PixelRect stage_;
  TaskPointer pointer_;
  ChoiceList choices_;
  int64_t walkTicks_;
  int64_t tick_ = 0;
  std::optional<TrialOutcome> outcome_{};
};

std::unique_ptr<TrialRun> PathBlock::start(const TrialPlan& plan, const TrialScreen& screen) const {
  return std::make_unique<PathRun>(*this, plan, screen);
}

std::shared_ptr<const TaskBlock> readPathTask(JsonFields& fields, const std::string& caseField,
                                              const TaskSetting& setting) {
  const Maze& maze = readMazeOf(fields, setting);
  if (maze.cellCount() > kMaxPathCells) {
    fields.fail("maze", fmt::format("has {} cells, but paths are drawn from mazes of {} at most", maze.cellCount(),
                                    kMaxPathCells));
  }
  PathOptions options;
  options.turns = fields.integer("turns", 1, kMaxPathTurns, options.turns);
  options.minSeconds = fields.number("least_seconds", 1, 600, options.minSeconds);
  options.maxSeconds = fields.number("most_seconds", 1, 600, options.maxSeconds);
  if (options.maxSeconds < options.minSeconds) {
    fields.fail("most_seconds", "is less than \"least_seconds\"");
  }
  options.speed.metersPerSecond = fields.number("meters_per_second", 0.1, 20, setting.controls.walkMetersPerSecond);
  options.speed.turnDegreesPerSecond = setting.controls.turnDegreesPerSecond;
  options.maps = fields.integer("maps", 2, 5, options.maps);
  options.answerLimitSeconds = fields.number("answer_limit_seconds", 1, 3600, options.answerLimitSeconds);
  options.camera = readEyeCameraOptions(fields);
  std::vector<std::string> labels;
  readCases(fields, caseField, [&](JsonFields&, const std::string& label) { labels.push_back(label); });
  const char* const next =
      "change \"meters_per_second\" (without it one walks as the controls say), \"least_seconds\", \"most_seconds\", "
      "\"turns\" or the maze";
  const StepRange steps = stepsOf(options, maze);
  if (steps.most == 0) {
    throw InputError(
        fmt::format("at {:g} m/s no path of {} turns lasts {:g} to {:g} s in cells of {:g} m: the shortest "
                    "lasts {:.1f} s",
                    options.speed.metersPerSecond, options.turns, options.minSeconds, options.maxSeconds, maze.cellSize,
                    PathWalk::secondsOf(options.turns + 1, options.turns, maze, options.speed)),
        fields.where(), next);
  }
  auto block = std::make_shared<PathBlock>(maze, setting, options, steps, std::move(labels));
  if (static_cast<int>(block->sequences().size()) < options.maps) {
    throw InputError(
        fmt::format(
            "at {:g} m/s a path of {} turns lasts {:g} to {:g} s where it has {} to {} steps from cell to cell; "
            "in this maze such paths have {} different sequences of turns, and {} are to be shown",
            options.speed.metersPerSecond, options.turns, options.minSeconds, options.maxSeconds, steps.least,
            steps.most, block->sequences().size(), options.maps),
        fields.where(), next);
  }
  return block;
}

/// Maps of paths that one could take for each other.
InstructionExample pathMaps(const glm::ivec2& size) {
  const std::array<std::vector<glm::dvec2>, 3> paths{{
      {{0, 3}, {0, 1}, {2, 1}, {2, 0}, {3, 0}, {3, 2}},
      {{0, 3}, {0, 1}, {2, 1}, {2, 2}, {3, 2}, {3, 0}},
      {{3, 3}, {3, 1}, {1, 1}, {1, 0}, {0, 0}, {0, 2}},
  }};
  InstructionExample example;
  example.layout.choices = mapChoices(wholeImage(size), static_cast<int>(paths.size()));
  for (size_t i = 0; i < paths.size(); ++i) {
    example.layout.maps.push_back({mapPlace(example.layout.choices[i]), paths[i]});
  }
  return example;
}

std::unique_ptr<TaskPolicy> pathPolicy(const PolicySetting& setting) {
  return std::make_unique<PathPolicy>(setting.vision, setting.seed);
}

/// Which turns another map has would take long to find out.
std::string otherPath(const std::string&, Random&) {
  return "other";
}

}  // namespace

TaskKind pathTask() {
  return {.name = "path",
          .description = "watch a walk along a path, and choose its map",
          .outcome = OutcomeKind::kAnswer,
          .read = readPathTask,
          .policy = pathPolicy,
          .generator = {.effects = {{"right", 1, "logit of a right answer with the reference in the first session",
                                     levelCovariate},
                                    {kGraphEffect, 0.1, "the condition that is not the reference", graphCovariate},
                                    {"session", 0.2, "each further session", sessionCovariate},
                                    {kSubjectSd, 0.5, "between subjects"},
                                    {kItemSd, 0.4, "between cases"},
                                    {kItemViewSd, 0, "between cases in the effect of the view"}},
                        .wrongAnswer = otherPath,
                        .recordedAlways = true},
          .images = {{"path_maps", false, pathMaps}}};
}

}  // namespace ocelli
