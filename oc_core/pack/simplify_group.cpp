#include "oc_core/pack/simplify_group.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <span>

#include "oc_core/pack/anchors.h"
#include "oc_core/pack/one_color.h"
#include "oc_core/pack/open_edges.h"
#include "oc_core/pack/rim_error.h"

namespace ocelli {
namespace {

/// What some coarser triangles are off by, at a vertex that they left out.
struct LeftOut {
  uint32_t vertex = 0;
  LevelError error;
};

/// The vertices that are off by far more than most, and by more than `negligible`: one of them would count for all of
/// the group.
std::vector<uint32_t> farOff(const std::vector<LeftOut>& errors, float negligible) {
  std::vector<float> sorted;
  for (const LeftOut& each : errors) {
    sorted.push_back(each.error.larger());
  }
  const size_t most = sorted.size() * 3 / 4;
  std::vector<uint32_t> vertices;
  if (most < sorted.size()) {
    std::nth_element(sorted.begin(), sorted.begin() + static_cast<std::ptrdiff_t>(most), sorted.end());
    constexpr float kFarMore = 5;
    for (const LeftOut& each : errors) {
      const float error = each.error.larger();
      if (error > std::max(kFarMore * sorted[most], negligible) || !std::isfinite(error)) {
        vertices.push_back(each.vertex);
      }
    }
  }
  return vertices;
}

/// Of the radius of a group: far below the sides of its triangles, and above what rounding leaves of a plane.
constexpr float kNegligible = 1e-4f;

/// The triangles of a group while it is simplified.
class GroupSimplifier {
 public:
  /// `spread`: by how much the colour of each vertex is off; empty where none is. All must outlive this.
  GroupSimplifier(const WeldedTriangles& welded, std::span<const float> spread, const PlaceSet& shared)
      : welded_(welded),
        spread_(spread),
        places_(placeNumbers(welded.positions)),
        isShared_(places_.size(), 0),
        open_(openEdges(welded.indices, places_)),
        negligible_(kNegligible * aroundPoints(welded.positions).radius),
        simplifier_(welded.positions) {
    for (size_t i = 0; i < places_.size(); ++i) {
      isShared_[i] =
          places_[i] == i ? (shared.contains(placeBits(welded.positions[i])) ? 1 : 0) : isShared_[places_[i]];
    }
    std::ranges::copy_if(open_, std::back_inserter(rims_), [&](const OpenEdge& edge) { return isRim(edge); });
    if (!rims_.empty()) {
      pieces_ = connectedPieces(welded.indices, places_);
      hasRim_.assign(places_.size(), 0);
      for (const OpenEdge& edge : rims_) {
        hasRim_[pieces_[edge.from]] = 1;
      }
    }
  }

  /// `locksRims`: whether rims stay as well.
  std::optional<SimplifiedTriangles> simplified(bool locksRims) {
    const std::vector<uint32_t>& fine = welded_.indices;
    const size_t target = welded_.triangleCount() / 2 * 3;
    std::vector<uint8_t> stays = isShared_;
    std::vector<uint8_t> keepsTriangles(places_.size(), 0);
    std::vector<uint32_t> coarse = simplifier_.fewer(fine, stays, locksRims, target);
    std::vector<LeftOut> errors = errorsOf(coarse);
    constexpr int kMaxRounds = 6;
    for (int round = 0; round < kMaxRounds; ++round) {
      const std::vector<uint32_t> off = farOff(errors, negligible_);
      if (off.empty()) {
        break;
      }
      // The triangles around them stay as they are.
      for (const uint32_t vertex : off) {
        keepsTriangles[vertex] = 1;
      }
      std::vector<uint32_t> staying;
      std::vector<uint32_t> rest;
      for (size_t i = 0; i < fine.size(); i += 3) {
        const bool stay =
            keepsTriangles[fine[i]] != 0 || keepsTriangles[fine[i + 1]] != 0 || keepsTriangles[fine[i + 2]] != 0;
        (stay ? staying : rest).insert((stay ? staying : rest).end(), {fine[i], fine[i + 1], fine[i + 2]});
        for (size_t k = 0; stay && k < 3; ++k) {
          stays[fine[i + k]] = 1;
        }
      }
      if (rest.empty()) {
        return std::nullopt;
      }
      coarse = simplifier_.fewer(rest, stays, locksRims, target > staying.size() ? target - staying.size() : 0);
      coarse.insert(coarse.end(), staying.begin(), staying.end());
      errors = errorsOf(coarse);
    }
    if (coarse.empty() || static_cast<float>(coarse.size()) > kWorthwhile * static_cast<float>(fine.size()) ||
        !keepsBorders(open_, openEdges(coarse, places_), isShared_)) {
      return std::nullopt;
    }
    SimplifiedTriangles result{weldedOf(coarse), CoarseSurface(welded_, coarse, spread_).spreadError()};
    for (const LeftOut& each : errors) {
      result.error = largest(result.error, each.error);
    }
    if (!std::isfinite(result.error.larger())) {
      return std::nullopt;
    }
    return result;
  }

