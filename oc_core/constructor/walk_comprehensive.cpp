#include "oc_core/constructor/walk_comprehensive.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "oc_core/base/error.h"
#include "oc_core/camera/graph_overlap.h"
#include "oc_core/constructor/frustum_image.h"
#include "oc_core/constructor/walk_piece.h"
#include "oc_core/constructor/walk_start.h"
#include "oc_core/constructor/walk_tour.h"

namespace ocelli {
namespace {

constexpr const char* kWalkComprehensive = "comprehensive camera";
/// By which the weight of a cell grows from build to build while its middle has too few pixels.
constexpr double kGrowth = 2;
/// So many starts are tried where none is given: until all cells are seen.
constexpr size_t kStarts = 16;
/// Of the overlap that counts, how much of it regions may have.
constexpr double kAllowedOverlap = 0.25;

double pixelsOf(const GraphCamera::Part& part) {
  double twice = 0;
  for (size_t i = 0; i < part.size(); ++i) {
    const glm::dvec2& a = part[i];
    const glm::dvec2& b = part[(i + 1) % part.size()];
    twice += a.x * b.y - a.y * b.x;
  }
  return twice / 2;
}

size_t unseenCells(const ComprehensiveWalk& walk) {
  return static_cast<size_t>(std::count_if(walk.cells.begin(), walk.cells.end(), [](const WalkCellView& view) {
    return view.unseen != WalkUnseen::kNothing;
  }));
}

/// Whether a larger share of the rays may help.
bool mayNeedMore(const WalkCellView& view) {
  return view.unseen == WalkUnseen::kTooFewPixels || view.unseen == WalkUnseen::kNoRays;
}

class WalkBuilder {
 public:
  WalkBuilder(const WalkMap& map, const WalkComprehensiveOptions& options, const WalkStart& start, int width,
              int height)
      : map_(map), options_(options), width_(width), height_(height), regions_(walkRegionsOf(map)), start_(start) {
    raiseTops();
    if (regions_[start_.cell].border.empty()) {
      throw InputError(nameOfCell(start_.cell) + " has no floor", kWalkComprehensive, "begin in another cell");
    }
    tour_ = walkTourOf(regions_, start_.cell, options.order);
    fit();
    reachable_ = reachable();
    // Small cells need more than their share of the floor.
    double sum = 0;
    for (const WalkRegion& region : regions_) {
      sum += std::max(planArea(region.border), 0.0);
    }
    for (const WalkRegion& region : regions_) {
      floors_.push_back(std::sqrt(std::max(planArea(region.border), 0.0) * sum / static_cast<double>(regions_.size())));
    }
  }

  ComprehensiveWalk best() {
    std::vector<double> weights = floors_;
    std::optional<ComprehensiveWalk> best;
    size_t fewest = 0;
    for (int build = 0; build < options_.builds; ++build) {
      ComprehensiveWalk walk = built(weights);
      size_t few = 0;
      for (const WalkCellView& view : walk.cells) {
        few += mayNeedMore(view) ? 1 : 0;
      }
      for (size_t i = 0; i < weights.size(); ++i) {
        weights[i] *= mayNeedMore(walk.cells[regions_[i].cell]) ? kGrowth : 1;
      }
      if (!best || few < fewest) {
        fewest = few;
        best = std::move(walk);
      }
      if (fewest == 0) {
        break;
      }
    }
    return *best;
  }

 private:
  /// Of all openings, where one sees over walls.
  void raiseTops() {
    for (WalkRegion& region : regions_) {
      for (WalkExit& exit : region.exits) {
        exit.mouth.top = exit.mouth.floor + exit.mouth.height() * options_.eyeHeight;
      }
    }
  }

  /// Cuts the regions so that none reaches into another that comes before it.
  void fit() {
    glm::dvec3 lower(std::numeric_limits<double>::infinity());
    glm::dvec3 upper(-lower);
    for (const WalkRegion& region : regions_) {
      for (const glm::dvec2& corner : region.border) {
        lower = glm::min(lower, spaceOf(corner, region.floorAt(corner)));
        upper = glm::max(upper, spaceOf(corner, region.floorAt(corner) + region.height));
      }
    }
    const double allowed = kAllowedOverlap * kMinOverlap * glm::distance(lower, upper);
    std::vector<const WalkRegion*> before;
    for (const uint32_t region : tour_.order) {
      cutToFit(regions_[region], map_, before, allowed);
      before.push_back(&regions_[region]);
      const WalkCell& cell = map_.cells[regions_[region].cell];
      reach_ += 2 * (static_cast<double>(cell.halfLength) + static_cast<double>(cell.halfWidth));
    }
  }

