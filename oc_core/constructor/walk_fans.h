// How rays that come into a convex region through an opening part there: strips of the opening, from left to right,
// each with a fan of rays of its own to an opening on the other sides, or to the wall between two of them.
//
// Plan, in the frame of the opening that rays come in by: x to the right along it, z ahead.
//
//      b1   exit   b2                A fan begins at a strip of the opening, from e_k to e_k+1, where its rays run with
//      /|----------|\                the slopes m_k to m_k+1 (x over z). Strips and slopes both grow from left to
//     / |          | \               right, so fans spread, their viewpoints lie before the opening, where the
//    /  |m1      m2|  \              outer rays of each meet, and no two of them share a point of the region.
//   |---+-e1----e2-+---|
//       entry                        The ray between two fans runs to the edge of an exit: there a wall hides that the
//                                    image jumps. Within the region it jumps where fans have different viewpoints.
//
// DEVIATION: the text parts rays with two planes in a right-angled crossing (PPC1 and PPC2); this parts them in the
// opening before it, and needs neither right angles nor equal widths.
#pragma once

#include <vector>

#include "oc_core/camera/graph_camera.h"
#include "oc_core/constructor/walk_region.h"

namespace ocelli {

/// The frame of an opening that rays come in by.
struct EntryFrame {
  explicit EntryFrame(const WalkMouth& entry) : origin(entry.left), right(entry.across()), ahead(entry.ahead()) {}

  glm::dvec2 inFrame(const glm::dvec2& point) const {
    return {glm::dot(point - origin, right), glm::dot(point - origin, ahead)};
  }
  glm::dvec2 inPlan(const glm::dvec2& point) const { return origin + right * point.x + ahead * point.y; }

  glm::dvec2 origin;
  glm::dvec2 right;
  glm::dvec2 ahead;
};

/// A ray between two fans, or at the border of the first or the last.
struct FanRay {
  double at = 0;     ///< e: where it comes in
  double slope = 0;  ///< m
};

/// What a fan looks at.
struct FanAim {
  int exit = -1;        ///< which of the exits; -1 for a wall between them
  glm::dvec2 begin{0};  ///< of it, at the left; in the frame of the entry. Of the first fan, the left end of the entry
  glm::dvec2 end{0};    ///< at the right; of the last fan, the right end of the entry
  double share = 0;     ///< of the entry's width, that it should have
  double distance = 0;  ///< how far before the entry its viewpoint should lie; counts for the first and the last
};

/// The exits in the order in which rays spread, and the walls between them that are wider than an eighth of the
/// entry. Exits must lie ahead of the entry's line, but for their near ends. Shares are 0.
std::vector<FanAim> aimsOf(const EntryFrame& frame, double width, const std::vector<WalkMouth>& exits);

/// The rays between fans, one more than there are aims: as near to their shares as fans that spread can be.
std::vector<FanRay> spreadRays(const std::vector<FanAim>& aims, double width);

/// How rays from one viewpoint, in the frame of the entry and before it, run on without a bend: those between the same
/// aims. Fans that such rays do not reach have no width.
std::vector<FanRay> straightRays(const std::vector<FanAim>& aims, double width, const glm::dvec2& viewpoint);

/// Both, by how far they have gone from one to the other, 0 to 1. Rays keep spreading.
std::vector<FanRay> mixedRays(const std::vector<FanRay>& from, const std::vector<FanRay>& to, double share);

/// Where the rays of a fan come from, in the frame of the entry; nothing where it has no width.
std::optional<glm::dvec2> fanViewpoint(const FanRay& left, const FanRay& right, double width);

}  // namespace ocelli