  bool hasRims() const { return !rims_.empty(); }

 private:
  bool isRim(const OpenEdge& edge) const { return isShared_[edge.from] == 0 || isShared_[edge.to] == 0; }

  /// What coarser triangles are off by, at the vertices that they left out. Infinite where a piece with a rim is gone.
  std::vector<LeftOut> errorsOf(const std::vector<uint32_t>& coarse) const {
    std::vector<uint8_t> isLeft(welded_.positions.size(), 0);
    std::vector<uint8_t> isLeftPlace(welded_.positions.size(), 0);
    for (const uint32_t vertex : coarse) {
      isLeft[vertex] = 1;
      isLeftPlace[places_[vertex]] = 1;
    }
    const CoarseSurface surface(welded_, coarse, spread_);
    const std::vector<OpenEdge> coarseOpen = rims_.empty() ? std::vector<OpenEdge>{} : openEdges(coarse, places_);
    const RimErrors rims(welded_.positions, rims_, coarseOpen);
    std::vector<uint8_t> isLeftPiece(pieces_.size(), 0);
    for (size_t i = 0; i < (pieces_.empty() ? 0 : coarse.size()); ++i) {
      isLeftPiece[pieces_[places_[coarse[i]]]] = 1;
    }
    std::vector<LeftOut> errors;
    for (uint32_t vertex = 0; vertex < welded_.positions.size(); ++vertex) {
      if (isLeft[vertex] == 0) {
        LevelError error = surface.errorAt(vertex);
        const uint32_t place = places_[vertex];
        if (isLeftPlace[place] == 0) {
          error.distance = std::max(error.distance, rims.errorAt(place));
        }
        // Leaves and blades would be near to others, and a tree without every second one would be another tree.
        if (!pieces_.empty() && hasRim_[pieces_[place]] != 0 && isLeftPiece[pieces_[place]] == 0) {
          error.distance = std::numeric_limits<float>::infinity();
        }
        errors.push_back({vertex, error});
      }
    }
    return errors;
  }

  WeldedTriangles weldedOf(const std::vector<uint32_t>& coarse) const {
    Welder welder(coarse.size() / 3);
    for (size_t i = 0; i < coarse.size(); i += 3) {
      std::array<uint32_t, 3> corners{};
      for (size_t k = 0; k < 3; ++k) {
        corners[k] = welder.vertex(welded_.positions[coarse[i + k]], welded_.colors[coarse[i + k]]);
      }
      welder.add(corners[0], corners[1], corners[2]);
    }
    return welder.take();
  }

  const WeldedTriangles& welded_;
  std::span<const float> spread_;
  std::vector<uint32_t> places_;   ///< of each vertex
  std::vector<uint8_t> isShared_;  ///< of each vertex
  std::vector<OpenEdge> open_;
  std::vector<OpenEdge> rims_;    ///< those that nothing else shares
  std::vector<uint32_t> pieces_;  ///< of each place, by connectedPieces(); empty where there are no rims
  std::vector<uint8_t> hasRim_;   ///< of each piece
  float negligible_;
  AnchoredSimplifier simplifier_;
};

std::optional<SimplifiedTriangles> simplifiedAsTheyAre(const WeldedTriangles& welded, std::span<const float> spread,
                                                       const PlaceSet& shared) {
  GroupSimplifier group(welded, spread, shared);
  std::optional<SimplifiedTriangles> coarse = group.simplified(false);
  return coarse || !group.hasRims() ? coarse : group.simplified(true);
}

}  // namespace

std::optional<SimplifiedTriangles> simplified(const WeldedTriangles& welded, const PlaceSet& shared) {
  if (std::optional<SimplifiedTriangles> coarse = simplifiedAsTheyAre(welded, {}, shared)) {
    return coarse;
  }
  const OneColorTriangles oneColor = withOneColor(welded);
  return oneColor.triangles.positions.size() < welded.positions.size()
             ? simplifiedAsTheyAre(oneColor.triangles, oneColor.spread, shared)
             : std::nullopt;
}

}  // namespace ocelli
