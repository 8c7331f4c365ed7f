#include "oc_core/walkable/walk_agreement.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <map>
#include <numeric>
#include <utility>

#include "oc_core/base/check.h"

namespace ocelli {
namespace {

/// Seen from above, (x, z).
using Outline = std::vector<glm::dvec2>;

Outline outlineOf(const WalkCell& cell) {
  const glm::dvec2 center(cell.center.x, cell.center.z);
  const glm::dvec2 along = glm::dvec2(cell.axis.x, cell.axis.z) * static_cast<double>(cell.halfLength);
  const glm::dvec3 right(cell.right());
  const glm::dvec2 across = glm::dvec2(right.x, right.z) * static_cast<double>(cell.halfWidth);
  return {center - along - across, center + along - across, center + along + across, center - along + across};
}

double crossOf(const glm::dvec2& a, const glm::dvec2& b) {
  return a.x * b.y - a.y * b.x;
}

/// Positive where corners run as those of outlineOf().
double areaOfOutline(const Outline& outline) {
  double twice = 0;
  for (size_t i = 0; i < outline.size(); ++i) {
    twice += crossOf(outline[i], outline[(i + 1) % outline.size()]);
  }
  return twice / 2;
}

/// Of two convex outlines (Sutherland and Hodgman 1974).
double sharedArea(Outline outline, const Outline& other) {
  for (size_t i = 0; i < other.size() && !outline.empty(); ++i) {
    const glm::dvec2& from = other[i];
    const glm::dvec2 along = other[(i + 1) % other.size()] - from;
    const auto inside = [&](const glm::dvec2& p) { return crossOf(along, p - from); };
    Outline clipped;
    for (size_t k = 0; k < outline.size(); ++k) {
      const glm::dvec2& a = outline[k];
      const glm::dvec2& b = outline[(k + 1) % outline.size()];
      const double atA = inside(a);
      const double atB = inside(b);
      if (atA >= 0) {
        clipped.push_back(a);
      }
      if ((atA >= 0) != (atB >= 0)) {
        clipped.push_back(a + (b - a) * (atA / (atA - atB)));
      }
    }
    outline = std::move(clipped);
  }
  return outline.empty() ? 0 : areaOfOutline(outline);
}

/// Of the floor at the middle of an opening.
glm::dvec3 footOf(const WalkPortal& portal) {
  return glm::dvec3(portal.opening.center) - glm::dvec3(portal.opening.halfUp);
}

bool holdsPlace(const Outline& outline, const glm::dvec2& place) {
  for (size_t i = 0; i < outline.size(); ++i) {
    const glm::dvec2& from = outline[i];
    if (crossOf(outline[(i + 1) % outline.size()] - from, place - from) < 0) {
      return false;
    }
  }
  return true;
}

struct CandidatePair {
  double rank;  ///< better ones first: smaller
  uint32_t known;
  uint32_t found;
};

/// Takes pairs in their order where neither has one yet.
std::vector<uint32_t> matchPairs(std::vector<CandidatePair> pairs, size_t known, size_t found) {
  std::sort(pairs.begin(), pairs.end(), [](const CandidatePair& a, const CandidatePair& b) {
    return a.rank != b.rank ? a.rank < b.rank : a.known != b.known ? a.known < b.known : a.found < b.found;
  });
  std::vector<uint32_t> match(known, WalkAgreement::kNone);
  std::vector<bool> isTaken(found);
  for (const CandidatePair& pair : pairs) {
    if (match[pair.known] == WalkAgreement::kNone && !isTaken[pair.found]) {
      match[pair.known] = pair.found;
      isTaken[pair.found] = true;
    }
  }
  return match;
}

size_t countMatches(const std::vector<uint32_t>& match) {
  return static_cast<size_t>(
      std::count_if(match.begin(), match.end(), [](uint32_t found) { return found != WalkAgreement::kNone; }));
}

/// Boxes of one room hardly reach into each other, so their areas are added.
std::vector<double> areasOfRooms(const WalkMap& map, const std::vector<Outline>& outlines) {
  std::vector<double> areas(map.roomCount(), 0);
  for (size_t cell = 0; cell < outlines.size(); ++cell) {
    areas[map.roomOfCell[cell]] += areaOfOutline(outlines[cell]);
  }
  return areas;
}

class MapComparison {
 public:
  MapComparison(const WalkMap& known, const WalkMap& found, const WalkAgreementRules& rules)
      : known_(known), found_(found), rules_(rules) {}

  WalkAgreement compare() {
    compareCells();
    comparePortals();
    return std::move(agreement_);
  }

 private:
  bool isOneLevel(double a, double b) const { return std::abs(a - b) < rules_.levelStep; }

