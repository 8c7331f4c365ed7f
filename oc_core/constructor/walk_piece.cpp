#include "oc_core/constructor/walk_piece.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numeric>

#include "oc_core/base/error.h"
#include "oc_core/constructor/frustum_image.h"

namespace ocelli {
namespace {

/// An exit whose middle lies more than so many times as far aside of the entry as ahead of it is reached from aside.
constexpr double kSteep = 1.2;
constexpr size_t kMaxParts = 8;  // beside each other
/// Of the height that rays keep on the way to an exit that is taller than the entry: the rest shows the floor.
constexpr double kTallerShare = 0.9;
/// Nearest viewpoints of the first and last fan, in widths of the entry.
constexpr double kNearest = 0.3;
/// How far ahead of the entry exits lie at least, for the height of rays, in widths of the entry.
constexpr double kMinDepth = 0.01;
/// An exit whose near end lies ahead by less than this share of what its far end does: its rays are level, where they
/// then meet at least so much of its height.
constexpr double kOblique = 0.5;
constexpr double kMinLevelShare = 0.3;

size_t turnsOf(const GraphCamera& camera, int i) {
  size_t turns = 0;
  for (; i != GraphCamera::kRoot; i = camera.frusta()[static_cast<size_t>(i)].parent) {
    ++turns;
  }
  return turns;
}

/// A region, or a part of it, with the entry that its rays come in by.
class RegionParts {
 public:
  RegionParts(GraphCamera& camera, const WalkRegion& region, const PieceSharing& sharing, PieceFans& fans)
      : camera_(camera), region_(region), sharing_(sharing), fans_(fans) {}

  /// `numbers` are those of the exits in the list of all.
  void add(const PlanPolygon& border, int frustum, const WalkMouth& entry, std::vector<PieceExit> exits,
           std::vector<int> numbers, size_t parts) {
    const EntryFrame frame(entry);
    const double width = entry.width();
    PlanPolygon rest = border;
    struct Beside {
      PlanPolygon border;
      std::vector<PieceExit> exits;
      std::vector<int> numbers;
    };
    std::vector<Beside> beside;
    std::vector<WalkMouth> cuts;
    for (const bool left : {true, false}) {
      const std::optional<double> line = parts < kMaxParts ? lineBeside(frame, width, exits, left) : std::nullopt;
      if (!line) {
        continue;
      }
      const glm::dvec2 on = frame.inPlan({*line, 0});
      const glm::dvec2 further = frame.inPlan({*line, 1});
      const glm::dvec2& from = left ? further : on;
      const glm::dvec2& to = left ? on : further;
      Beside part{planRightOf(rest, from, to), {}, {}};
      const auto span = planSpan(part.border, on, further, 1e-6 * region_.size);
      const PlanPolygon kept = planRightOf(rest, to, from);
      if (part.border.empty() || kept.empty() || !span || !(span->second - std::max(span->first, 0.0) > 1e-3 * width)) {
        continue;
      }
      PieceExit through;
      const double first = std::max(span->first, 0.0);
      through.mouth.left = frame.inPlan({*line, left ? first : span->second});
      through.mouth.right = frame.inPlan({*line, left ? span->second : first});
      through.mouth.floor = region_.floorAt(through.mouth.middle());
      through.mouth.top = through.mouth.floor + std::max(region_.height, entry.height());
      through.weight = ownWeight(part.border);
      std::vector<PieceExit> keptExits;
      std::vector<int> keptNumbers;
      for (size_t i = 0; i < exits.size(); ++i) {
        const double x = frame.inFrame(exits[i].mouth.middle()).x;
        const bool aside = left ? x < *line : x > *line;
        (aside ? part.exits : keptExits).push_back(exits[i]);
        (aside ? part.numbers : keptNumbers).push_back(numbers[i]);
        through.weight += aside ? exits[i].weight : 0;
      }
      cuts.push_back(through.mouth);
      keptExits.push_back(through);
      keptNumbers.push_back(-1 - static_cast<int>(beside.size()));
      exits = keptExits;
      numbers = keptNumbers;
      rest = kept;
      beside.push_back(part);
    }
    for (const auto& [number, rays] : addFans(rest, frustum, entry, exits, numbers, cuts)) {
      if (number >= 0) {
        fans_.exits[static_cast<size_t>(number)] = rays;
      } else if (rays.frustum >= 0) {
        const Beside& part = beside[static_cast<size_t>(-1 - number)];
        add(part.border, rays.frustum, rays.mouth, part.exits, part.numbers, parts + 1);
      }
    }
  }

 private:
  double ownWeight(const PlanPolygon& border) const {
    return sharing_.ownWeight * planArea(border) / planArea(region_.border);
  }

