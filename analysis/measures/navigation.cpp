#include "analysis/measures/navigation.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <tuple>

#include "analysis/dataset/protocol_facts.h"
#include "analysis/measures/pose_reader.h"
#include "analysis/measures/protocol_floor.h"

namespace ocelli {
namespace {

constexpr double kObjectRadius = 0.13;  ///< in cell sizes; all objects of the study stand on such a disc

using Number = Estimable<double>;

/// What the protocol of a source tells of its mazes.
struct SourceMazes {
  ProtocolFacts facts;
  std::map<std::string, MazeFloor> floors;
};

SourceMazes mazesOf(const DataSource& source) {
  SourceMazes mazes{protocolFacts(source.protocolText, fmt::format("{}, protocol", source.path)), {}};
  for (const ProtocolMaze& maze : mazes.facts.mazes) {
    mazes.floors.emplace(maze.name, floorOf(maze));
  }
  return mazes;
}

Number ratio(double walked, const Number& shortest, const char* whyNot) {
  if (!shortest) {
    return Number::impossible(shortest.reason());
  }
  return *shortest > 0 ? Number(walked / *shortest) : Number::impossible(whyNot);
}

Number shortestBetween(const MazeFloor& floor, const std::optional<MazeCell>& from, const std::optional<MazeCell>& to) {
  if (!from || !to) {
    return Number::impossible("the log leaves the maze");
  }
  const auto meters = floor.shortestMeters(*from, *to);
  return meters ? Number(*meters) : Number::impossible("no way leads there");
}

class Navigation {
 public:
  explicit Navigation(const Dataset& data) : data_(data), reader_(data.sources) {
    for (const DataSource& source : data.sources) {
      sources_.push_back(source.protocolText.empty() ? std::nullopt : std::optional(mazesOf(source)));
    }
  }

  NavigationData all(const std::string& task) {
    for (size_t i = 0; i < data_.trials.size(); ++i) {
      if (data_.trials[i].task == task) {
        add(i);
      }
    }
    for (auto& [key, map] : heatMaps_) {
      result_.heatMaps.push_back(std::move(map));
    }
    if (result_.searchesWithoutLog > 0) {
      result_.notes.push_back(fmt::format(
          "{} {} no log of where the subject stood, as generated searches and those of exported tables have none.",
          result_.searchesWithoutLog, result_.searchesWithoutLog == 1 ? "search has" : "searches have"));
    }
    if (!result_.searches.empty()) {
      result_.notes.push_back(
          fmt::format("In sight is what a pinhole at the eye would show in a straight line; with the {} the object may "
                      "have been seen before, around a corner.",
                      data_.conditions.labelOf(TrialView::kOther)));
    }
    return std::move(result_);
  }

 private:
  void add(size_t index);
  static SearchNavigation measured(const Trial& trial, const std::vector<Pose>& poses, const WalkMeasures& walk,
                                   const MazeFloor& floor, const ProtocolBlockFacts& block);
  void addHeat(const Trial& trial, const std::string& maze, const MazeFloor& floor, const std::vector<Pose>& poses);

