#include "oc_core/walkable/walk_map_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "oc_core/base/error.h"
#include "oc_core/base/file_bytes.h"
#include "oc_core/base/json_fields.h"

namespace ocelli {
namespace {

constexpr double kFarthest = 1e6;
constexpr double kShortest = 1e-6;
constexpr size_t kMaxCells = 20000;
constexpr size_t kMaxPortals = 80000;
constexpr size_t kMaxRings = 10000;         // of a tunnel
constexpr size_t kMaxMapRings = 1'000'000;  // of a map: 16 MB of rings, and some hundred MB while its JSON is read

glm::vec3 vectorIn(JsonFields& fields, const std::string& name) {
  const std::vector<double> v = fields.numbers(name, 3, -kFarthest, kFarthest);
  return {static_cast<float>(v[0]), static_cast<float>(v[1]), static_cast<float>(v[2])};
}

float lengthIn(JsonFields& fields, const std::string& name) {
  return static_cast<float>(fields.number(name, kShortest, kFarthest));
}

glm::vec3 axisIn(JsonFields& fields) {
  if (!fields.has("axis")) {
    return WalkCell().axis;
  }
  const std::vector<double> v = fields.numbers("axis", 2, -1.001, 1.001);
  const double length = std::hypot(v[0], v[1]);
  if (std::abs(length - 1) > 1e-3) {
    fields.fail("axis", fmt::format("must have length 1, but has {:.4g}", length));
  }
  // What floats can say of length 1 stays as it is, so that files that were written are read as they were.
  const double divisor = std::abs(length - 1) < 1e-6 ? 1 : length;
  return {static_cast<float>(v[0] / divisor), 0, static_cast<float>(v[1] / divisor)};
}

/// `allowed` is how many rings the map may still have.
std::vector<WalkRing> ringsIn(JsonFields& fields, const WalkCell& cell, size_t allowed) {
  std::vector<WalkRing> rings;
  if (!fields.has("rings")) {
    if (cell.kind == WalkCellKind::kTunnel) {
      rings = {{0, cell.halfWidth, cell.halfWidth, cell.height},
               {2 * cell.halfLength, cell.halfWidth, cell.halfWidth, cell.height}};
    }
    return rings;
  }
  const nlohmann::json& list = fields.value("rings");
  if (!list.is_array() || list.size() > kMaxRings) {
    fields.fail("rings", fmt::format("must be an array of at most {} rings", kMaxRings));
  }
  if (list.size() > allowed) {
    fields.fail("rings", fmt::format("has {} rings: all tunnels of a map together may have {}, and {} are left",
                                     list.size(), kMaxMapRings, allowed));
  }
  for (const nlohmann::json& value : list) {
    const bool isRing = value.is_array() && value.size() == 4 && value[0].is_number() && value[1].is_number() &&
                        value[2].is_number() && value[3].is_number();
    const auto number = [&](size_t i) { return value[i].get<double>(); };
    if (!isRing || std::min({number(0), number(1), number(2), number(3)}) < 0 ||
        std::max({number(0), number(1), number(2), number(3)}) > kFarthest) {
      fields.fail("rings", fmt::format("ring {} must be four numbers from 0 to {:.0f}", rings.size(), kFarthest));
    }
    if (!(number(1) + number(2) >= kShortest) || !(number(3) >= kShortest)) {
      fields.fail("rings", fmt::format("ring {} must have a width (the second and third number) and a height (the "
                                       "fourth) above 0",
                                       rings.size()));
    }
    rings.push_back({static_cast<float>(number(0)), static_cast<float>(number(1)), static_cast<float>(number(2)),
                     static_cast<float>(number(3))});
    if (rings.size() > 1 && rings.back().along < rings[rings.size() - 2].along) {
      fields.fail("rings", fmt::format("ring {} must not lie before the one before it", rings.size() - 1));
    }
    if (rings.back().along > 2.001f * cell.halfLength) {
      fields.fail("rings", fmt::format("ring {} lies beyond the end of the cell", rings.size() - 1));
    }
  }
  if (cell.kind == WalkCellKind::kTunnel ? rings.size() < 2 : !rings.empty()) {
    fields.fail("rings", cell.kind == WalkCellKind::kTunnel ? "must hold two rings at least"
                                                            : "must be empty: only tunnels have rings");
  }
  return rings;
}

WalkCell cellIn(JsonFields& fields, size_t allowedRings) {
  WalkCell cell;
  cell.kind = fields.choice("kind", {"room", "tunnel"}) == "room" ? WalkCellKind::kRoom : WalkCellKind::kTunnel;
  cell.center = vectorIn(fields, "center");
  cell.axis = axisIn(fields);
  cell.halfLength = lengthIn(fields, "length") / 2;
  cell.halfWidth = lengthIn(fields, "width") / 2;
  cell.height = lengthIn(fields, "height");
  cell.floorRise = static_cast<float>(fields.number("floor_rise", -kFarthest, kFarthest, 0));
  cell.rings = ringsIn(fields, cell, allowedRings);
  return cell;
}

WalkPortal portalIn(JsonFields& fields, size_t cells) {
  WalkPortal portal;
  const auto cellAt = [&](const char* name) {
    const int number = fields.integer(name, 0, static_cast<int>(kMaxCells) - 1);
    if (static_cast<size_t>(number) >= cells) {
      fields.fail(name, fmt::format("must be one of the {} cells, which count from 0", cells));
    }
    return static_cast<uint32_t>(number);
  };
  portal.from = cellAt("from");
  portal.to = cellAt("to");
  if (portal.from == portal.to) {
    fields.fail("to", "must be another cell than \"from\"");
  }
  portal.isJoint = fields.boolean("joint", false);
  Portal& opening = portal.opening;
  opening.center = vectorIn(fields, "center");
  opening.halfRight = vectorIn(fields, "half_right");
  opening.halfUp = vectorIn(fields, "half_up");
  const glm::dvec3 right(opening.halfRight);
  const glm::dvec3 up(opening.halfUp);
  for (const char* name : {"half_right", "half_up"}) {
    if (glm::length(name == std::string("half_up") ? up : right) < kShortest) {
      fields.fail(name, "must be longer than 0");
    }
  }
  if (std::abs(glm::dot(right, up)) > 1e-3 * glm::length(right) * glm::length(up)) {
    fields.fail("half_up", "must stand at right angles to \"half_right\"");
  }
  opening.normal = glm::vec3(glm::normalize(glm::cross(right, up)));
  return portal;
}

/// The shortest decimal number that gives the float again.
double shortestDecimal(float value) {
  const std::string text = fmt::format("{}", value);
  double decimal = 0;
  std::from_chars(text.data(), text.data() + text.size(), decimal);
  return decimal;
}

nlohmann::ordered_json listOf(std::initializer_list<float> values) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const float value : values) {
    list.push_back(shortestDecimal(value));
  }
  return list;
}