  /// Where to part the region for exits to that side that rays do not reach straight; nothing where there are none, or
  /// where every line cuts an exit.
  static std::optional<double> lineBeside(const EntryFrame& frame, double width, const std::vector<PieceExit>& exits,
                                          bool left) {
    const double mirrored = left ? -1 : 1;  // distances aside of the entry are positive
    const double jamb = left ? 0 : width;
    std::vector<std::pair<double, double>> spans;
    double nearest = std::numeric_limits<double>::infinity();
    for (const PieceExit& exit : exits) {
      const glm::dvec2 a = frame.inFrame(exit.mouth.left);
      const glm::dvec2 b = frame.inFrame(exit.mouth.right);
      const double one = mirrored * (a.x - jamb);
      const double other = mirrored * (b.x - jamb);
      spans.emplace_back(std::min(one, other), std::max(one, other));
      const double aside = (one + other) / 2;
      if (aside > kSteep * std::max((a.y + b.y) / 2, 0.0) && aside > 1e-3 * width) {
        nearest = std::min(nearest, spans.back().first);
      }
    }
    if (!(nearest < std::numeric_limits<double>::infinity())) {
      return std::nullopt;
    }
    nearest = std::max(nearest, 0.0);
    std::vector<double> lines{0, nearest};
    for (const auto& [from, to] : spans) {
      lines.insert(lines.end(), {from, to});
    }
    for (const double line : lines) {
      const double rounding = 1e-6 * width;
      const bool cuts = std::any_of(spans.begin(), spans.end(), [&](const auto& span) {
        return span.first < line - rounding && span.second > line + rounding;
      });
      if (line >= 0 && line <= nearest && !cuts) {
        return jamb + mirrored * line;
      }
    }
    return std::nullopt;
  }

  std::vector<std::pair<int, PieceRays>> addFans(const PlanPolygon& border, int frustum, const WalkMouth& entry,
                                                 const std::vector<PieceExit>& exits, const std::vector<int>& numbers,
                                                 const std::vector<WalkMouth>& cuts) {
    const EntryFrame frame(entry);
    const double width = entry.width();
    std::vector<WalkMouth> mouths;
    for (const PieceExit& exit : exits) {
      mouths.push_back(exit.mouth);
    }
    std::vector<FanAim> aims = aimsOf(frame, width, mouths);
    share(aims, frame, border, width, exits);
    const std::vector<FanRay> rays = spreadRays(aims, width);
    std::vector<std::pair<int, PieceRays>> reached;
    for (size_t k = 0; k < aims.size(); ++k) {
      const PieceRays added = addFan(frame, frustum, entry, aims[k], rays[k], rays[k + 1], exits);
      if (added.frustum >= 0) {
        fans_.frusta.push_back(added.frustum);
        for (const WalkMouth& cut : cuts) {
          limitTo(added.frustum, cut);
        }
      }
      if (aims[k].exit >= 0) {
        reached.emplace_back(numbers[static_cast<size_t>(aims[k].exit)], added);
      }
    }
    return reached;
  }

  /// Shares of the entry, and how far behind it the outer viewpoints lie.
  void share(std::vector<FanAim>& aims, const EntryFrame& frame, const PlanPolygon& border, double width,
             const std::vector<PieceExit>& exits) const {
    const double own = ownWeight(border);
    double after = 0;
    double sum = 0;
    for (const PieceExit& exit : exits) {
      after += exit.weight;
      sum += std::pow(exit.weight, sharing_.evenness);
    }
    const double scale = after > 0 ? std::sqrt(after / (after + own)) : 0;  // of a length at the exit
    double walls = 0;
    for (FanAim& aim : aims) {
      if (aim.exit >= 0) {
        const double weight = exits[static_cast<size_t>(aim.exit)].weight;
        aim.share = scale > 0 ? scale * std::pow(weight, sharing_.evenness) / sum : 0;
      } else {
        aim.share = glm::distance(aim.begin, aim.end);
        walls += aim.share;
      }
    }
    for (FanAim& aim : aims) {
      if (aim.exit < 0 && walls > 0) {
        aim.share *= (1 - scale) / walls;
      }
    }
    glm::dvec2 least(0);
    glm::dvec2 most(0);
    for (const glm::dvec2& corner : border) {
      least = glm::min(least, frame.inFrame(corner));
      most = glm::max(most, frame.inFrame(corner));
    }
    for (const size_t k : {size_t{0}, aims.size() - 1}) {
      FanAim& aim = aims[k];
      if (aim.exit >= 0) {
        const WalkMouth& out = exits[static_cast<size_t>(aim.exit)].mouth;
        const double ahead = std::max(frame.inFrame(out.middle()).y, 1e-3 * width);
        aim.distance = std::max(kNearest * width, ahead * scale / (1 - std::min(scale, 0.999)));
      } else if (aims.size() == 1) {
        // Over the width of the region at half of its depth.
        aim.distance = width * (most.y / 2) / std::max(most.x - least.x, 1e-3 * width);
      } else {
        // From the exit beside it on to the side of the region, as far ahead as a third of its depth.
        const double strip = aim.share * width;
        const double aside = (k == 0 ? -least.x : most.x - width) / std::max(most.y / 3, 1e-3 * width);
        const glm::dvec2 inner = k == 0 ? aim.end : aim.begin;
        const double slope = k == 0 ? (inner.x - strip) / inner.y : (width - strip - inner.x) / inner.y;
        aim.distance = aside + slope > 0 ? strip / (aside + slope) : width;
      }
      aim.distance = std::clamp(aim.distance, kNearest * width, 100 * width);
    }
  }

