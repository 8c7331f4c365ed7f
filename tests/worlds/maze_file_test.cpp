#include "oc_core/worlds/maze_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "oc_core/base/error.h"
#include "oc_core/base/file_bytes.h"
#include "oc_core/base/json_fields.h"
#include "tests/base/schema_agreement.h"
#include "tests/base/temporary_folder.h"
#include "tests/worlds/random_mazes.h"

namespace ocelli {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::ThrowsMessage;

const char* const kGood =
    R"({"plan": ["+-+-+", "|    ", "+-+-+"], "landmarks": [{"row": 0, "column": 1, "shape": "cone"}]})";

std::string errorOf(const std::string& text) {
  try {
    mazeFromJsonText(text, "text");
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(MazeFile, ComesBackTheSame) {
  const test::TemporaryFolder folder;
  for (uint64_t seed = 0; seed < 100; ++seed) {
    Maze maze = generateMaze(test::mazeOptions(seed));
    maze.wallHeight = 1.7f;
    const std::string text = jsonText(maze);
    EXPECT_EQ(mazeFromJsonText(text, "text"), maze) << text;
    EXPECT_EQ(jsonText(mazeFromJsonText(text, "text")), text);
    writeFile(folder.path() / "maze.json", text);
    EXPECT_EQ(readMaze(folder.path() / "maze.json"), maze);
  }
  EXPECT_THROW(readMaze(folder.path() / "none.json"), InputError);
}

TEST(MazeFile, SaysWhereTheDrawingIsWrong) {
  const auto expectComplaint = [](const std::string& plan, const auto& matcher) {
    EXPECT_THAT(errorOf(R"({"plan": )" + plan + "}"), matcher) << plan;
  };
  expectComplaint(R"("+-+")", HasSubstr("\"plan\" must be an array"));
  expectComplaint(R"([])", HasSubstr("0 lines"));
  expectComplaint(R"(["+-+-+", "|    "])", HasSubstr("2 lines"));
  expectComplaint(R"(["+-+-+", 1, "+-+-+"])", HasSubstr("line 2"));
  expectComplaint(R"(["+-+-+", "|   |", "+-+-"])", HasSubstr("4 characters in line 3"));
  expectComplaint(R"(["+-+-+", "|  ", "+-+-+"])", HasSubstr("3 characters in line 2, but 5 in line 1"));
  expectComplaint(R"(["+-+-+", "|  x ", "+-+-+"])", HasSubstr("character 4 of line 2 of the plan must be a cell"));
  expectComplaint(R"(["+-+-+", "| -  ", "+-+-+"])", HasSubstr("character 3 of line 2 of the plan must be a wall '|'"));
  expectComplaint(R"(["+-+|+", "|    ", "+-+-+"])", HasSubstr("character 4 of line 1 of the plan must be a wall '-'"));
  expectComplaint(R"(["+- -+", "|    ", "+-+-+"])", HasSubstr("character 3 of line 1 of the plan must be a post"));
  expectComplaint(R"(["+-+-+", "|é  ", "+-+-+"])", HasSubstr("plan"));
  expectComplaint(R"(["+-+-+", "|   |", "+-+-+"])", HasSubstr("no entrance"));
  expectComplaint(R"(["+ +-+", "|    ", "+-+-+"])",
                  AllOf(HasSubstr("two entrances"), HasSubstr("(row 0, column 0)"), HasSubstr("(row 0, column 1)")));
  expectComplaint(R"(["+-+-+", "| |  ", "+-+-+"])", HasSubstr("(row 0, column 0) cannot be reached"));
  expectComplaint(R"(["+-+", "|  ", "+-+"])", HasSubstr("one cell"));
  nlohmann::json wide;
  wide["plan"] = std::vector<std::string>(3, std::string(131, ' '));
  EXPECT_THAT(errorOf(wide.dump()), HasSubstr("131 characters"));
  wide["plan"] = std::vector<std::string>(131, "+-+");
  EXPECT_THAT(errorOf(wide.dump()), HasSubstr("131 lines"));
}

TEST(MazeFile, RefusesHostileDocuments) {
  EXPECT_EQ(errorOf(kGood), "");
  for (const char* text :
       {"", "[", "null", "[]", "1", "\"plan\"", "{}", "{\"plan\": null}", "{\"plan\": [[], [], []]}"}) {
    EXPECT_NE(errorOf(text), "") << text;
  }
  EXPECT_NE(errorOf(std::string(100'000, '[')), "");
  for (const char* field : {"cell_size", "wall_height", "wall_thickness"}) {
    for (const char* bad : {"0", "-1", "1e30", "-1e308", "\"3\"", "null", "[3]", "true"}) {
      nlohmann::json document = nlohmann::json::parse(kGood);
      document[field] = nlohmann::json::parse(bad);
      EXPECT_THAT(errorOf(document.dump()), HasSubstr(field)) << bad;
    }
  }
  nlohmann::json document = nlohmann::json::parse(kGood);
  document["cell_size"] = 0.1;
  EXPECT_THAT(errorOf(document.dump()), HasSubstr("no passage"));
  for (const char* bad :
       {"1", "{}", "[1]", "[{}]", R"([{"row": 1e9, "column": 0, "shape": "cone"}])",
        R"([{"row": 0, "column": 0.5, "shape": "cone"}])", R"([{"row": 0, "column": 0, "shape": "cow"}])",
        R"([{"row": 0, "column": 0, "shape": "cone", "east": 1e300}])",
        R"([{"row": 2, "column": 0, "shape": "cone"}])"}) {
    document = nlohmann::json::parse(kGood);
    document["landmarks"] = nlohmann::json::parse(bad);
    EXPECT_NE(errorOf(document.dump()), "") << bad;
  }
  document["landmarks"] = nlohmann::json::array({{{"row", 0}, {"column", 5}, {"shape", "cone"}}});
  EXPECT_THAT(errorOf(document.dump()), AllOf(HasSubstr("landmark 1"), HasSubstr("(row 0, column 5)")));
  document["landmarks"] = nlohmann::json(std::vector<nlohmann::json>(4097, nlohmann::json::object()));
  EXPECT_THAT(errorOf(document.dump()), HasSubstr("4096"));
}

TEST(MazeFile, CorpusReadsAsItsNamesSay) {
  size_t files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(OCELLI_MAZE_CORPUS)) {
    const bool bad = entry.path().filename().string().starts_with("bad_");
    EXPECT_EQ(errorOf(readFile(entry.path())).empty(), !bad) << entry.path();
    ++files;
  }
  EXPECT_GE(files, 5u);
}

TEST(MazeFile, GuideShowsAMaze) {
  const std::string guide = readFile(OCELLI_SOURCE_DIR "/docs/files.md");
  const size_t start = guide.find("```json\n", guide.find("## Maze")) + 8;
  const Maze maze = mazeFromJsonText(guide.substr(start, guide.find("```", start) - start), "docs/files.md");
  EXPECT_EQ(maze.rows(), 3);
  EXPECT_EQ(maze.landmarks.size(), 2u);
}

TEST(MazeFile, AgreesWithItsSchema) {
  const nlohmann::json schema = readJsonFile(OCELLI_MAZE_SCHEMA);
  test::SchemaAgreement{schema, errorOf, nlohmann::json::parse(kGood)}.check();
  // A landmark by itself.
  const auto landmarkErrorOf = [](const std::string& text) {
    nlohmann::json document = nlohmann::json::parse(kGood);
    document["landmarks"] = nlohmann::json::array({nlohmann::json::parse(text)});
    return errorOf(document.dump());
  };
  const nlohmann::json landmark = nlohmann::json::parse(kGood).at("landmarks").at(0);
  test::SchemaAgreement{schema.at("properties").at("landmarks").at("items"), landmarkErrorOf, landmark}.check();
}

TEST(MazeFile, SchemaDefaultsAreTheReaders) {
  const nlohmann::json schema = readJsonFile(OCELLI_MAZE_SCHEMA);
  const Maze maze = mazeFromJsonText(kGood, "text");
  for (const char* field : {"cell_size", "wall_height", "wall_thickness"}) {
    nlohmann::json document = nlohmann::json::parse(kGood);
    document[field] = schema.at("properties").at(field).at("default");
    EXPECT_EQ(mazeFromJsonText(document.dump(), "text"), maze) << field;
  }
  for (const char* field : {"color", "east", "south"}) {
    nlohmann::json document = nlohmann::json::parse(kGood);
    document["landmarks"][0][field] =
        schema.at("properties").at("landmarks").at("items").at("properties").at(field).at("default");
    EXPECT_EQ(mazeFromJsonText(document.dump(), "text"), maze) << field;
  }
}

}  // namespace
}  // namespace ocelli
