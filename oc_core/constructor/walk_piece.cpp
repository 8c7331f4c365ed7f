#include "oc_core/constructor/walk_piece.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numbers>
#include <optional>

#include "oc_core/base/error.h"
#include "oc_core/constructor/frustum_image.h"

namespace ocelli {
namespace {

/// Cosine between rays and the way out: rays that would pass an exit more obliquely turn before it. Walls are thick.
constexpr double kFrontal = 0.7;
/// How far before an exit rays turn to it at most, in depths of the region before it.
constexpr double kTurnDepths = 0.5;
/// The plane where they turn is tilted towards them by half of the turn, or so much that the exit lies beyond it.
constexpr double kTurnTilt = 1.6;
/// Walls between exits that are narrower than this, in widths of the entry, have no strip of their own.
constexpr double kMinWallStrip = 0.12;
/// Of the height that rays keep on the way to an exit that is taller than the entry: the rest shows the floor.
constexpr double kTallerShare = 0.9;
/// How far ahead of the entry exits lie at least, for the height of rays, in widths of the entry.
constexpr double kMinDepth = 0.01;
/// An exit whose near end lies ahead by less than this share of what its far end does: its rays are level, where they
/// then meet at least so much of its height.
constexpr double kOblique = 0.5;
constexpr double kMinLevelShare = 0.3;
/// What lies less far ahead than this, in distances aside, lies beside the entry. Rays to it first go into the region.
constexpr double kAhead = 0.4;
/// Rays that do not pass the middle of an exit take this share of it at most, and keep this far from borders.
constexpr double kAsideShare = 0.6;
/// Of the height of what shows of an exit, how wide it is at least, if the exit is: narrower ones stretch what is seen.
constexpr double kMinMouth = 0.25;
/// Of lengths at an exit, the least that is wanted.
constexpr double kMinScale = 0.05;
/// The least room before an exit, in its widths.
constexpr double kMinRoom = 0.2;
/// How far into a region rays to what lies beside the entry go at least, in widths of the entry.
constexpr double kMinInto = 0.3;
/// Where the outer rays meet the sides of the region, in its depths.
constexpr double kSideDepth = 0.6;
/// Of what a region has of the width for itself, the share of its walls: strips of exits show its floor, too.
constexpr double kOwnWallShare = 0.5;

size_t turnsOf(const GraphCamera& camera, int i) {
  size_t turns = 0;
  for (; i != GraphCamera::kRoot; i = camera.frusta()[static_cast<size_t>(i)].parent) {
    ++turns;
  }
  return turns;
}

/// A strip of the entry, and what its rays look at: from `begin` at its left to `end` at its right, in the frame of the
/// entry.
struct EntryStrip {
  int exit = -1;  ///< -1 for a wall
  glm::dvec2 begin{0};
  glm::dvec2 end{0};
  bool turns = false;  ///< before the exit
  double angle = 0;    ///< from the left over the way ahead to the right
  double share = 0;    ///< of the entry's width
};

class RegionPiece {
 public:
  RegionPiece(GraphCamera& camera, const WalkRegion& region, const PlanPolygon& border, const WalkMouth& entry,
              const std::vector<PieceExit>& exits, const PieceSharing& sharing)
      : camera_(camera),
        region_(region),
        border_(border),
        entry_(entry),
        frame_(entry),
        exits_(exits),
        sharing_(sharing) {
    fans_.exits.resize(exits.size());
    mouths_.resize(exits.size());
    for (const glm::dvec2& corner : border) {
      least_ = glm::min(least_, frame_.inFrame(corner));
      most_ = glm::max(most_, frame_.inFrame(corner));
    }
  }

  PieceFans add(int frustum) {
    std::vector<EntryStrip> strips = stripsOf();
    share(strips);
    narrowMouths(strips);
    double before = 0;
    for (const EntryStrip& strip : strips) {
      const double from = before * entry_.width();
      before += strip.share;
      const double to = std::min(before, 1.0) * entry_.width();
      if (strip.turns) {
        addTurn(frustum, strip, from, to);
      } else {
        const PieceRays rays = addFan(frame_, frustum, entry_, strip, rayTo(from, strip.begin), rayTo(to, strip.end));
        keep(strip, rays);
      }
    }
    return fans_;
  }

 private:
  double width() const { return entry_.width(); }

  static FanRay rayTo(double at, const glm::dvec2& point) { return {at, (point.x - at) / std::max(point.y, 1e-9)}; }

  void keep(const EntryStrip& strip, const PieceRays& rays) {
    if (rays.frustum < 0) {
      return;
    }
    fans_.frusta.push_back(rays.frustum);
    if (strip.exit >= 0) {
      fans_.exits[static_cast<size_t>(strip.exit)] = rays;
    }
  }

