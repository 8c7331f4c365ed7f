// Count the objects in a maze (section 7.3.2): it is shown for a while, whole, by one comprehensive graph camera or by
// a matrix of pinholes that were laid by hand; then one says how many objects there were.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <mutex>
#include <set>

#include "oc_core/base/check.h"
#include "oc_core/base/json_fields.h"
#include "oc_core/base/random.h"
#include "oc_core/constructor/comprehensive_constructor.h"
#include "oc_core/worlds/landmark_solids.h"
#include "oc_core/worlds/maze_validate.h"
#include "study/task/choice_list.h"
#include "study/task/exposure.h"
#include "study/task/object_walk.h"
#include "study/task/pinhole_matrix.h"
#include "study/task/task_fields.h"
#include "study/task/task_layout.h"
#include "study/tasks/count_images.h"
#include "study/tasks/count_policy.h"
#include "study/tasks/task_registry.h"

namespace ocelli {
namespace {

constexpr double kTypicalCountSeconds = 4;
constexpr int kMaxAnswer = 9;  // a digit
constexpr size_t kMaxVariants = 16;

struct CountCase {
  std::string label;
  int objects = 4;
  double exposureSeconds = 10;
  bool duplicateColors = false;
};

/// From where the maze is shown: by a condition, or by one that asks for this variant.
struct CountVantage {
  ComprehensiveOptions comprehensive{};
  PinholeMatrix pinholes{};
};

struct CountOptions {
  LandmarkShape shape = LandmarkShape::kSphere;
  std::optional<double> movingMetersPerSecond{};
  int minAnswer = 4;
  int maxAnswer = 7;
  double answerLimitSeconds = 30;
  CountVantage vantage{};
  std::map<std::string, CountVantage> variants{};
  std::vector<MazeCell> places{};
};

/// All but ivory, which is too near to the grey of walls.
std::vector<LandmarkColor> objectColors() {
  std::vector<LandmarkColor> colors(kLandmarkColors.begin(), kLandmarkColors.end());
  std::erase(colors, LandmarkColor::kIvory);
  return colors;
}

std::vector<TrialLayout::View> comprehensiveView(const Maze& maze, const ComprehensiveOptions& options,
                                                 const PixelRect& stage) {
  const glm::ivec2 size = sizeOf(stage);
  std::vector<TrialLayout::View> views;
  views.emplace_back(stage, makeComprehensiveCamera(maze, options, size.x, size.y));
  return views;
}

Vantage vantageOf(const Maze& maze, const CountVantage& of, const PixelRect& stage) {
  return {panesOf(of.pinholes, maze, stage),
          [&maze, &of, stage] { return comprehensiveView(maze, of.comprehensive, stage); }};
}

/// It holds on to the maze and to the options.
Vantage vantageOf(const Maze& maze, const CountOptions& options, const PixelRect& stage) {
  Vantage vantage = vantageOf(maze, options.vantage, stage);
  for (const auto& [name, variant] : options.variants) {
    vantage.variants.push_back(vantageOf(maze, variant, stage));
    vantage.variants.back().name = name;
  }
  return vantage;
}

class CountBlock : public TaskBlock {
 public:
  CountBlock(const Maze& maze, const TaskSetting& setting, const CountOptions& options, std::vector<CountCase> cases)
      : maze_(maze),
        controls_(setting.controls),
        conditions_(setting.conditions),
        options_(options),
        cases_(std::move(cases)) {}

  int caseCount() const override { return static_cast<int>(cases_.size()); }
  CaseInfo caseInfo(int caseIndex) const override {
    const CountCase& of = caseOf(caseIndex);
    CaseInfo info;
    info.label = of.label;
    info.moving = options_.movingMetersPerSecond.has_value();
    info.exposureSeconds = of.exposureSeconds;
    info.objects = of.objects;
    info.duplicateColors = of.duplicateColors;
    info.longestSeconds = of.exposureSeconds + options_.answerLimitSeconds;
    info.typicalSeconds = of.exposureSeconds + std::min(kTypicalCountSeconds, options_.answerLimitSeconds);
    return info;
  }
  bool isStill() const override { return !options_.movingMetersPerSecond; }
  std::string answerOf(const TrialPlan& plan) const override { return std::to_string(caseOf(plan.caseIndex).objects); }
  std::unique_ptr<TrialRun> start(const TrialPlan& plan, const TrialScreen& screen) const override;

