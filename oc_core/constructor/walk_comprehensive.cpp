#include "oc_core/constructor/walk_comprehensive.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <memory>

#include "oc_core/base/error.h"
#include "oc_core/constructor/frustum_image.h"
#include "oc_core/constructor/image_parts.h"
#include "oc_core/constructor/walk_lanes.h"
#include "oc_core/constructor/walk_piece.h"
#include "oc_core/constructor/walk_sight.h"
#include "oc_core/constructor/walk_start.h"
#include "oc_core/constructor/walk_tour.h"

namespace ocelli {
namespace {

constexpr const char* kWalkComprehensive = "comprehensive camera";
/// By which the weight of a cell grows or shrinks at most from build to build.
constexpr double kGrowth = 2;
/// Of the way to the weight that would give it what it should have, as areas are not as weights are: in logarithms.
constexpr double kFollow = 0.5;
/// Pixels of a middle of which as many more mean little.
constexpr double kEnough = 60;
/// Exits that fewer rays get to by any lane are avoided, if there is another way.
constexpr double kBlocked = 0.03;
/// Of the height of a cell: floors that rise less are level.
constexpr float kLevel = 0.2f;
/// Of the pixels of a lane: where it shows the middle of its region with so many, more are not worth more.
constexpr double kMiddleShare = 0.05;
/// Estimates of more pixels than that are not counted again.
constexpr double kSurely = 200;
/// So many starts are tried where none is given: until all cells are seen.
constexpr size_t kStarts = 16;
/// Where rays tell what is seen, so many of them are tried in all builds: those whose first images lack least.
constexpr size_t kSeenStarts = 4;

/// What cells lack: 1 for each that is not seen, and up to 1 for its pixels, half of it for one with kEnough.
double lackingIn(const ComprehensiveWalk& walk) {
  double lacking = 0;
  for (const WalkCellView& view : walk.cells) {
    lacking += 1 / (1 + view.seenPixels / kEnough) + (view.unseen == WalkUnseen::kNothing ? 0 : 1);
  }
  return lacking;
}

/// Of a cell that rays come to.
void judge(WalkCellView& view, double minPixels) {
  if (view.seenPixels >= minPixels) {
    view.unseen = WalkUnseen::kNothing;
  } else if (view.turns > 0) {
    view.unseen = view.pixels < minPixels ? WalkUnseen::kTooFewPixels : WalkUnseen::kHidden;
  }
}

class WalkBuilder {
 public:
  WalkBuilder(const WalkMap& map, const WalkComprehensiveOptions& options, const WalkStart& start, int width,
              int height, const WalkSight* sight, WalkLanes& lanes)
      : map_(map),
        options_(options),
        width_(width),
        height_(height),
        sight_(sight),
        lanes_(lanes),
        regions_(walkBoxesOf(map)),
        start_(start) {
    raiseTops();
    if (regions_[start_.cell].border.empty()) {
      throw InputError(nameOfCell(start_.cell) + " has no floor", kWalkComprehensive, "begin in another cell");
    }
    avoidBlocked();
    for (const uint32_t region : tour_.order) {
      const WalkCell& cell = map_.cells[regions_[region].cell];
      reach_ += 2 * (static_cast<double>(cell.halfLength) + static_cast<double>(cell.halfWidth));
    }
    // Small cells need more than their share of the floor.
    double sum = 0;
    for (const WalkRegion& region : regions_) {
      sum += std::max(planArea(region.border), 0.0);
    }
    for (const WalkRegion& region : regions_) {
      floors_.push_back(std::sqrt(std::max(planArea(region.border), 0.0) * sum / static_cast<double>(regions_.size())));
    }
  }

  /// Tries lanes in all regions until the best of each is known, and builds with these, once.
  ComprehensiveWalk first() {
    do {
      isTrying_ = false;
      built(floors_, Looks::kAtLanes);
    } while (isTrying_);
    avoidBlocked();
    return built(floors_, Looks::kAtAll);
  }

