// Where one can walk in cities and houses, found from their triangles alone, against the plans that they were built
// from; and what the comprehensive camera shows of what was found. A row a scene, and what is not seen and why.
#include <fmt/format.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <string>

#include "bench/bench_program.h"
#include "bench/walk_acceptance.h"

namespace ocelli::bench {
namespace {

struct WalkChoice {
  uint64_t firstSeed = 1;
  uint64_t seeds = 10;
  float citySize = 152;
  int width = 1920;
  int height = 1080;
  int threads = 0;
  WalkComprehensiveOptions camera;
  bool isVerbose = false;
  bool findsOnly = false;
};

double percentOf(double part, double whole) {
  return whole > 0 ? 100 * part / whole : 0;
}

/// Of several scenes.
struct WalkTotals {
  size_t known = 0, found = 0, matched = 0;  // rooms
  size_t knownPortals = 0, foundPortals = 0, matchedPortals = 0;
  double knownArea = 0, foundArea = 0, coveredArea = 0, plannedArea = 0;
  size_t cells = 0, seen = 0, seenRooms = 0;

  void add(const WalkScene& scene, const WalkAcceptance& result) {
    known += scene.known.roomCount();
    found += result.agreement.reachedRooms.size();
    matched += result.agreement.matchedRooms();
    knownPortals += scene.known.openingCount();
    foundPortals += result.agreement.reachedOpenings;
    matchedPortals += result.agreement.matchedPortals();
    knownArea += result.agreement.knownArea;
    foundArea += result.agreement.reachedArea;
    coveredArea += result.agreement.coveredShare * result.agreement.knownArea;
    plannedArea += result.agreement.knownShare * result.agreement.reachedArea;
    cells += result.agreement.reached.size();
    seen += result.seenCells();
    seenRooms += result.seenRooms();
  }