  const Maze& maze() const { return maze_; }
  const Controls& controls() const { return controls_; }
  const CountOptions& options() const { return options_; }
  const CountCase& caseOf(int index) const {
    OC_CHECK(index >= 0 && index < caseCount(), "a trial is of a case of its block");
    return cases_[static_cast<size_t>(index)];
  }

  /// The maze with the objects of a trial.
  Maze withObjects(const TrialPlan& plan) const {
    const CountCase& of = caseOf(plan.caseIndex);
    const auto count = static_cast<size_t>(of.objects);
    Random random(plan.seed);
    std::vector<MazeCell> places = options_.places;
    random.shuffle(places);
    std::vector<LandmarkColor> colors = objectColors();
    random.shuffle(colors);
    if (of.duplicateColors) {
      // Two are alike for certain, the others perhaps.
      std::vector<LandmarkColor> drawn{colors[0], colors[0]};
      while (drawn.size() < count) {
        drawn.push_back(colors[random.below(colors.size())]);
      }
      random.shuffle(drawn);
      colors = std::move(drawn);
    }
    Maze maze = maze_;
    maze.landmarks.clear();
    for (size_t i = 0; i < count; ++i) {
      maze.landmarks.push_back({places[i], options_.shape, colors[i]});
    }
    return maze;
  }

  /// Made once for each size of the screen. They may be asked for by several threads.
  std::shared_ptr<const std::vector<TrialLayout::View>> views(TrialView view, const TrialScreen& screen) const {
    const std::lock_guard lock(mutex_);
    auto& made = views_[{screen.width, screen.height, view}];
    if (!made) {
      made = std::make_shared<const std::vector<TrialLayout::View>>(
          conditions_.viewsOf(view, vantageOf(maze_, options_, stageOf(screen))));
    }
    return made;
  }

 private:
  Maze maze_;
  Controls controls_;
  StudyConditions conditions_;
  CountOptions options_;
  std::vector<CountCase> cases_;
  mutable std::mutex mutex_;
  mutable std::map<std::tuple<int, int, TrialView>, std::shared_ptr<const std::vector<TrialLayout::View>>> views_;
};

class CountRun : public TrialRun {
 public:
  CountRun(const CountBlock& block, const TrialPlan& plan, const TrialScreen& screen)
      : block_(block),
        expected_(block.caseOf(plan.caseIndex).objects),
        scene_(block.withObjects(plan), false),
        views_(block.views(plan.view, screen)),
        exposure_(plan.exposure, block.caseOf(plan.caseIndex).exposureSeconds, screen.refreshHertz),
        pointer_(wholeScreen(screen), block.controls()),
        choices_(choicesOf(block.options(), screen)) {
    if (const std::optional<double> speed = block.options().movingMetersPerSecond) {
      std::vector<ObjectWalk::Start> starts;
      for (const Landmark& object : scene_.maze().landmarks) {
        const glm::vec3 place = block.maze().centerOf(object.cell);
        starts.push_back({object.cell, {static_cast<double>(place.x), static_cast<double>(place.z)}});
      }
      // Another seed than that of the places.
      walk_.emplace(block.maze(), starts, *speed, Random(plan.seed).next());
    }
  }

  void handle(const InputEvent& event) override {
    if (outcome_) {
      return;
    }
    const std::optional<int> chosen = hiddenAt_ ? choices_.handle(event, pointer_) : std::nullopt;
    pointer_.handle(event);
    if (chosen) {
      finish(block_.options().minAnswer + *chosen);
    }
  }
  void advance() override {
    if (outcome_) {
      return;
    }
    ++tick_;
    pointer_.advance();
    if (isShowing()) {
      if (walk_) {
        walk_->advance();
      }
    } else if (hiddenAt_ && tick_ - *hiddenAt_ >= ticksOf(block_.options().answerLimitSeconds)) {
      finish(std::nullopt);
    }
  }
  void frameShown(int64_t tick) override {
    if (!isShowing() && !hiddenAt_) {
      hiddenAt_ = tick_;
    }
    exposure_.frameShown(tick);
  }

  TrialLayout layout() const override {
    TrialLayout layout;
    layout.scene = &scene_;
    layout.tick = tick_;
    if (isShowing()) {
      for (size_t i = 0; walk_ && i < walk_->size(); ++i) {
        const glm::vec3 from = block_.maze().centerOf(scene_.maze().landmarks[i].cell);
        const glm::dvec2 to = walk_->place(i);
        layout.objectOffsets.emplace_back(to.x - static_cast<double>(from.x), 0, to.y - static_cast<double>(from.z));
      }
      layout.views = *views_;
      layout.prompt = "Count the objects";
    } else {
      layout.choices = choices_.choices();
      layout.prompt = "How many objects were there?";
      layout.pointer = pointer_.place();
    }
    return layout;
  }
  /// No one walks.
  WalkerPose pose() const override { return {}; }
  std::optional<TrialOutcome> outcome() const override { return outcome_; }