  const Dataset& data_;
  PoseReader reader_;
  std::vector<std::optional<SourceMazes>> sources_{};
  std::map<std::tuple<std::string, std::string, bool, TrialView>, MazeHeatMap> heatMaps_{};  ///< mazes by protocol
  NavigationData result_{};
};

void Navigation::add(size_t index) {
  const Trial& trial = data_.trials[index];
  const auto& source = sources_[static_cast<size_t>(trial.source)];
  const auto blockIndex = static_cast<size_t>(trial.blockIndex);
  if (!source || blockIndex >= source->facts.blocks.size()) {
    ++result_.searchesWithoutLog;
    return;
  }
  const ProtocolBlockFacts& block = source->facts.blocks[blockIndex];
  const auto floor = source->floors.find(block.maze);
  const std::vector<Pose>& poses = reader_.posesOf(trial);
  const std::optional<WalkMeasures> walk = measureWalk(poses);
  if (!walk || floor == source->floors.end()) {
    ++result_.searchesWithoutLog;
    return;
  }
  SearchNavigation search = measured(trial, poses, *walk, floor->second, block);
  search.trial = index;
  result_.searches.push_back(std::move(search));
  addHeat(trial, block.maze, floor->second, poses);
}

/// As the protocol says; of a place that was drawn, as the trial does.
std::optional<MazeCell> cellOfObject(const Trial& trial, const ProtocolCase& place) {
  if (place.row && place.column) {
    return MazeCell{*place.row, *place.column};
  }
  const auto number = [&](const char* measure) {
    const auto found = trial.measures.find(measure);
    const bool isIndex = found != trial.measures.end() && found->second >= 0 && found->second < kMaxMazeSide;
    return isIndex ? std::optional(static_cast<int>(found->second)) : std::nullopt;
  };
  const std::optional<int> row = number("object_row");
  const std::optional<int> column = number("object_column");
  return row && column ? std::optional(MazeCell{*row, *column}) : std::nullopt;
}

SearchNavigation Navigation::measured(const Trial& trial, const std::vector<Pose>& poses, const WalkMeasures& walk,
                                      const MazeFloor& floor, const ProtocolBlockFacts& block) {
  const auto first = floor.cellAt({poses.front().x, poses.front().z});
  const auto last = floor.cellAt({poses.back().x, poses.back().z});
  const Number toEnd = shortestBetween(floor, first, last);
  const auto caseIndex = static_cast<size_t>(trial.caseIndex);
  const auto unknown = [&](const char* why) {
    return SearchNavigation{0,
                            walk,
                            false,
                            toEnd,
                            ratio(walk.pathMeters, toEnd, "the search ended in the cell where it began"),
                            Number::impossible(why),
                            Number::impossible(why),
                            Number::impossible(why),
                            Number::impossible(why)};
  };
  if (block.moving) {
    return unknown("the log does not tell where a moving object was");
  }
  if (caseIndex >= block.cases.size()) {
    return unknown("the protocol does not tell where the object stands");
  }
  const ProtocolCase& place = block.cases[caseIndex];
  const std::optional<MazeCell> told = cellOfObject(trial, place);
  if (!told) {
    return unknown("the protocol does not tell where the object stands");
  }
  const MazeCell cell = *told;
  if (!floor.plan().contains(cell)) {
    return unknown("the object stands outside of the maze");
  }
  SearchNavigation search = unknown("the object never came into straight sight");
  search.objectIsKnown = true;
  search.shortestToObjectMeters = shortestBetween(floor, first, cell);
  search.walkedOverWayToObject =
      ratio(walk.pathMeters, search.shortestToObjectMeters, "the object stands in the cell where the search began");
  const TargetObject object{floor.grid().pointOf(cell, place.east, place.south), kObjectRadius * floor.grid().cellSize};
  if (const auto seen = firstInSight(floor, poses, object, block.fovHorizontalDegrees)) {
    search.travelSeconds = *seen;
    if (trial.censored.value_or(true) || !trial.responseSeconds) {
      search.detectionSeconds = Number::impossible("time ran out");
    } else if (*trial.responseSeconds < *seen) {
      search.detectionSeconds = Number::impossible("the object was clicked on before it came into straight sight");
    } else {
      search.detectionSeconds = *trial.responseSeconds - *seen;
    }
  }
  return search;
}

void Navigation::addHeat(const Trial& trial, const std::string& maze, const MazeFloor& floor,
                         const std::vector<Pose>& poses) {
  const bool moving = trial.moving.value_or(false);
  const std::string& protocol = data_.sources[static_cast<size_t>(trial.source)].protocolSha256;
  MazeHeatMap& map = heatMaps_[{protocol, maze, moving, trial.view}];
  if (map.seconds.empty()) {
    map.source = trial.source;
    map.maze = maze;
    map.view = trial.view;
    map.moving = moving;
    map.rows = floor.plan().rows();
    map.columns = floor.plan().columns();
    map.seconds.assign(static_cast<size_t>(map.rows) * static_cast<size_t>(map.columns), 0);
  }
  ++map.trials;
  for (size_t i = 1; i < poses.size(); ++i) {
    const double seconds = static_cast<double>(poses[i].tick - poses[i - 1].tick) / kPoseTicksPerSecond;
    if (const auto cell = floor.cellAt({poses[i - 1].x, poses[i - 1].z})) {
      map.seconds[floor.plan().indexOf(*cell)] += seconds;
    } else {
      map.secondsOutside += seconds;
    }
  }
}

}  // namespace

NavigationData navigationOf(const Dataset& data, const std::string& task) {
  return Navigation(data).all(task);
}

}  // namespace ocelli