  std::string row() const {
    const auto count = [](size_t n) { return static_cast<double>(n); };
    return fmt::format(
        "{:5.1f} % {:5.1f} % | {:3} {:3} {:3} {:4.0f} % {:4.0f} % | {:3} {:3} {:3} {:4.0f} % {:4.0f} % | {:3} of {:3} "
        "cells, {:3} rooms",
        percentOf(coveredArea, knownArea), percentOf(plannedArea, foundArea), known, found, matched,
        percentOf(count(matched), count(known)), percentOf(count(matched), count(found)), knownPortals, foundPortals,
        matchedPortals, percentOf(count(matchedPortals), count(knownPortals)),
        percentOf(count(matchedPortals), count(foundPortals)), seen, cells, seenRooms);
  }
};

void tell(const WalkMap& map, uint32_t cell, const char* what) {
  const WalkCell& c = map.cells[cell];
  fmt::print("    {} {}, {}, at ({:.1f}, {:.1f}, {:.1f}), {:.1f} x {:.1f} m\n", what, nameOfCell(cell),
             c.kind == WalkCellKind::kRoom ? "room" : "tunnel", c.center.x, c.center.y, c.center.z, 2 * c.halfLength,
             2 * c.halfWidth);
}

void tellPortal(const WalkMap& map, uint32_t number, const char* what) {
  const WalkPortal& portal = map.portals[number];
  const Portal& p = portal.opening;
  fmt::print("    {} {} at ({:.1f}, {:.1f}, {:.1f}), {:.1f} m wide, between {} and {}\n", what, nameOfOpening(number),
             p.center.x, p.center.y, p.center.z, 2 * glm::length(p.halfRight), nameOfCell(portal.from),
             nameOfCell(portal.to));
}

void tellDisagreement(const WalkScene& scene, const WalkAcceptance& result) {
  const WalkAgreement& agreement = result.agreement;
  for (uint32_t cell = 0; cell < scene.known.cells.size(); ++cell) {
    if (agreement.foundOfRoom[scene.known.roomOfCell[cell]] == WalkAgreement::kNone) {
      tell(scene.known, cell, "not found:");
    }
  }
  const auto isIn = [](const std::vector<uint32_t>& matches, uint32_t number) {
    return std::find(matches.begin(), matches.end(), number) != matches.end();
  };
  for (const uint32_t cell : agreement.reached) {
    if (!isIn(agreement.foundOfRoom, result.found.roomOfCell[cell])) {
      tell(result.found, cell, "found, not in the plan:");
    }
  }
  for (uint32_t p = 0; p < scene.known.portals.size(); ++p) {
    if (agreement.foundOfPortal[p] == WalkAgreement::kNone && !scene.known.portals[p].isJoint) {
      tellPortal(scene.known, p, "not found:");
    }
  }
  for (const uint32_t p : agreement.reachedPortals) {
    if (!isIn(agreement.foundOfPortal, p) && !result.found.portals[p].isJoint) {
      tellPortal(result.found, p, "found, not in the plan:");
    }
  }
}

void measureScene(const WalkScene& scene, const WalkChoice& choice, WalkTotals& totals) {
  const WalkAcceptance result = acceptWalks(scene, choice.findsOnly ? 0 : choice.width, choice.height, choice.camera);
  totals.add(scene, result);
  WalkTotals one;
  one.add(scene, result);
  fmt::print("{:<32} {} {:4} frusta, {:5.1f} s {:5.1f} s, {} cells elsewhere\n", scene.source, one.row(), result.frusta,
             result.findMilliseconds / 1000, result.cameraMilliseconds / 1000, result.agreement.otherCells);
  for (const SeenCell& cell : result.cells) {
    if (!cell.why.empty()) {
      tell(result.found, cell.cell, "unseen:");
      fmt::print("      {} ({} pixels; {:.1f} without what stands before it)\n", cell.why, cell.pixels, cell.expected);
    }
  }
  if (choice.isVerbose) {
    tellDisagreement(scene, result);
  }
}

void measureWalks(const WalkChoice& choice) {
  fmt::print(
      "Found from triangles alone; images of {} x {}; a cell is seen where {} pixels show the middle of its floor.\n",
      choice.width, choice.height, choice.camera.minPixels);
  fmt::print(
      "{:<32} floor rec. prec. | rooms: known found both rec. prec. | openings: known found both rec. prec. | seen\n",
      "");
  WalkTotals cities;
  WalkTotals houses;
  for (uint64_t seed = choice.firstSeed; seed < choice.firstSeed + choice.seeds; ++seed) {
    measureScene(cityToWalk(seed, choice.citySize), choice, cities);
  }
  for (uint64_t seed = choice.firstSeed; seed < choice.firstSeed + choice.seeds; ++seed) {
    measureScene(houseToWalk(seed), choice, houses);
  }
  fmt::print("{:<32} {}\n{:<32} {}\n", "cities", cities.row(), "houses", houses.row());
}

}  // namespace
}  // namespace ocelli::bench

int main(int argumentCount, char** arguments) {
  using ocelli::bench::WalkChoice;
  WalkChoice choice;
  CLI::App program("Where one can walk in made cities and houses, found against planned", "walk_acceptance_bench");
  program.add_option("--first-seed", choice.firstSeed, "Of the scenes")->capture_default_str();
  program.add_option("--seeds", choice.seeds, "Cities, and houses")->check(CLI::Range(1, 1000))->capture_default_str();
  program.add_option("--city-size", choice.citySize, "Metres")->check(CLI::Range(60, 400))->capture_default_str();
  program.add_option("--threads", choice.threads, "0 stands for all cores")->check(CLI::Range(0, 1024));
  program.add_option("--width", choice.width, "Pixels")->check(CLI::Range(16, 8192))->capture_default_str();
  program.add_option("--height", choice.height, "Pixels")->check(CLI::Range(16, 8192))->capture_default_str();
  program.add_option("--pixels", choice.camera.minPixels, "That show a cell")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  program.add_option("--nearness", choice.camera.nearness, "Of the camera")->capture_default_str();
  program.add_option("--evenness", choice.camera.evenness, "Of the camera")->capture_default_str();
  program.add_option("--eye-height", choice.camera.eyeHeight, "Of the camera")->capture_default_str();
  program.add_option("--builds", choice.camera.builds, "Of the camera, at most")->capture_default_str();
  program.add_flag("--find-only", choice.findsOnly, "Make no images");
  program.add_flag("--verbose", choice.isVerbose, "Name what was not found and what is not in the plan");
  return ocelli::runProgram(program, argumentCount, arguments, choice, ocelli::bench::measureWalks);
}
