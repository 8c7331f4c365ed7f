#include "oc_core/walkable/walk_map_file.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <glm/geometric.hpp>

#include "oc_core/base/error.h"
#include "oc_core/base/file_bytes.h"
#include "oc_core/base/json_fields.h"
#include "oc_core/walkable/walk_options.h"
#include "tests/base/schema_agreement.h"
#include "tests/base/temporary_folder.h"

namespace ocelli {
namespace {

using testing::AllOf;
using testing::HasSubstr;

const char* const kGoodMap = R"({
  "cells": [
    {"kind": "room", "center": [0, 0, 0], "length": 4, "width": 3, "height": 2.5},
    {"kind": "tunnel", "center": [5, 0, 0], "axis": [1, 0], "length": 6, "width": 2, "height": 2.5, "floor_rise": 1.5,
     "rings": [[0, 1, 1, 2.5], [6, 1.25, 1, 3]]}
  ],
  "portals": [{"from": 0, "to": 1, "center": [2, 1, 0], "half_right": [0, 0, 0.5], "half_up": [0, 1, 0]}]
})";

std::string mapErrorOf(const std::string& text) {
  try {
    walkMapFromJsonText(text, "text");
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

/// The good map with one value changed.
std::string changed(const char* pointer, const nlohmann::json& value) {
  nlohmann::json json = nlohmann::json::parse(kGoodMap);
  json[nlohmann::json::json_pointer(pointer)] = value;
  return json.dump();
}

TEST(WalkMapFile, IsReadAsItSays) {
  const WalkMap map = walkMapFromJsonText(kGoodMap, "text");
  ASSERT_EQ(map.cells.size(), 2U);
  EXPECT_EQ(map.cells[0].kind, WalkCellKind::kRoom);
  EXPECT_EQ(map.cells[0].halfLength, 2);
  EXPECT_EQ(map.cells[0].axis, glm::vec3(0, 0, -1));
  EXPECT_EQ(map.cells[1].kind, WalkCellKind::kTunnel);
  EXPECT_EQ(map.cells[1].floorRise, 1.5f);
  EXPECT_EQ(map.cells[1].rings, (std::vector<WalkRing>{{0, 1, 1, 2.5f}, {6, 1.25f, 1, 3}}));
  ASSERT_EQ(map.portals.size(), 1U);
  EXPECT_EQ(map.portals[0].opening.normal, glm::vec3(-1, 0, 0)) << "into the cell that it is seen from";
  EXPECT_EQ(map.partOfCell, (std::vector<uint32_t>{0, 0}));
  EXPECT_EQ(map.toWalls, 0);
}

TEST(WalkMapFile, WhatIsWrittenIsReadAgain) {
  WalkMap map = walkMapFromJsonText(kGoodMap, "text");
  map.cells[1].axis = {0.6f, 0, 0.8f};
  map.portals[0].isJoint = true;
  map.toWalls = 3.6f;
  numberCells(map);
  map.cells[0].center = {0.1f, 1e-3f, 123456.7f};
  const std::string text = jsonText(map);
  const WalkMap again = walkMapFromJsonText(text, "text");
  EXPECT_EQ(again.cells, map.cells);
  EXPECT_EQ(again.toWalls, map.toWalls);
  EXPECT_EQ(again.partOfCell, map.partOfCell);
  EXPECT_EQ(again.roomOfCell, map.roomOfCell);
  EXPECT_EQ(again.portals[0].opening.halfUp, map.portals[0].opening.halfUp);
  EXPECT_EQ(again.portals[0].isJoint, map.portals[0].isJoint);
  EXPECT_EQ(jsonText(again), text);
}

TEST(WalkMapFile, TheWayToTheWallsIsALengthOfTheScene) {
  const WalkMap map = walkMapFromJsonText(changed("/to_walls", 2), "text");
  EXPECT_EQ(moved(map, glm::mat4(0.5f)).toWalls, 1);
  EXPECT_NE(mapErrorOf(changed("/to_walls", -1)), "");
}

TEST(WalkMapFile, TunnelsWithoutRingsAreStraight) {
  nlohmann::json json = nlohmann::json::parse(kGoodMap);
  json["cells"][1].erase("rings");
  EXPECT_EQ(walkMapFromJsonText(json.dump(), "text").cells[1].rings,
            (std::vector<WalkRing>{{0, 1, 1, 2.5f}, {6, 1, 1, 2.5f}}));
}

TEST(WalkMapFile, ErrorsSayFileFieldAndWhatIsWrong) {
  const test::TemporaryFolder folder;
  const auto path = folder.write("map.json", changed("/portals/0/to", 7));
  try {
    readWalkMap(path);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), AllOf(HasSubstr(path.string()), HasSubstr("\"to\""), HasSubstr("one of the 2 cells"),
                                    HasSubstr("walk_map.schema.json")));
  }
  EXPECT_THAT(mapErrorOf(changed("/portals/0/to", 0)), HasSubstr("another cell than"));
  EXPECT_THAT(mapErrorOf(changed("/portals/0/half_up", {0, 0, 0})), HasSubstr("longer than 0"));
  EXPECT_THAT(mapErrorOf(changed("/portals/0/half_up", {0, 1, 1})), HasSubstr("right angles"));
  EXPECT_THAT(mapErrorOf(changed("/cells/1/axis", {1, 1})), HasSubstr("must have length 1"));
  EXPECT_THAT(mapErrorOf(changed("/cells/1/rings", {{0, 1, 1, 2.5}})), HasSubstr("two rings at least"));
  EXPECT_THAT(mapErrorOf(changed("/cells/1/rings", {{3, 1, 1, 2}, {2, 1, 1, 2}})), HasSubstr("before"));
  EXPECT_THAT(mapErrorOf(changed("/cells/1/rings", {{0, 1, 1, 2}, {7, 1, 1, 2}})), HasSubstr("beyond the end"));
  EXPECT_THAT(mapErrorOf(changed("/cells/1/rings", {{0, 1, 1}, {6, 1, 1, 2}})), HasSubstr("four numbers"));
  EXPECT_THAT(mapErrorOf(changed("/cells/1/rings", {{0, 0, 0, 2}, {6, 1, 1, 2}})),
              HasSubstr("ring 0 must have a width"));
  EXPECT_THAT(mapErrorOf(changed("/cells/1/rings", {{0, 1, 1, 2}, {6, 1, 1, 0}})),
              HasSubstr("ring 1 must have a width"));
  EXPECT_THAT(mapErrorOf(changed("/cells/1/axis", {1.002, 0})), HasSubstr("\"axis\""));
  EXPECT_EQ(mapErrorOf(changed("/cells/1/axis", {1.0005, 0})), "") << "what rounding makes of length 1";
  EXPECT_THAT(mapErrorOf(changed("/cells/1/kind", "room")), HasSubstr("only tunnels have rings"));
  EXPECT_THAT(mapErrorOf(changed("/cells", nlohmann::json::array())), HasSubstr("\"cells\""));
  EXPECT_THAT(mapErrorOf(changed("/ways", 1)), HasSubstr("\"ways\""));
}