  /// From left to right, with no shares yet.
  std::vector<EntryStrip> stripsOf() const {
    std::vector<EntryStrip> ways;
    for (size_t i = 0; i < exits_.size(); ++i) {
      const WalkMouth& mouth = exits_[i].mouth;
      EntryStrip strip{static_cast<int>(i), frame_.inFrame(mouth.left), frame_.inFrame(mouth.right)};
      const glm::dvec2 middle = (strip.begin + strip.end) / 2.0;
      const glm::dvec2 way(middle.x - width() / 2, middle.y);
      const glm::dvec2 out(glm::dot(mouth.ahead(), frame_.right), glm::dot(mouth.ahead(), frame_.ahead));
      const double nearest = std::min(strip.begin.y, strip.end.y);
      strip.turns = exits_[i].lane.around != 0 || exits_[i].lane.straight > 0 ||
                    !(glm::dot(way, out) > kFrontal * glm::length(way)) || !(nearest > kMinDepth * width());
      strip.angle = angleOf(middle);
      ways.push_back(strip);
    }
    std::stable_sort(ways.begin(), ways.end(),
                     [](const EntryStrip& a, const EntryStrip& b) { return a.angle < b.angle; });
    // Walls between those that rays go straight on to.
    std::vector<EntryStrip> strips;
    const double deep = std::max(most_.y, kMinDepth * width());
    glm::dvec2 last(std::min(least_.x, 0.0), kSideDepth * deep);
    for (const EntryStrip& way : ways) {
      if (!way.turns) {
        addWall(strips, last, way.begin);
        last = way.end;
      }
      strips.push_back(way);
    }
    addWall(strips, last, {std::max(most_.x, width()), kSideDepth * deep});
    if (std::none_of(strips.begin(), strips.end(), [](const EntryStrip& strip) { return strip.exit < 0; })) {
      EntryStrip all{-1, {std::min(least_.x, 0.0), deep}, {std::max(most_.x, width()), deep}};
      strips.push_back(all);
    }
    std::stable_sort(strips.begin(), strips.end(),
                     [](const EntryStrip& a, const EntryStrip& b) { return a.angle < b.angle; });
    return strips;
  }

  void addWall(std::vector<EntryStrip>& strips, const glm::dvec2& begin, const glm::dvec2& end) const {
    if (glm::distance(begin, end) > kMinWallStrip * width() && angleOf(begin) < angleOf(end)) {
      strips.push_back({-1, begin, end, false, angleOf((begin + end) / 2.0)});
    }
  }

  double angleOf(const glm::dvec2& point) const {
    const double angle = std::atan2(point.y, width() / 2 - point.x);
    return angle < -std::numbers::pi / 2 ? angle + 2 * std::numbers::pi : angle;
  }

  /// Of a wide exit, the part in the middle that its strip shows at the scale that is wanted.
  void narrowMouths(std::vector<EntryStrip>& strips) {
    for (EntryStrip& strip : strips) {
      if (strip.exit < 0) {
        continue;
      }
      WalkMouth mouth = exits_[static_cast<size_t>(strip.exit)].mouth;
      const double wanted = std::max(strip.share * width() / std::max(scale_, kMinScale),
                                     kMinMouth * std::min(mouth.height(), entry_.height()));
      const double aside = exits_[static_cast<size_t>(strip.exit)].lane.aside;
      const double share = std::min(aside != 0 ? kAsideShare : 1.0, wanted / mouth.width());
      const glm::dvec2 half = (mouth.right - mouth.left) * (share / 2);
      const glm::dvec2 middle = mouth.middle() + (mouth.right - mouth.left) * (aside * (1 - share) / 2);
      mouth.left = middle - half;
      mouth.right = middle + half;
      mouths_[static_cast<size_t>(strip.exit)] = mouth;
      strip.begin = frame_.inFrame(mouth.left);
      strip.end = frame_.inFrame(mouth.right);
    }
  }

  /// The entry's width: to exits by what comes after them, to walls by their lengths.
  void share(std::vector<EntryStrip>& strips) {
    double after = 0;
    double sum = 0;
    for (const PieceExit& exit : exits_) {
      after += exit.weight;
      sum += std::pow(exit.weight, sharing_.evenness);
    }
    scale_ = after > 0 ? std::sqrt(after / (after + sharing_.ownWeight)) : 0;
    double walls = 0;
    double all = 0;
    for (EntryStrip& strip : strips) {
      strip.share = strip.exit >= 0
                        ? scale_ * std::pow(exits_[static_cast<size_t>(strip.exit)].weight, sharing_.evenness) / sum
                        : glm::distance(strip.begin, strip.end);
      walls += strip.exit >= 0 ? 0 : strip.share;
    }
    for (EntryStrip& strip : strips) {
      strip.share *= strip.exit < 0 ? kOwnWallShare * (1 - scale_) / walls : 1;
      all += strip.share;
    }
    for (EntryStrip& strip : strips) {
      strip.share /= all;
    }
  }