  /// The opening to the next region on the tour, if it is still there after regions were cut.
  const WalkExit* exitTo(uint32_t region, uint32_t next) const {
    const uint32_t portal = tour_.stops[next].way.portal;
    for (const WalkExit& exit : regions_[region].exits) {
      if (exit.portal == portal && exit.region == next) {
        return &exit;
      }
    }
    return nullptr;
  }

  /// What was built of a region.
  struct Built {
    WalkUnseen why = WalkUnseen::kNoWay;  ///< no rays come into it
    PieceRays rays{};                     ///< that do
    std::vector<int> frusta{};
  };

  /// Whether rays can come into each region: there is something of it, and an opening to it from one that can be
  /// reached.
  std::vector<bool> reachable() const {
    std::vector<bool> can(regions_.size(), false);
    for (const uint32_t region : tour_.order) {
      const int parent = tour_.stops[region].parent;
      const bool led =
          parent < 0 || (can[static_cast<size_t>(parent)] && exitTo(static_cast<uint32_t>(parent), region) != nullptr);
      can[region] = led && !regions_[region].border.empty();
    }
    return can;
  }

  ComprehensiveWalk built(const std::vector<double>& weights) const {
    std::vector<double> after(weights);  // with the region itself, and those after it that can be reached
    for (size_t i = tour_.order.size(); i-- > 1;) {
      const uint32_t region = tour_.order[i];
      after[static_cast<size_t>(tour_.stops[region].parent)] += reachable_[region] ? after[region] : 0;
    }
    const WalkRegion& first = regions_[start_.cell];
    WalkBeginning beginning = beginWalk(first, start_, options_.eyeHeight, reach_, width_, height_);
    std::vector<Built> all(regions_.size());
    all[start_.cell].rays = {GraphCamera::kRoot, beginning.entry, 0};
    for (const uint32_t region : tour_.order) {
      all[region].why = reasonAt(all, region);
      if (all[region].why == WalkUnseen::kNothing) {
        addRegion(beginning.camera, all, region, region == start_.cell ? beginning.ahead : regions_[region].border,
                  weights, after);
      }
    }
    limitRoot(beginning.camera, beginning.entry, first.size);
    ComprehensiveWalk walk{std::move(beginning.camera), start_, std::vector<WalkCellView>(map_.cells.size())};
    for (uint32_t i = 0; i < regions_.size(); ++i) {
      tell(walk, all[i], i);
    }
    for (WalkCellView& view : walk.cells) {
      const bool shown = view.turns > 0;
      if (shown) {
        view.unseen = view.pixels >= options_.minPixels ? WalkUnseen::kNothing : WalkUnseen::kTooFewPixels;
      }
    }
    return walk;
  }

  /// Why no rays come into a region.
  WalkUnseen reasonAt(const std::vector<Built>& all, uint32_t region) const {
    const int parent = tour_.stops[region].parent;
    if (regions_[region].border.empty()) {
      return WalkUnseen::kOverlap;
    }
    if (all[region].rays.frustum >= 0) {
      return WalkUnseen::kNothing;
    }
    const Built& before = all[static_cast<size_t>(parent)];
    if (before.why != WalkUnseen::kNothing) {
      return before.why;
    }
    if (exitTo(static_cast<uint32_t>(parent), region) == nullptr) {
      return WalkUnseen::kNoOpening;
    }
    return before.rays.turns + 1 >= GraphCamera::kMaxBends ? WalkUnseen::kTooManyTurns : WalkUnseen::kNoRays;
  }

  void addRegion(GraphCamera& camera, std::vector<Built>& all, uint32_t region, const PlanPolygon& border,
                 const std::vector<double>& weights, const std::vector<double>& after) const {
    std::vector<PieceExit> exits;
    std::vector<uint32_t> next;
    for (const uint32_t child : tour_.stops[region].next) {
      const WalkExit* exit = reachable_[child] ? exitTo(region, child) : nullptr;
      if (exit != nullptr) {
        exits.push_back({exit->mouth, after[child]});
        next.push_back(child);
      }
    }
    const PieceFans fans = addPiece(camera, regions_[region], border, all[region].rays.frustum, all[region].rays.mouth,
                                    exits, {weights[region] * options_.nearness, options_.evenness});
    for (size_t i = 0; i < next.size(); ++i) {
      all[next[i]].rays = fans.exits[i];
    }
    all[region].frusta = fans.frusta;
  }