 private:
  static std::vector<TrialLayout::Choice> choicesOf(const CountOptions& options, const TrialScreen& screen) {
    std::vector<TrialLayout::Choice> choices;
    for (const PixelRect& place : buttonsIn(stageOf(screen), options.maxAnswer - options.minAnswer + 1)) {
      const int number = options.minAnswer + static_cast<int>(choices.size());
      choices.push_back({place, std::to_string(number), static_cast<Key>(static_cast<int>(Key::k0) + number)});
    }
    return choices;
  }

  bool isShowing() const { return !exposure_.isOver(); }

  void finish(std::optional<int> answer) {
    TrialOutcome outcome;
    outcome.expected = std::to_string(expected_);
    outcome.answer = answer ? std::to_string(*answer) : "";
    outcome.correct = answer == expected_;
    outcome.censored = !answer;
    outcome.responseTicks = tick_ - *hiddenAt_;
    outcome.exposureFrames = exposure_.frames();
    outcome.exposureTicks = exposure_.shownTicks();
    if (answer) {
      outcome.measures = {{"count_error", *answer - expected_}};
    }
    outcome_ = std::move(outcome);
  }

  const CountBlock& block_;
  int expected_;
  StudyScene scene_;
  std::shared_ptr<const std::vector<TrialLayout::View>> views_;
  Exposure exposure_;
  TaskPointer pointer_;
  ChoiceList choices_;
  std::optional<ObjectWalk> walk_{};
  int64_t tick_ = 0;
  std::optional<int64_t> hiddenAt_{};  ///< tick of the first frame without the scene
  std::optional<TrialOutcome> outcome_{};
};

std::unique_ptr<TrialRun> CountBlock::start(const TrialPlan& plan, const TrialScreen& screen) const {
  return std::make_unique<CountRun>(*this, plan, screen);
}

std::vector<MazeCell> readPlaces(JsonFields& fields, const Maze& maze) {
  std::vector<MazeCell> places;
  if (!fields.has("places")) {
    for (int row = 0; row < maze.rows(); ++row) {
      for (int column = 0; column < maze.columns(); ++column) {
        if (const MazeCell cell{row, column}; cell != maze.entrance->cell) {
          places.push_back(cell);
        }
      }
    }
    return places;
  }
  std::set<MazeCell> seen;
  fields.forEach(
      "places", 1, static_cast<size_t>(maze.rows() * maze.columns()),
      [&](JsonFields& each) {
        places.push_back(readCell(each, maze));
        if (!seen.insert(places.back()).second) {
          each.fail("row", fmt::format("and \"column\" name the cell {} a second time", nameOf(places.back())));
        }
      },
      R"(cells, {"row": 0, "column": 0})");
  return places;
}

void checkPlaces(JsonFields& fields, const Maze& maze, const CountOptions& options) {
  Maze withObjects = maze;
  withObjects.landmarks.clear();
  for (const MazeCell& place : options.places) {
    withObjects.landmarks.push_back({place, options.shape});
  }
  validate(withObjects, fields.where() + ", \"places\"");
}

CountCase readCase(JsonFields& fields, const std::string& label, const CountOptions& options) {
  CountCase of;
  of.label = label;
  of.objects = fields.integer("objects", 1, kMaxAnswer);
  of.exposureSeconds = fields.number("exposure_seconds", 0.05, 600);
  of.duplicateColors = fields.boolean("duplicate_colors", false);
  if (of.objects < options.minAnswer || of.objects > options.maxAnswer) {
    fields.fail("objects",
                fmt::format("is {}, but the answers are {} to {}: change \"least_answer\" or \"most_answer\"",
                            of.objects, options.minAnswer, options.maxAnswer));
  }
  if (static_cast<size_t>(of.objects) > options.places.size()) {
    fields.fail("objects", fmt::format("is {}, but there are {} places: name more in \"places\", or take a larger maze",
                                       of.objects, options.places.size()));
  }
  if (!of.duplicateColors && static_cast<size_t>(of.objects) > objectColors().size()) {
    fields.fail("objects", fmt::format("is {}, but there are {} colours: fewer objects, or \"duplicate_colors\": true",
                                       of.objects, objectColors().size()));
  }
  if (of.duplicateColors && of.objects < 2) {
    fields.fail("duplicate_colors", "needs two objects that are alike");
  }
  return of;
}

/// The field "comprehensive", where it is.
void readVantage(JsonFields& fields, const Maze& maze, CountVantage& vantage) {
  if (fields.has("comprehensive")) {
    JsonFields comprehensive = fields.inner("comprehensive");
    vantage.comprehensive = readComprehensiveOptions(comprehensive);
    comprehensive.rejectUnknown();
  }
  // Tells now what no screen could show.
  comprehensiveView(maze, vantage.comprehensive, stageOf(TrialScreen{}));
}

std::shared_ptr<const TaskBlock> readCountTask(JsonFields& fields, const std::string& caseField,
                                               const TaskSetting& setting) {
  const Maze& maze = readMazeOf(fields, setting);
  CountOptions options;
  options.shape = readObjectLook(fields, false).shape;
  options.movingMetersPerSecond = readMoving(fields);
  options.minAnswer = fields.integer("least_answer", 0, kMaxAnswer, options.minAnswer);
  options.maxAnswer = fields.integer("most_answer", 0, kMaxAnswer, options.maxAnswer);
  if (options.maxAnswer <= options.minAnswer) {
    fields.fail("most_answer", "must be more than \"least_answer\": there is nothing to choose");
  }
  options.answerLimitSeconds = fields.number("answer_limit_seconds", 1, 3600, options.answerLimitSeconds);
  readVantage(fields, maze, options.vantage);
  JsonFields pinholes = fields.inner("pinholes");
  options.vantage.pinholes = readPinholeMatrix(pinholes, maze);
  fields.forEachNamed(
      "variants", kMaxVariants,
      [&](const std::string& name, JsonFields& each) {
        CountVantage variant = options.vantage;
        readVantage(each, maze, variant);
        if (each.has("pinholes")) {
          JsonFields matrix = each.inner("pinholes");
          variant.pinholes = readPinholeMatrix(matrix, maze);
        }
        each.rejectUnknown();
        options.variants.emplace(name, variant);
      },
      "variants");
  // Tells now which variants conditions lack; of nothing, as only the names matter.
  Vantage nothing{{}, [] { return std::vector<TrialLayout::View>(); }};
  for (const auto& [name, variant] : options.variants) {
    nothing.variants.push_back({{}, nothing.graph, {}, name});
  }
  for (const TrialView view : setting.conditions.names.all()) {
    setting.conditions.viewsOf(view, nothing);
  }
  options.places = readPlaces(fields, maze);
  checkPlaces(fields, maze, options);
  std::vector<CountCase> cases;
  readCases(fields, caseField,
            [&](JsonFields& each, const std::string& label) { cases.push_back(readCase(each, label, options)); });
  return std::make_shared<CountBlock>(maze, setting, options, std::move(cases));
}

std::unique_ptr<TaskPolicy> countPolicy(const PolicySetting& setting) {
  return std::make_unique<CountPolicy>(setting.vision, setting.seed);
}

double duplicatesCovariate(const GeneratedTrial& trial) {
  return trial.info.duplicateColors.value_or(false) ? 1 : 0;
}

double doubledExposureCovariate(const GeneratedTrial& trial) {
  constexpr double kSeconds = 10;
  return std::log2(trial.info.exposureSeconds.value_or(kSeconds) / kSeconds);
}

std::string oneOff(const std::string& expected, Random& random) {
  int number = 0;
  std::from_chars(expected.data(), expected.data() + expected.size(), number);
  return std::to_string(number + (happens(random, 0.5) ? 1 : -1));
}

}  // namespace

TaskKind countTask() {
  return {.name = "count",
          .description = "count the objects in a maze that is shown for a while",
          .outcome = OutcomeKind::kAnswer,
          .read = readCountTask,
          .policy = countPolicy,
          .generator = {.effects = {{"right", 0.5, "logit of a right answer with the reference in the first session",
                                     levelCovariate},
                                    {kGraphEffect, 1.5, "the condition that is not the reference", graphCovariate},
                                    {"duplicates", -0.4, "shared colours", duplicatesCovariate},
                                    {"doubled_exposure", 0.3, "twice the exposure", doubledExposureCovariate},
                                    {"session", 0.2, "each further session", sessionCovariate},
                                    {kSubjectSd, 0.5, "between subjects"},
                                    {kItemSd, 0.4, "between cases"},
                                    {kItemViewSd, 0, "between cases in the effect of the view"}},
                        .wrongAnswer = oneOff,
                        .recordedAlways = true},
          .images = countImages()};
}

}  // namespace ocelli