  /// Where rays turn on the way to an exit, and the direction in which they go on, in the plan.
  struct Turn {
    glm::dvec2 at;
    glm::dvec2 next;
  };

  /// Beside the middle of the way, in the region.
  std::optional<glm::dvec2> swerveTo(const WalkMouth& mouth, double around) const {
    const glm::dvec2 way = mouth.middle() - entry_.middle();
    const glm::dvec2 half = entry_.middle() + way / 2.0;
    const glm::dvec2 aside = glm::dvec2(-way.y, way.x) * around;
    const auto span = planSpan(border_, half, half + aside, 0);
    if (!span || !(span->second > 0)) {
      return std::nullopt;
    }
    return half + aside * std::min(1.0, kAsideShare * span->second);
  }

  std::vector<Turn> turnsTo(const WalkMouth& mouth, double whole, const PieceLane& lane, double at) const {
    const glm::dvec2 out = mouth.ahead();
    const auto deep = planSpan(border_, mouth.middle(), mouth.middle() - out, 1e-6 * region_.size);
    const double room = std::max(deep ? deep->second : whole, kMinRoom * whole);
    const glm::dvec2 before = mouth.middle() - out * std::min(lane.before * whole, kTurnDepths * room);
    const auto facesIt = [&](const glm::dvec2& from) {
      return glm::dot(glm::normalize(mouth.middle() - from), out) > kFrontal;
    };
    std::vector<Turn> turns;
    glm::dvec2 from = entry_.middle();
    const auto goTo = [&](const glm::dvec2& point, const glm::dvec2& goal) {
      from = point;
      turns.push_back({from, glm::normalize(goal - from)});
    };
    const auto goalFrom = [&](const glm::dvec2& point) { return facesIt(point) ? mouth.middle() : before; };
    const auto isAhead = [&](const glm::dvec2& inFrame) {
      return inFrame.y > kAhead * std::abs(inFrame.x - width() / 2);
    };
    const std::optional<glm::dvec2> swerve = lane.around != 0 ? swerveTo(mouth, lane.around) : std::nullopt;
    const glm::dvec2 goal = frame_.inFrame(goalFrom(from));
    if (lane.straight > 0) {
      const glm::dvec2 point = frame_.inPlan({at, lane.straight * width()});
      goTo(point, goalFrom(point));
    } else if (swerve && isAhead(frame_.inFrame(*swerve))) {
      goTo(*swerve, goalFrom(*swerve));
    } else if (!isAhead(goal)) {  // it lies beside the entry: first rays go into the region
      const glm::dvec2 point =
          frame_.inPlan({width() / 2, std::max({lane.into * most_.y, goal.y, kMinInto * width()})});
      goTo(point, goalFrom(point));
    }
    if (!facesIt(from)) {
      turns.push_back({before, out});
    }
    return turns;
  }

  /// Rays run on in parallel from turn to turn until they look straight through the exit.
  void addTurn(int frustum, const EntryStrip& strip, double from, double to) {
    const WalkMouth& mouth = mouths_[static_cast<size_t>(strip.exit)];
    EntryFrame frame = frame_;
    WalkMouth entry = entry_;
    const PieceExit& exit = exits_[static_cast<size_t>(strip.exit)];
    int first = -1;
    for (const Turn& turn : turnsTo(mouth, exit.mouth.width(), exit.lane, (from + to) / 2)) {
      const glm::dvec2 at = frame.inFrame(turn.at);
      if (!(at.y > kMinDepth * entry.width())) {
        return;
      }
      const double slope = (at.x - (from + to) / 2) / at.y;
      const EntryStrip lane{-1, at, at};
      const PieceRays straight = addFan(frame, frustum, entry, lane, {from, slope}, {to, slope});
      if (straight.frustum < 0) {
        return;
      }
      fans_.frusta.push_back(straight.frustum);
      frustum = straight.frustum;
      first = first < 0 ? frustum : first;
      const glm::dvec2 way = glm::normalize(frame.right * slope + frame.ahead);
      const double before = glm::dot(mouth.middle() - turn.at, turn.next);
      const double tilt = std::min(1.0, kTurnTilt * before / mouth.width());
      const glm::dvec2 normal = glm::normalize(turn.next + way * tilt);
      // Where the outer rays cross the line through it.
      const auto crossing = [&](double side) {
        const glm::dvec2 begin = frame.inPlan({side, 0});
        return begin + way * (glm::dot(turn.at - begin, normal) / glm::dot(way, normal));
      };
      WalkMouth line{crossing(from), crossing(to), region_.floorAt(turn.at), 0};
      line.top = line.floor + entry.height();
      entry = line;
      frame = EntryFrame(entry);
      from = 0;
      to = entry.width();
    }
    const EntryStrip through{strip.exit, frame.inFrame(mouth.left), frame.inFrame(mouth.right)};
    PieceRays rays = addFan(frame, frustum, entry, through, rayTo(from, through.begin), rayTo(to, through.end));
    rays.first = first < 0 ? rays.frustum : first;
    keep(strip, rays);
  }