  /// Adds what a region shows of its cell.
  void tell(ComprehensiveWalk& walk, const Built& built, uint32_t region) const {
    const uint32_t cell = regions_[region].cell;
    WalkCellView& view = walk.cells[cell];
    if (region == cell) {
      view.unseen = built.why;
    }
    if (built.why != WalkUnseen::kNothing) {
      return;
    }
    const int parent = tour_.stops[region].parent;
    const bool entered = parent < 0 || regions_[static_cast<size_t>(parent)].cell != cell;
    if (entered) {
      view.parent = parent < 0 ? -1 : static_cast<int>(regions_[static_cast<size_t>(parent)].cell);
    }
    view.turns = view.turns > 0 ? std::min(view.turns, built.rays.turns + 1) : built.rays.turns + 1;
    const std::vector<glm::dvec3> middle = middleOf(map_.cells[cell]);
    const glm::dvec3 center(map_.cells[cell].center);
    const int atCenter = view.center ? -1 : walk.camera.frustumOf(center);
    for (const int i : built.frusta) {
      const GraphCamera::Frustum& frustum = walk.camera.frusta()[static_cast<size_t>(i)];
      view.pixels += std::max(pixelsOf(frustumImage(walk.camera, i, middle)), 0.0);
      if (atCenter == i) {
        const glm::dvec4 h = frustum.pixelFromWorld * glm::dvec4(center, 1);
        view.center = glm::dvec2(h) / h.w;
      }
    }
  }

  static void limitRoot(GraphCamera& camera, const WalkMouth& entry, double size) {
    camera.limit(GraphCamera::kRoot, Plane::through(spaceOf(entry.left + entry.ahead() * (kWalkBeyond * size), 0),
                                                    spaceOf(entry.ahead(), 0)));
  }

  const WalkMap& map_;
  const WalkComprehensiveOptions& options_;
  int width_;
  int height_;
  std::vector<WalkRegion> regions_;
  WalkStart start_;
  WalkTour tour_;
  std::vector<bool> reachable_;  ///< of each region
  std::vector<double> floors_;   ///< of each region: its weight at first
  double reach_ = 0;
};

void checkWalkOptions(const WalkMap& map, const WalkComprehensiveOptions& options) {
  if (map.cells.empty()) {
    throw InputError("the scene has no floor to walk on", kWalkComprehensive, "use another scene, or another camera");
  }
  if (options.start && options.start->cell >= map.cells.size()) {
    throw InputError("the map has no " + nameOfCell(options.start->cell) + " to begin in", kWalkComprehensive,
                     fmt::format("cells are 0 to {}", map.cells.size() - 1));
  }
  if (options.start && !(glm::length(planOf(options.start->heading)) > 1e-6)) {
    throw InputError("the heading is not level, or not finite", kWalkComprehensive, "give a level one");
  }
  const auto range = [](double value, double least, double most, const char* name) {
    if (!(value >= least && value <= most)) {
      throw InputError(fmt::format("\"{}\" is {}, and must be from {} to {}", name, value, least, most),
                       kWalkComprehensive, "change it");
    }
  };
  range(options.nearness, 0.01, 100, "nearness");
  range(options.evenness, 0, 1, "evenness");
  range(options.eyeHeight, 1, 10, "eye_height");
  range(options.minPixels, 0, 1e6, "min_pixels");
  range(options.builds, 1, 100, "builds");
}

}  // namespace

const char* textOf(WalkUnseen why) {
  static constexpr std::array<const char*, 7> kTexts{
      "it is seen",
      "no way leads there from the start",
      "the opening to it does not lie on the border of the cell before it",
      "the map has it where another cell lies already",
      "rays turn too often on the way",
      "no rays come in",
      "too few pixels are left for it"};
  return kTexts[static_cast<size_t>(why)];
}

std::vector<glm::dvec3> middleOf(const WalkCell& cell) {
  const double half = static_cast<double>(std::min(cell.halfLength, cell.halfWidth)) / 2;
  const glm::dvec3 rise(0, static_cast<double>(cell.floorRise) / (2 * static_cast<double>(cell.halfLength)), 0);
  const glm::dvec3 along = (glm::dvec3(cell.axis) + rise) * half;
  const glm::dvec3 across = glm::dvec3(cell.right()) * half;
  const glm::dvec3 center(cell.center);
  return {center + along - across, center + along + across, center - along + across, center - along - across};
}

ComprehensiveWalk makeComprehensiveWalk(const WalkMap& map, const WalkComprehensiveOptions& options, int width,
                                        int height) {
  checkWalkOptions(map, options);
  const std::vector<WalkStart> starts =
      options.start ? std::vector<WalkStart>{*options.start} : chooseWalkStarts(map, walkRegionsOf(map), kStarts);
  if (starts.empty()) {
    throw InputError("no cell of the map has floor", kWalkComprehensive, "use another map, or another camera");
  }
  std::optional<ComprehensiveWalk> best;
  for (const WalkStart& start : starts) {
    ComprehensiveWalk walk = WalkBuilder(map, options, start, width, height).best();
    if (!best || unseenCells(walk) < unseenCells(*best)) {
      best = std::move(walk);
    }
    if (unseenCells(*best) == 0) {
      break;
    }
  }
  return *std::move(best);
}

}  // namespace ocelli