  /// Of builds with weights that follow what is seen.
  ComprehensiveWalk best() {
    std::vector<double> weights = floors_;
    std::optional<ComprehensiveWalk> best;
    double least = 0;
    for (int build = 0; build < options_.builds; ++build) {
      ComprehensiveWalk walk = built(weights, Looks::kAtAll);
      share(weights, walk);
      const double lacking = lackingIn(walk);
      if (!best || lacking < least) {
        least = lacking;
        best = std::move(walk);
      }
    }
    return *std::move(best);
  }

 private:
  /// How rays go through a region to an exit.
  LaneWay wayOf(const WalkTour::Stop& stop, uint32_t region, uint32_t exit) const {
    return {region, stop.parent < 0 ? UINT32_MAX : stop.way.portal, exit};
  }
  bool isBlocked(const WalkTour::Stop& stop, const WalkExit& exit, uint32_t region) const {
    return sight_ != nullptr && lanes_.freeOf(wayOf(stop, region, exit.portal)) < kBlocked;
  }
  /// Another tour, where lanes that are blocked can be avoided.
  void avoidBlocked() {
    tour_ = walkTourOf(regions_, start_.cell, options_.order,
                       [&](const WalkTour::Stop& stop, const WalkExit& exit, uint32_t region) {
                         return isBlocked(stop, exit, region);
                       });
    reachable_ = reachable();
  }

  /// Moves weights towards those of cells whose middles have fewer pixels than others for their size.
  void share(std::vector<double>& weights, const ComprehensiveWalk& walk) const {
    // The mean over cells, of logarithms.
    double sum = 0;
    size_t shown = 0;
    for (size_t i = 0; i < walk.cells.size(); ++i) {
      if (walk.cells[i].pixels > 0) {
        sum += std::log(walk.cells[i].pixels / middleSize(i));
        ++shown;
      }
    }
    const double mean = shown > 0 ? std::exp(sum / static_cast<double>(shown)) : 1;
    for (size_t i = 0; i < weights.size(); ++i) {
      const uint32_t cell = regions_[i].cell;
      const WalkCellView& view = walk.cells[cell];
      const double wanted = mean * middleSize(cell);
      const double factor = view.pixels > 0 ? std::pow(wanted / view.pixels, kFollow) : kGrowth;
      weights[i] *= std::clamp(factor, 1 / kGrowth, kGrowth);
    }
  }
  double middleSize(size_t cell) const {
    return std::max(1e-9, static_cast<double>(std::min(map_.cells[cell].halfLength, map_.cells[cell].halfWidth)));
  }

  /// Of all openings, where one sees over walls.
  void raiseTops() {
    for (WalkRegion& region : regions_) {
      for (WalkExit& exit : region.exits) {
        exit.mouth.top = exit.mouth.floor + exit.mouth.height() * options_.eyeHeight;
      }
    }
  }

  /// The opening to the next region on the tour.
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
    std::vector<uint32_t> next{};    ///< regions that its rays go on to
    std::vector<PieceRays> exits{};  ///< of each of them
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

  /// Rays are cast, if there is a scene, for lanes alone, or for what is seen as well.
  enum class Looks { kAtLanes, kAtAll };

  ComprehensiveWalk built(const std::vector<double>& weights, Looks looks) {
    std::vector<double> after(weights);  // with the region itself, and those after it that can be reached
    for (size_t i = tour_.order.size(); i-- > 1;) {
      const uint32_t region = tour_.order[i];
      after[static_cast<size_t>(tour_.stops[region].parent)] += reachable_[region] ? after[region] : 0;
    }
    const WalkRegion& first = regions_[start_.cell];
    WalkBeginning beginning = beginWalk(first, start_, options_.eyeHeight, reach_, width_, height_);
    std::vector<Built> all(regions_.size());
    all[start_.cell].rays = {GraphCamera::kRoot, GraphCamera::kRoot, beginning.entry, 0};
    for (const uint32_t region : tour_.order) {
      all[region].why = reasonAt(all, region);
      if (all[region].why == WalkUnseen::kNothing) {
        addRegion(beginning.camera, all, region, region == start_.cell ? beginning.ahead : regions_[region].border,
                  weights, after);
      }
    }
    limitRoot(beginning.camera, beginning.entry, first.size);
    noteLanes(beginning.camera, all);
    ComprehensiveWalk walk{std::move(beginning.camera), start_, std::vector<WalkCellView>(map_.cells.size()), {}};
    walk.cellOfFrustum.assign(walk.camera.frusta().size(), static_cast<int>(start_.cell));
    for (uint32_t i = 0; i < regions_.size(); ++i) {
      tell(walk, all[i], i, looks == Looks::kAtAll ? sight_ : nullptr);
    }
    for (WalkCellView& view : walk.cells) {
      judge(view, options_.minPixels);
    }
    return walk;
  }