  /// Rays of `frustum` that come in by `entry`, between two of them.
  PieceRays addFan(const EntryFrame& frame, int frustum, const WalkMouth& entry, const EntryStrip& strip, FanRay left,
                   FanRay right) {
    const double wide = entry.width();
    if (!(right.slope > left.slope)) {  // what it looks at is narrower than the strip: it sees what is beside, too
      left.slope = right.slope = (left.slope + right.slope) / 2;
    }
    const std::optional<glm::dvec2> from = fanViewpoint(left, right, wide);
    if (!from) {
      return {};
    }
    const double beyond = kWalkBeyond * region_.size;
    const auto at = [&](double x, double z, double height) { return spaceOf(frame.inPlan({x, z}), height); };
    const double behind = -from->y;
    double ahead = std::max((strip.begin.y + strip.end.y) / 2, kMinDepth * wide);
    // A ray along the top of the entry, and what it meets ahead.
    PieceRays rays;
    double top = entry.top;
    if (strip.exit >= 0) {
      const WalkMouth& out = mouths_[static_cast<size_t>(strip.exit)];
      const double one = frame.inFrame(out.left).y;
      const double other = frame.inFrame(out.right).y;
      const double near = std::max(std::min(one, other), kMinDepth * wide);
      const double far = std::max({one, other, kMinDepth * wide});
      rays.mouth = out;
      const double keeps = behind / (behind + near);
      const double most = std::max(entry.height(), kTallerShare * entry.height() / keeps);
      const double share = exits_[static_cast<size_t>(strip.exit)].lane.top;
      rays.mouth.top = out.floor + share * std::min(out.height(), most);
      const bool isOblique = near < kOblique * far;
      if (isOblique && entry.top > out.floor + kMinLevelShare * out.height()) {
        rays.mouth.top = std::min(rays.mouth.top, entry.top);  // level, so that its near end is seen too
      }
      top = rays.mouth.top;
      // All of its top is seen: of rays that rise from its near end on, of others from its far end on.
      ahead = top > entry.top ? near : far;
    } else {
      top += region_.floorAt(frame.inPlan((strip.begin + strip.end) / 2.0)) - region_.floorAt(entry.middle());
    }
    const glm::dvec3 viewpoint = at(from->x, from->y + beyond, entry.top - (top - entry.top) * behind / ahead);
    const glm::dvec3 up(0, entry.height(), 0);
    const glm::dvec3 a = at(left.at, beyond, entry.floor);
    const glm::dvec3 b = at(right.at, beyond, entry.floor);
    const Plane plane = Plane::through(at(0, beyond, 0), spaceOf(frame.ahead, 0));
    const GraphCamera::Part part = frustumImage(camera_, frustum, std::array{a, b, b + up, a + up});
    rays.frustum = bendWhereOneCan(camera_, frustum, {plane, viewpoint}, nameOfCell(region_.cell), part);
    if (rays.frustum < 0) {
      return {};
    }
    for (const Plane& limit : region_.limits) {
      limitWhereOneCan(camera_, rays.frustum, limit);
    }
    rays.first = rays.frustum;
    rays.turns = turnsOf(camera_, rays.frustum);
    return rays;
  }

  GraphCamera& camera_;
  const WalkRegion& region_;
  const PlanPolygon& border_;
  const WalkMouth& entry_;
  EntryFrame frame_;
  const std::vector<PieceExit>& exits_;
  const PieceSharing& sharing_;
  PieceFans fans_;
  std::vector<WalkMouth> mouths_;  ///< of the exits, as much of them as is to be seen
  double scale_ = 1;               ///< of a length at an exit, in the image, to the same at the entry
  glm::dvec2 least_{0};            ///< of the border, in the frame of the entry
  glm::dvec2 most_{0};
};

}  // namespace

PieceFans addPiece(GraphCamera& camera, const WalkRegion& region, const PlanPolygon& border, int frustum,
                   const WalkMouth& entry, const std::vector<PieceExit>& exits, const PieceSharing& sharing) {
  return RegionPiece(camera, region, border, entry, exits, sharing).add(frustum);
}

}  // namespace ocelli
