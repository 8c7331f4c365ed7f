#include "analysis/report/navigation_section.h"

#include <fmt/format.h>

#include <array>

#include "analysis/dataset/protocol_facts.h"
#include "analysis/measures/navigation.h"
#include "analysis/measures/protocol_floor.h"
#include "analysis/plot/figure_grid.h"
#include "analysis/plot/heat_map.h"
#include "analysis/report/navigation_tables.h"
#include "analysis/report/part_guard.h"
#include "analysis/report/subject_means.h"

namespace ocelli {
namespace {

void addFigure(ReportWork& work, const std::vector<NavigationGroup>& groups) {
  FigureGrid grid;
  grid.title = "Ways, sight and turns by view";
  grid.columns = 3;
  const std::vector<NavigationMeasure> measures = navigationMeasures();
  for (const NavigationMeasure& measure : measures) {
    if (measure.panel.empty()) {
      continue;
    }
    GroupPlot plot;
    plot.title = measure.panel;
    plot.valueLabel = measure.axis;
    plot.legend = false;
    plot.widthMillimetres = grid.columnMillimetres();
    plot.heightMillimetres = 52;
    plot.summaryName = "mean of subjects, 95 % interval";
    plot.series = {{labelOf(work, TrialView::kReference), {}}, {labelOf(work, TrialView::kOther), {}}};
    for (const NavigationGroup& group : groups) {
      const TrialValues values = valuesOf(work.analysis.data, group, measure);
      if (values.empty()) {
        continue;
      }
      plot.conditions.emplace_back(group.moving ? "moving" : "stationary");
      for (size_t v = 0; v < kViews.size(); ++v) {
        plot.series[v].groups.push_back(
            groupOfSubjects(subjectMeans(valuesOfView(values, kViews[v])), ValueScale::kPlain));
      }
    }
    grid.legend = groupLegend(plot);
    if (!plot.conditions.empty()) {
      grid.figures.push_back(groupFigure(plot));
    }
  }
  addFigure(work, grid.title + ": one dot a subject", "figure-navigation", [&] { return gridFigure(grid); });
}

/// Where the objects of the blocks with that maze are, or set out from.
std::vector<HeatMap::Mark> objectMarks(const ProtocolFacts& facts, const std::string& task, const std::string& maze,
                                       const MazeGrid& grid, bool moving) {
  std::vector<HeatMap::Mark> marks;
  for (const ProtocolBlockFacts& block : facts.blocks) {
    if (block.task == task && block.maze == maze && block.moving == moving) {
      for (size_t i = 0; i < block.cases.size(); ++i) {
        const ProtocolCase& place = block.cases[i];
        if (place.row && place.column) {
          const FloorPoint at = grid.pointOf({*place.row, *place.column}, place.east, place.south);
          marks.push_back({at.x, at.z, std::to_string(i + 1)});
        }
      }
    }
  }
  return marks;
}

HeatMap::Map mapOfView(const ReportWork& work, const MazeHeatMap& map, double cellSize) {
  double total = 0;
  for (const double seconds : map.seconds) {
    total += seconds;
  }
  HeatMap::Map shown{fmt::format("{}, {} searches", labelOf(work, map.view), map.trials), {}, {}};
  for (int row = 0; row < map.rows; ++row) {
    for (int column = 0; column < map.columns; ++column) {
      const double seconds = map.seconds[static_cast<size_t>(row * map.columns + column)];
      shown.cells.push_back(
          {(column + 0.5) * cellSize, (row + 0.5) * cellSize, total > 0 ? seconds / total : kNotKnown});
    }
  }
  return shown;
}

/// Maps of the same maze and kind of object follow each other.
void addHeatMaps(ReportWork& work, const ReportTask& task, const std::vector<MazeHeatMap>& maps) {
  for (size_t first = 0; first < maps.size();) {
    const MazeHeatMap& map = maps[first];
    const DataSource& source = work.analysis.data.sources[static_cast<size_t>(map.source)];
    const ProtocolFacts facts = protocolFacts(source.protocolText, source.path);
    const MazeFloor floor = floorOf(*facts.findMaze(map.maze));
    const double cellSize = floor.grid().cellSize;
    HeatMap heat;
    heat.title = fmt::format("Where subjects were, {} objects", map.moving ? "moving" : "stationary");
    heat.valueLabel = "Share of the time of all searches with that view";
    heat.percent = true;
    heat.rootScale = true;
    for (const FloorLine& wall : floor.wallLines()) {
      heat.walls.push_back({wall.from.x, wall.from.z, wall.to.x, wall.to.z});
    }
    heat.cellSize = cellSize;
    double outside = 0;
    size_t last = first;
    for (; last < maps.size() && maps[last].maze == map.maze && maps[last].moving == map.moving &&
           maps[last].source == map.source;
         ++last) {
      heat.maps.push_back(mapOfView(work, maps[last], cellSize));
      heat.maps.back().marks = objectMarks(facts, task.name, map.maze, floor.grid(), map.moving);
      outside += maps[last].secondsOutside;
    }
    const std::string id = fmt::format("figure-heat-{}-{}{}", map.maze, map.moving ? "moving" : "stationary",
                                       map.source > 0 ? fmt::format("-{}", map.source + 1) : "");
    addFigure(
        work,
        fmt::format("{}, maze \"{}\", from above, north at the top. Diamonds are the places {}, by number of the case; "
                    "both views on one scale, which goes with the square root of the share",
                    heat.title, map.maze, map.moving ? "from which objects set out" : "of the objects"),
        id, [&] { return heatFigure(heat); });
    if (outside > 0) {
      work.document.add(
          ReportNote{NoteKind::kNote,
                     fmt::format("{} s of the logs lie outside of the maze and are not shown.", numberText(outside))});
    }
    first = last;
  }
}

}  // namespace

void addNavigationSection(ReportWork& work, const ReportTask& task) {
  addHeading(work.document, 1, "Navigation", "navigation");
  const NavigationData navigation = navigationOf(work.analysis.data, task.name);
  if (navigation.searches.empty()) {
    addNotEstimable(work.document, "Ways, sight and turns",
                    navigation.searchesWithoutLog == 0
                        ? std::string("there are no searches")
                        : fmt::format("none of {} searches has a log of where the subject stood, as generated searches "
                                      "and those of exported tables have none",
                                      navigation.searchesWithoutLog));
    return;
  }
  for (const std::string& note : navigation.notes) {
    work.document.add(ReportNote{NoteKind::kNote, note});
  }
  std::vector<NavigationGroup> groups{{false, {}}, {true, {}}};
  for (const SearchNavigation& search : navigation.searches) {
    groups[work.analysis.data.trials[search.trial].moving.value_or(false) ? 1 : 0].searches.push_back(&search);
  }
  std::erase_if(groups, [](const NavigationGroup& group) { return group.searches.empty(); });
  work.document.add(ReportParagraph{
      "All searches with a log count here, also those that ended by the limit. Travel is the time before the object "
      "was in straight sight (or the whole search where it never was), and detection is the rest, so that travel and "
      "detection make the time searched. The detour is the way walked over the shortest way, from cell to cell, to "
      "where the search ended; corners that are cut can make it less than 1. Standing is less than 0.05 m/s. Rows of "
      "some searches alone, such as those with straight sight, compare different searches in the two views. Each "
      "subject counts once, with its mean; intervals are for other subjects with the same cases."});
  addPart(work, "The figure of ways, sight and turns", [&] { addFigure(work, groups); });
  for (const NavigationGroup& group : groups) {
    addPart(work, fmt::format("Searches for {} objects", group.moving ? "moving" : "stationary"),
            [&] { addNavigationTables(work, group); });
  }
  addPart(work, "Where subjects were", [&] { addHeatMaps(work, task, navigation.heatMaps); });
  work.methods.push_back(
      "Ways, turns and times in sight were taken from the log of where subjects stood; views were compared by the mean "
      "differences of subjects, with Student's intervals.");
}

}  // namespace ocelli