  /// What each lane of an image is worth.
  void noteLanes(const GraphCamera& camera, const std::vector<Built>& all) {
    for (uint32_t region = 0; sight_ != nullptr && region < all.size(); ++region) {
      for (size_t i = 0; i < all[region].next.size(); ++i) {
        const LaneWay way = wayOf(tour_.stops[region], region, tour_.stops[all[region].next[i]].way.portal);
        const WalkLanes::Found found = foundIn(camera, all[region].exits[i], map_.cells[regions_[region].cell]);
        isTrying_ = lanes_.note(way, lanes_.laneOf(way), found) || isTrying_;
      }
    }
  }

  WalkLanes::Found foundIn(const GraphCamera& camera, const PieceRays& rays, const WalkCell& cell) const {
    if (rays.frustum < 0) {
      return {};
    }
    const double free = sight_->throughShare(camera, rays.first, rays.frustum, rays.mouth);
    if (std::abs(cell.floorRise) < kLevel * cell.height) {
      return {free, 1};  // other rays see level floors; those that go up or down stairs may pass over all of it
    }
    double floor = 0;
    for (int i = rays.frustum;; i = camera.frusta()[static_cast<size_t>(i)].parent) {
      floor += sight_->pixelsOfMiddle(camera, rays.first, i, cell);
      if (i == rays.first) {
        break;
      }
    }
    const double all = areaOf(camera.frusta()[static_cast<size_t>(rays.first)].part);
    return {free, std::min(1.0, floor / std::max(kMiddleShare * all, 1e-9))};
  }

  /// Why no rays come into a region.
  WalkUnseen reasonAt(const std::vector<Built>& all, uint32_t region) const {
    const int parent = tour_.stops[region].parent;
    if (regions_[region].border.empty()) {
      return WalkUnseen::kNoFloor;
    }
    if (all[region].rays.frustum >= 0) {
      return WalkUnseen::kNothing;
    }
    const Built& before = all[static_cast<size_t>(parent)];
    if (before.why != WalkUnseen::kNothing) {
      return before.why;
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
        const size_t lane = lanes_.laneOf(wayOf(tour_.stops[region], region, exit->portal));
        exits.push_back({exit->mouth, after[child], walkLanes()[lane]});
        next.push_back(child);
      }
    }
    const PieceFans fans = addPiece(camera, regions_[region], border, all[region].rays.frustum, all[region].rays.mouth,
                                    exits, {weights[region] * options_.nearness, options_.evenness});
    for (size_t i = 0; i < next.size(); ++i) {
      all[next[i]].rays = fans.exits[i];
    }
    all[region].frusta = fans.frusta;
    all[region].next = next;
    all[region].exits = fans.exits;
  }