  void compareCells() {
    std::vector<Outline> knownOutlines;
    std::vector<Outline> foundOutlines;
    for (const WalkCell& cell : known_.cells) {
      knownOutlines.push_back(outlineOf(cell));
      agreement_.knownArea += areaOfOutline(knownOutlines.back());
    }
    for (const WalkCell& cell : found_.cells) {
      foundOutlines.push_back(outlineOf(cell));
    }
    std::map<std::pair<uint32_t, uint32_t>, double> sharedOfRooms;  // known and found
    std::map<uint32_t, double> sharedOfPart;
    for (uint32_t k = 0; k < known_.cells.size(); ++k) {
      for (uint32_t f = 0; f < found_.cells.size(); ++f) {
        if (!isOneLevel(known_.cells[k].center.y, found_.cells[f].center.y)) {
          continue;
        }
        const double shared = sharedArea(knownOutlines[k], foundOutlines[f]);
        if (shared <= 0) {
          continue;
        }
        sharedOfPart[found_.partOfCell[f]] += shared;
        sharedOfRooms[{known_.roomOfCell[k], found_.roomOfCell[f]}] += shared;
      }
    }
    std::vector<CandidatePair> pairs;
    const std::vector<double> knownAreas = areasOfRooms(known_, knownOutlines);
    const std::vector<double> foundAreas = areasOfRooms(found_, foundOutlines);
    for (const auto& [rooms, shared] : sharedOfRooms) {
      const auto& [k, f] = rooms;
      const double either = knownAreas[k] + foundAreas[f] - shared;
      if (shared >= rules_.roomOverlap * either) {
        pairs.push_back({-shared / either, k, f});
      }
    }
    const auto most = std::max_element(sharedOfPart.begin(), sharedOfPart.end(),
                                       [](const auto& a, const auto& b) { return a.second < b.second; });
    isReached_.assign(found_.cells.size(), false);
    std::vector<bool> isReachedRoom(found_.roomCount(), false);
    if (most != sharedOfPart.end()) {
      for (uint32_t f = 0; f < found_.cells.size(); ++f) {
        isReached_[f] = found_.partOfCell[f] == most->first;
        if (isReached_[f]) {
          const uint32_t room = found_.roomOfCell[f];
          if (!isReachedRoom[room]) {
            agreement_.reachedRooms.push_back(room);
          }
          isReachedRoom[room] = true;
          agreement_.reached.push_back(f);
          agreement_.reachedArea += areaOfOutline(foundOutlines[f]);
        }
      }
    }
    compareFloors(knownOutlines, foundOutlines);
    agreement_.otherCells = found_.cells.size() - agreement_.reached.size();
    std::erase_if(pairs, [&](const CandidatePair& pair) { return !isReachedRoom[pair.found]; });
    agreement_.foundOfRoom = matchPairs(std::move(pairs), known_.roomCount(), found_.roomCount());
  }

  /// By places a quarter of a unit apart: boxes of one map may reach into each other.
  void compareFloors(const std::vector<Outline>& knownOutlines, const std::vector<Outline>& foundOutlines) {
    std::vector<uint32_t> all(known_.cells.size());
    std::iota(all.begin(), all.end(), 0u);
    agreement_.coveredShare = shareCovered({known_, knownOutlines, all}, {found_, foundOutlines, agreement_.reached});
    agreement_.knownShare = shareCovered({found_, foundOutlines, agreement_.reached}, {known_, knownOutlines, all});
  }

  struct Floors {
    const WalkMap& map;
    const std::vector<Outline>& outlines;
    const std::vector<uint32_t>& cells;
  };

  double shareCovered(const Floors& floors, const Floors& cover) const {
    constexpr double kStep = 0.25;
    size_t places = 0;
    size_t covered = 0;
    for (const uint32_t cell : floors.cells) {
      const Outline& outline = floors.outlines[cell];
      const glm::dvec2 along = outline[1] - outline[0];
      const glm::dvec2 across = outline[3] - outline[0];
      const double rows = std::max(1.0, std::floor(glm::length(along) / kStep));
      const double columns = std::max(1.0, std::floor(glm::length(across) / kStep));
      for (double i = 0.5; i < rows; ++i) {
        for (double j = 0.5; j < columns; ++j) {
          const glm::dvec2 place = outline[0] + along * (i / rows) + across * (j / columns);
          ++places;
          covered += std::any_of(cover.cells.begin(), cover.cells.end(), [&](uint32_t other) {
            return isOneLevel(floors.map.cells[cell].center.y, cover.map.cells[other].center.y) &&
                   holdsPlace(cover.outlines[other], place);
          });
        }
      }
    }
    return places == 0 ? 0 : static_cast<double>(covered) / static_cast<double>(places);
  }

  void comparePortals() {
    std::vector<CandidatePair> pairs;
    for (uint32_t f = 0; f < found_.portals.size(); ++f) {
      if (isReached_[found_.portals[f].from]) {
        agreement_.reachedPortals.push_back(f);
        agreement_.reachedOpenings += found_.portals[f].isJoint ? 0 : 1;
      }
    }
    for (uint32_t k = 0; k < known_.portals.size(); ++k) {
      if (known_.portals[k].isJoint) {
        continue;
      }
      const Portal& known = known_.portals[k].opening;
      const double reach = std::max(rules_.openingReach, static_cast<double>(glm::length(known.halfRight)));
      for (const uint32_t f : agreement_.reachedPortals) {
        const glm::dvec3 apart = footOf(found_.portals[f]) - footOf(known_.portals[k]);
        const double distance = std::hypot(apart.x, apart.z);
        const double turn = std::abs(glm::dot(known.normal, found_.portals[f].opening.normal));
        if (!found_.portals[f].isJoint && distance < reach && std::abs(apart.y) < rules_.levelStep &&
            turn >= std::sqrt(0.5)) {
          pairs.push_back({distance, k, f});
        }
      }
    }
    agreement_.foundOfPortal = matchPairs(std::move(pairs), known_.portals.size(), found_.portals.size());
  }

  const WalkMap& known_;
  const WalkMap& found_;
  const WalkAgreementRules& rules_;
  std::vector<bool> isReached_;
  WalkAgreement agreement_;
};

}  // namespace

size_t WalkAgreement::matchedRooms() const {
  return countMatches(foundOfRoom);
}

size_t WalkAgreement::matchedPortals() const {
  return countMatches(foundOfPortal);
}

WalkAgreement compareWalkMaps(const WalkMap& known, const WalkMap& found, const WalkAgreementRules& rules) {
  for (const WalkMap* map : {&known, &found}) {
    OC_CHECK(map->partOfCell.size() == map->cells.size() && map->roomOfCell.size() == map->cells.size(),
             "cells of maps that are compared are numbered");
  }
  return MapComparison(known, found, rules).compare();
}

}  // namespace ocelli