nlohmann::ordered_json listOf(const glm::vec3& v) {
  return listOf({v.x, v.y, v.z});
}

/// What is written must be read again.
void requireFit(const WalkMap& map) {
  size_t rings = 0;
  for (const WalkCell& cell : map.cells) {
    rings += cell.rings.size();
    const glm::vec3 reach = glm::abs(cell.center);
    if (!(std::max({reach.x, reach.y, reach.z}) <= static_cast<float>(kFarthest))) {
      throw InputError(fmt::format("{} lies {:.3g} units from the origin, and files of walk maps hold {:.0f} at most",
                                   nameOfCell(static_cast<size_t>(&cell - map.cells.data())),
                                   std::max({reach.x, reach.y, reach.z}), kFarthest),
                       "walk map", "move the scene to its origin, or make its units larger");
    }
  }
  const auto require = [](size_t count, size_t most, const char* what) {
    if (count > most) {
      throw InputError(fmt::format("the map has {} {}, and files of walk maps hold {} at most", count, what, most),
                       "walk map", "give a larger agent or larger squares, or divide the scene");
    }
  };
  require(map.cells.size(), kMaxCells, "cells");
  require(map.portals.size(), kMaxPortals, "portals");
  require(rings, kMaxMapRings, "rings");
}

}  // namespace

WalkMap readWalkMap(JsonFields& fields) {
  WalkMap map;
  size_t rings = 0;
  fields.forEach(
      "cells", 1, kMaxCells,
      [&](JsonFields& each) {
        each.callIt(nameOfCell(map.cells.size()));
        map.cells.push_back(cellIn(each, kMaxMapRings - rings));
        rings += map.cells.back().rings.size();
      },
      "cells");
  fields.forEach(
      "portals", 0, kMaxPortals,
      [&](JsonFields& each) {
        each.callIt(nameOfOpening(map.portals.size()));
        map.portals.push_back(portalIn(each, map.cells.size()));
      },
      "portals");
  map.toWalls = static_cast<float>(fields.number("to_walls", 0, kFarthest, 0));
  fields.rejectUnknown();
  numberCells(map);
  return map;
}

WalkMap walkMapFromJsonText(const std::string& text, const std::string& where) {
  return readAs("oc_core/walkable/walk_map.schema.json", [&] {
    const JsonDocument document(text, where);
    JsonFields fields(document);
    return readWalkMap(fields);
  });
}

WalkMap readWalkMap(const std::filesystem::path& path) {
  return walkMapFromJsonText(readFile(path, kMaxTextBytes), path.string());
}

std::string jsonText(const WalkMap& map) {
  requireFit(map);
  nlohmann::ordered_json cells = nlohmann::ordered_json::array();
  for (const WalkCell& cell : map.cells) {
    nlohmann::ordered_json json{{"kind", cell.kind == WalkCellKind::kRoom ? "room" : "tunnel"},
                                {"center", listOf(cell.center)},
                                {"axis", listOf({cell.axis.x, cell.axis.z})},
                                {"length", shortestDecimal(2 * cell.halfLength)},
                                {"width", shortestDecimal(2 * cell.halfWidth)},
                                {"height", shortestDecimal(cell.height)}};
    if (cell.floorRise != 0) {
      json["floor_rise"] = shortestDecimal(cell.floorRise);
    }
    if (!cell.rings.empty()) {
      json["rings"] = nlohmann::ordered_json::array();
      for (const WalkRing& ring : cell.rings) {
        json["rings"].push_back(listOf({ring.along, ring.left, ring.right, ring.ceiling}));
      }
    }
    cells.push_back(std::move(json));
  }
  nlohmann::ordered_json portals = nlohmann::ordered_json::array();
  for (const WalkPortal& portal : map.portals) {
    nlohmann::ordered_json json{{"from", portal.from},
                                {"to", portal.to},
                                {"center", listOf(portal.opening.center)},
                                {"half_right", listOf(portal.opening.halfRight)},
                                {"half_up", listOf(portal.opening.halfUp)}};
    if (portal.isJoint) {
      json["joint"] = true;
    }
    portals.push_back(std::move(json));
  }
  nlohmann::ordered_json json{{"cells", cells}, {"portals", portals}};
  if (map.toWalls > 0) {
    json["to_walls"] = shortestDecimal(map.toWalls);
  }
  return textOfJson(json, 1) + "\n";
}

}  // namespace ocelli