  /// Adds what a region shows of its cell.
  void tell(ComprehensiveWalk& walk, const Built& built, uint32_t region, const WalkSight* sight) const {
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
    for (const int i : built.frusta) {
      walk.cellOfFrustum[static_cast<size_t>(i)] = static_cast<int>(cell);
      const GraphCamera::Frustum& frustum = walk.camera.frusta()[static_cast<size_t>(i)];
      const double pixels = std::max(areaOf(frustumImage(walk.camera, i, middle)), 0.0);
      view.pixels += pixels;
      view.seenPixels += sight == nullptr ? pixels : sight->pixelsOfMiddle(walk.camera, i, map_.cells[cell]);
      const glm::dvec4 h = frustum.pixelFromWorld * glm::dvec4(center, 1);
      if (!view.center && h.w > 0 && frustum.plane.height(center) > 0) {
        const glm::dvec2 pixel = glm::dvec2(h) / h.w;
        const int child = walk.camera.childAt(i, pixel);
        const bool goesOn = child >= 0 && walk.camera.frusta()[static_cast<size_t>(child)].plane.height(center) > 0;
        if (walk.camera.childAt(frustum.parent, pixel) == i && !goesOn) {
          view.center = pixel;
        }
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
  const WalkSight* sight_;
  WalkLanes& lanes_;
  std::vector<WalkRegion> regions_;
  WalkStart start_;
  WalkTour tour_;
  bool isTrying_ = false;        ///< not all lanes that were built have been tried
  std::vector<bool> reachable_;  ///< of each region
  std::vector<double> floors_;   ///< of each region: its weight at first
  double reach_ = 0;
};

/// Counts pixel by pixel where few are seen, so that the report is right.
void confirm(ComprehensiveWalk& walk, const WalkMap& map, const WalkSight& sight, double minPixels) {
  for (size_t i = 0; i < walk.cells.size(); ++i) {
    WalkCellView& view = walk.cells[i];
    if (view.seenPixels > kSurely || view.unseen == WalkUnseen::kNoFloor) {
      continue;
    }
    // Its own frusta, and those of which some rays come in by chance.
    std::vector<int> frusta;
    for (size_t f = 0; f < walk.cellOfFrustum.size(); ++f) {
      if (walk.cellOfFrustum[f] == static_cast<int>(i) ||
          sight.pixelsOfMiddle(walk.camera, static_cast<int>(f), map.cells[i]) > 0) {
        frusta.push_back(static_cast<int>(f));
      }
    }
    const WalkSight::Middle middle = sight.count(walk.camera, map.cells[i], frusta);
    view.seenPixels = middle.pixels;
    judge(view, minPixels);
    if (view.unseen == WalkUnseen::kHidden && middle.stoppedIn >= 0) {
      view.hiddenIn = walk.cellOfFrustum[static_cast<size_t>(middle.stoppedIn)];
    }
  }
}

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
  static constexpr std::array<const char*, 7> kTexts{"it is seen",
                                                     "no way leads there from the start",
                                                     "it has no floor",
                                                     "rays turn too often on the way",
                                                     "no rays come in",
                                                     "too few pixels are left for it",
                                                     "something stands before it"};
  return kTexts[static_cast<size_t>(why)];
}

ComprehensiveWalk makeComprehensiveWalk(const WalkMap& map, const WalkComprehensiveOptions& options, int width,
                                        int height, const RayScene* scene) {
  checkWalkOptions(map, options);
  const std::vector<WalkStart> starts =
      options.start ? std::vector<WalkStart>{*options.start} : chooseWalkStarts(map, walkBoxesOf(map), kStarts);
  if (starts.empty()) {
    throw InputError("no cell of the map has floor", kWalkComprehensive, "use another map, or another camera");
  }
  const std::optional<WalkSight> sight = scene != nullptr ? std::optional<WalkSight>(*scene) : std::nullopt;
  WalkLanes lanes;
  std::vector<std::unique_ptr<WalkBuilder>> builders;
  std::vector<std::pair<double, size_t>> order;  // of builders, by what their first images lack
  for (const WalkStart& start : starts) {
    order.emplace_back(0, builders.size());
    builders.push_back(
        std::make_unique<WalkBuilder>(map, options, start, width, height, sight ? &*sight : nullptr, lanes));
    if (sight) {
      order.back().first = lackingIn(builders.back()->first());
    }
  }
  std::stable_sort(order.begin(), order.end());
  order.resize(std::min(order.size(), sight ? kSeenStarts : order.size()));
  std::optional<ComprehensiveWalk> best;
  for (const auto& [lacking, i] : order) {
    ComprehensiveWalk walk = builders[i]->best();
    if (!best || lackingIn(walk) < lackingIn(*best)) {
      best = std::move(walk);
    }
  }
  if (sight) {
    confirm(*best, map, *sight, options.minPixels);
  }
  return *std::move(best);
}

}  // namespace ocelli
