#include "oc_core/labels/label_table.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "oc_core/base/error.h"
#include "oc_core/image/color.h"
#include "tests/base/temporary_folder.h"

namespace ocelli {
namespace {

using test::TemporaryFolder;
using testing::AllOf;
using testing::HasSubstr;
using testing::ThrowsMessage;

std::vector<SceneLabel> labelsIn(const std::string& table) {
  const TemporaryFolder folder;
  return readLabels(folder.write("labels.csv", table));
}

TEST(LabelTable, NamesItsColumns) {
  const std::vector<SceneLabel> labels = labelsIn(
      "id,Text,x,y,z,size,Colour,nx,ny,nz\r\n7,\"Nose, left\",1,-2.5,3e1,0.25,#ff0000,0,1,0\r\n,Ohr,4,5,6,,,,,\r\n");
  ASSERT_EQ(labels.size(), 2u);
  EXPECT_EQ(labels[0].text, "Nose, left");
  EXPECT_EQ(labels[0].position, glm::vec3(1, -2.5f, 30));
  EXPECT_EQ(labels[0].size, 0.25);
  EXPECT_EQ(labels[0].color, glm::vec3(1, 0, 0));
  EXPECT_EQ(labels[0].facing, glm::vec3(0, 1, 0));
  EXPECT_EQ(labels[1].text, "Ohr");
  EXPECT_FALSE(labels[1].size);
  EXPECT_EQ(labels[1].color, glm::vec3(1));
  EXPECT_FALSE(labels[1].facing);
}

TEST(LabelTable, NeedsPlacesAndTextsAlone) {
  const std::vector<SceneLabel> labels = labelsIn("x,y,z,text\n0,0,+1,\"two\nlines\"\n\n , , , \n");
  ASSERT_EQ(labels.size(), 1u);
  EXPECT_EQ(labels[0].text, "two\nlines");
  EXPECT_EQ(labels[0].position.z, 1);
}

TEST(LabelTable, SaysWhatIsWrongAndWhere) {
  const auto refusedWith = [](const std::string& table, const std::string& where, const std::string& what) {
    EXPECT_THAT([&] { labelsIn(table); }, ThrowsMessage<InputError>(AllOf(HasSubstr(where), HasSubstr(what)))) << table;
  };
  refusedWith("", "labels.csv", "is empty");
  refusedWith("1,2,3,nose\n", "labels.csv:1", "no column \"x\"");
  refusedWith("x,y,z,text\n", "labels.csv", "no labels");
  refusedWith("x,y,z,text\n1,2,3,a\n1,,3,b\n", "labels.csv:3", "column \"y\" is empty");
  refusedWith("x,y,z,text\n1,2,3 m,b\n", "labels.csv:2", "\"3 m\"");
  refusedWith("x,y,z,text\n1,2,nan,b\n", "labels.csv:2", "\"nan\"");
  refusedWith("x,y,z,text\n1,2,3\n", "labels.csv:2", "text");
  refusedWith("x,y,z,text\n1,2,3," + std::string(kMaxLabelCharacters + 1, 'a') + "\n", "labels.csv:2", "1000");
  refusedWith("x,y,z,text,size\n1,2,3,a,0\n", "labels.csv:2", "positive");
  refusedWith("x,y,z,text,color\n1,2,3,a,red\n", "labels.csv:2", "\"red\"");
  refusedWith("x,y,z,text,nx,ny,nz\n1,2,3,a,0,0,0\n", "labels.csv:2", "no direction");
}

}  // namespace
}  // namespace ocelli