  PieceRays addFan(const EntryFrame& frame, int frustum, const WalkMouth& entry, const FanAim& aim, const FanRay& left,
                   const FanRay& right, const std::vector<PieceExit>& exits) {
    const double width = entry.width();
    const std::optional<glm::dvec2> from = fanViewpoint(left, right, width);
    if (!from) {
      return {};
    }
    const double beyond = kWalkBeyond * region_.size;
    const auto at = [&](double x, double z, double height) { return spaceOf(frame.inPlan({x, z}), height); };
    const double behind = -from->y;
    double ahead = std::max((aim.begin.y + aim.end.y) / 2, kMinDepth * width);
    // A ray along the top of the entry, and what it meets ahead.
    PieceRays rays;
    double top = entry.top;
    if (aim.exit >= 0) {
      // Not between the ends of the aim: the first begins at the entry, and the last ends there.
      const WalkMouth& out = exits[static_cast<size_t>(aim.exit)].mouth;
      const double one = frame.inFrame(out.left).y;
      const double other = frame.inFrame(out.right).y;
      const double near = std::max(std::min(one, other), kMinDepth * width);
      ahead = std::max({one, other, kMinDepth * width});  // the far end: nothing nearer lies above the rays
      rays.mouth = out;
      const double keeps = behind / (behind + near);
      const double most = std::max(entry.height(), kTallerShare * entry.height() / keeps);
      rays.mouth.top = out.floor + std::min(out.height(), most);
      const bool isOblique = near < kOblique * ahead;
      if (isOblique && entry.top > out.floor + kMinLevelShare * out.height()) {
        rays.mouth.top = std::min(rays.mouth.top, entry.top);  // level, so that its near end is seen too
      }
      top = rays.mouth.top;
    } else {
      top += region_.floorAt(frame.inPlan((aim.begin + aim.end) / 2.0)) - region_.floorAt(entry.middle());
    }
    const glm::dvec3 viewpoint = at(from->x, from->y, entry.top - (top - entry.top) * behind / ahead);
    const glm::dvec3 up(0, entry.height(), 0);
    const glm::dvec3 a = at(left.at + left.slope * beyond, beyond, entry.floor);
    const glm::dvec3 b = at(right.at + right.slope * beyond, beyond, entry.floor);
    const Plane plane = Plane::through(at(0, beyond, 0), spaceOf(frame.ahead, 0));
    rays.frustum = bendWhereOneCan(camera_, frustum, {plane, viewpoint}, nameOfCell(region_.cell),
                                   frustumImage(camera_, frustum, std::array{a, b, b + up, a + up}));
    if (rays.frustum < 0) {
      return {};
    }
    for (const Plane& limit : region_.limits) {
      limitFrustum(rays.frustum, limit);
    }
    if (aim.exit >= 0) {
      limitTo(rays.frustum, rays.mouth);
    }
    rays.turns = turnsOf(camera_, rays.frustum);
    return rays;
  }

  void limitTo(int i, const WalkMouth& mouth) {
    const glm::dvec2 out = mouth.ahead();
    limitFrustum(i, Plane::through(spaceOf(mouth.left + out * (kWalkIntoWalls * region_.size), 0), spaceOf(out, 0)));
  }
  /// Where the middle of its rays begins within the limit.
  void limitFrustum(int i, const Plane& limit) {
    try {
      camera_.limit(i, limit);
    } catch (const InputError&) {
      // Rays begin beyond it, as above a floor that slopes down from the opening: it is no limit for them.
    }
  }

  GraphCamera& camera_;
  const WalkRegion& region_;
  const PieceSharing& sharing_;
  PieceFans& fans_;
};

}  // namespace

PieceFans addPiece(GraphCamera& camera, const WalkRegion& region, const PlanPolygon& border, int frustum,
                   const WalkMouth& entry, const std::vector<PieceExit>& exits, const PieceSharing& sharing) {
  PieceFans fans;
  fans.exits.resize(exits.size());
  std::vector<int> numbers(exits.size());
  std::iota(numbers.begin(), numbers.end(), 0);
  RegionParts(camera, region, sharing, fans).add(border, frustum, entry, exits, numbers, 0);
  return fans;
}

}  // namespace ocelli