TEST(WalkMapFile, MessagesNumberCellsAsPortalsDo) {
  EXPECT_THAT(mapErrorOf(changed("/cells/0/width", -1)), HasSubstr("cell 0"));
  EXPECT_THAT(mapErrorOf(changed("/cells/1/width", -1)), HasSubstr("cell 1"));
  EXPECT_THAT(mapErrorOf(changed("/portals/0/half_up", {0, 0, 0})), HasSubstr("opening 0"));
}

TEST(WalkMapFile, WhatCannotBeReadAgainIsNotWritten) {
  WalkMap map = walkMapFromJsonText(kGoodMap, "text");
  map.cells[1].center.x = 2e6f;
  EXPECT_THAT([&] { jsonText(map); }, testing::ThrowsMessage<InputError>(HasSubstr("cell 1 lies 2e+06 units")));
  map.cells[1].center.x = 0;
  map.cells[1].rings.assign(1'000'001, map.cells[1].rings[0]);
  EXPECT_THAT([&] { jsonText(map); }, testing::ThrowsMessage<InputError>(HasSubstr("1000001 rings")));
  map.cells.assign(20001, map.cells[0]);
  EXPECT_THAT([&] { jsonText(map); }, testing::ThrowsMessage<InputError>(HasSubstr("20001 cells")));
}

TEST(WalkOptions, TheirPageHasAllOfThemWithTheirDefaults) {
  const std::string page = readFile(OCELLI_WALKABLE_PAGE, kMaxTextBytes);
  for (const WalkOption& option : walkOptionTable()) {
    std::string name = option.name;
    std::replace(name.begin(), name.end(), '_', '-');
    const std::string row =
        fmt::format("| `--{}` | {}{} |", name, WalkOptions().*option.value, option.isLength ? " m" : "");
    EXPECT_THAT(page, HasSubstr(row));
  }
}

/// The errors of a part of the map, which stands at that place.
test::SchemaAgreement agreementOf(const nlohmann::json& schema, const char* pointer) {
  const auto errorOf = [pointer](const std::string& text) {
    return mapErrorOf(changed(pointer, nlohmann::json::parse(text)));
  };
  return {schema, errorOf, nlohmann::json::parse(kGoodMap).at(nlohmann::json::json_pointer(pointer))};
}

TEST(WalkMapFile, AgreesWithItsSchema) {
  const nlohmann::json schema = readJsonFile(OCELLI_WALK_MAP_SCHEMA);
  test::SchemaAgreement{schema, mapErrorOf, nlohmann::json::parse(kGoodMap)}.check();
  nlohmann::json cell = schema.at("properties").at("cells").at("items");
  cell.at("properties").at("center")["default"] = {0, 0, 0};  // a good one, to change one number at a time
  // Their numbers depend on each other: see the errors above.
  cell.at("properties").at("axis").erase("type");
  cell.at("properties").at("rings").erase("type");
  agreementOf(cell, "/cells/0").check();
}

TEST(WalkMapFile, TheSchemaOfPortalsNamesTheirFields) {
  const nlohmann::json portal = readJsonFile(OCELLI_WALK_MAP_SCHEMA).at("properties").at("portals").at("items");
  const nlohmann::json written =
      nlohmann::json::parse(jsonText(walkMapFromJsonText(kGoodMap, "text"))).at("portals").at(0);
  EXPECT_TRUE(portal.at("properties").contains("joint"));
  for (const auto& [name, value] : written.items()) {
    EXPECT_TRUE(portal.at("properties").contains(name)) << name;
    nlohmann::json without = written;
    without.erase(name);
    EXPECT_THAT(mapErrorOf(changed("/portals/0", without)), HasSubstr('"' + name + '"')) << "it is required";
  }
  EXPECT_EQ(portal.at("required").size(), written.size());
}

}  // namespace
}  // namespace ocelli
