#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <vector>

#include "oc_core/base/error.h"
#include "oc_core/volume/import/vti_file.h"
#include "tests/base/temporary_folder.h"

namespace ocelli {
namespace {

using test::fileBytes;
using test::TemporaryFolder;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::ThrowsMessage;

/// 2 x 2 x 1 points, and 1 cell where `depth` is 1.
std::string vtiText(const std::string& data, const std::string& attributes = "", int depth = 0) {
  const std::string extent = "0 1 0 1 0 " + std::to_string(depth);
  return "<VTKFile type=\"ImageData\" byte_order=\"LittleEndian\"><ImageData WholeExtent=\"" + extent + "\" " +
         attributes + "><Piece Extent=\"" + extent + "\">" + data + "</Piece></ImageData></VTKFile>";
}

std::string pointData(const std::string& array) {
  return "<PointData>" + array + "</PointData>";
}

VtiHeader parsedVti(const std::string& text) {
  const MemorySource source(std::as_bytes(std::span(text)), "a.vti");
  return parseVti(source);
}

/// The voxels, as bytes.
std::string placed(const std::string& text) {
  const TemporaryFolder folder;
  const std::filesystem::path scratchPath = folder.write("scratch", "");
  const MemorySource source(std::as_bytes(std::span(text)), "a.vti");
  VtiHeader header = parseVti(source);
  ScratchOutput scratch(scratchPath, folder.path(), nullptr);
  placeVtiVoxels(header, source, "a.vti", scratch);
  return fileBytes(scratchPath);
}

TEST(Vti, ArrayOfGhostsIsNotTheVolume) {
  const std::string ghosts = R"(<DataArray type="UInt8" Name="vtkGhostType" format="ascii">0 0 0 2</DataArray>)";
  const std::string array = R"(<DataArray type="UInt8" Name="a" format="ascii">1 2 3 4</DataArray>)";
  EXPECT_EQ(placed(vtiText(pointData(ghosts + array))), "\1\2\3\4");
  EXPECT_THAT(parsedVti(vtiText(pointData(ghosts + array))).record.warnings, ElementsAre(HasSubstr("vtkGhostType")));
  EXPECT_THAT([&] { parsedVti(vtiText(pointData(ghosts))); },
              ThrowsMessage<InputError>(HasSubstr("there is no array")));
}

TEST(Vti, PlacesPointsAndTheMiddlesOfCells) {
  const std::string array = R"(<DataArray type="UInt8" Name="a" format="ascii">1 2 3 4</DataArray>)";
  const std::string where = R"(Origin="10 20 30" Spacing="2 3 4" Direction="0 -1 0 1 0 0 0 0 1")";
  const VolumeGrid points = parsedVti(vtiText(pointData(array), where)).record.grid;
  EXPECT_EQ(points.size, glm::ivec3(2, 2, 1));
  // Column i of the directions is the axis i.
  EXPECT_EQ(points.worldFromIndex[0], glm::dvec4(0, 2, 0, 0));
  EXPECT_EQ(points.worldFromIndex[1], glm::dvec4(-3, 0, 0, 0));
  EXPECT_EQ(points.worldFromIndex[3], glm::dvec4(10, 20, 30, 1));
  const VolumeGrid cells = parsedVti(vtiText("<CellData>" + array + "</CellData>", where, 1)).record.grid;
  EXPECT_EQ(cells.size, glm::ivec3(1));
  EXPECT_EQ(cells.worldFromIndex[3], glm::dvec4(10 - 1.5, 20 + 1, 30 + 2, 1));
}

TEST(Vti, TakesTheActiveScalarsAndSaysSo) {
  const VtiHeader header = parsedVti(
      vtiText(R"(<PointData Scalars="b"><DataArray type="UInt8" Name="a" format="ascii">1 2 3 4</DataArray>)"
              R"(<DataArray type="Int16" Name="b" format="ascii">1 2 3 4</DataArray>)"
              R"(<DataArray type="UInt8" Name="c" NumberOfComponents="3" format="ascii">0</DataArray></PointData>)"));
  EXPECT_EQ(header.type, StoredType::kInt16);
  EXPECT_THAT(header.record.warnings, ElementsAre(HasSubstr("of 3 arrays, \"b\" is taken")));
}

TEST(Vti, ReadsTextAndBase64) {
  EXPECT_EQ(placed(vtiText(pointData(R"(<DataArray type="UInt8" format="ascii"> 65 66
 67 68 </DataArray>)"))),
            "ABCD");
  // 4 (UInt32, little-endian), then "ABCD".
  EXPECT_EQ(placed(vtiText(pointData("<DataArray type=\"UInt8\" format=\"binary\">\n BAAA\nAEFCQ0Q= \n</DataArray>"))),
            "ABCD");
}

TEST(Vti, SaysWhatIsWrong) {
  const auto expect = [](const std::string& text, const std::string& message) {
    EXPECT_THAT([&] { placed(text); }, ThrowsMessage<InputError>(HasSubstr(message))) << text;
  };
  const auto array = [](const std::string& attributes, const std::string& content) {
    return vtiText(pointData("<DataArray " + attributes + ">" + content + "</DataArray>"));
  };
  expect("", "no sound XML");
  expect("<VTKFile type=\"ImageData\"><ImageData>", "no sound XML");
  expect("<html/>", "no image data of VTK");
  expect(vtiText(""), "there is no array");
  expect(vtiText(pointData(R"(<DataArray type="UInt8" NumberOfComponents="3" format="ascii">1</DataArray>)")),
         "several numbers a voxel");
  expect(array(R"(type="String" format="ascii")", "a"), "\"String\" are not read");
  expect(array(R"(type="UInt8" format="ascii")", "1 2 3"), "3 bytes of voxels, 1 fewer");
  expect(array(R"(type="UInt8" format="ascii")", "1 2 3 4 5"), "more numbers");
  expect(array(R"(type="UInt8" format="ascii")", "1 2 3 256"), "\"256\" is no number of the array's type");
  expect(array(R"(type="Float32" format="ascii")", "1 2 3 nan"), "\"nan\"");
  expect(array(R"(type="UInt8" format="binary")", "BAAAAEFC"), "ends too early");
  expect(array(R"(type="UInt8" format="binary")", "BAAA!EFCQ0Q="), "not sound base64");
  expect(array(R"(type="UInt8" format="binary")", "BQAAAEFCQ0RF"), "has 5 bytes, and its extent and type need 4");
  expect(array(R"(type="UInt8" format="appended" offset="0")", ""), "the file has none");
  std::string text = array(R"(type="UInt8" format="ascii")", "1 2 3 4");
  text.replace(text.find("LittleEndian"), 12, "MiddleEndian");
  expect(text, "byte_order is \"MiddleEndian\"");
  text = array(R"(type="UInt8" format="ascii")", "1 2 3 4");
  text.replace(text.find("byte_order"), 0, "compressor=\"vtkLZ4DataCompressor\" ");
  expect(text, "compressed by vtkLZ4DataCompressor");
  text = array(R"(type="UInt8" format="ascii")", "1 2 3 4");
  text.replace(text.find("Piece Extent=\"0 1"), 17, "Piece Extent=\"1 0");
  expect(text, "0 x 2 x 1 voxels");
  text = array(R"(type="UInt8" format="ascii")", "1 2 3 4");
  text.insert(text.find("<Piece"), R"(<Piece Extent="0 1 0 1 0 0"></Piece>)");
  expect(text, "several pieces");
  expect(vtiText(pointData(R"(<DataArray type="UInt8" format="ascii">1 2 3 4</DataArray>)"), "Spacing=\"1 2\""),
         "must be 3 numbers");
}

TEST(Vti, RefusesBlocksThatCannotBe) {
  const auto compressed = [](const std::vector<uint32_t>& header) {
    std::string text =
        "<VTKFile type=\"ImageData\" compressor=\"vtkZLibDataCompressor\"><ImageData><Piece Extent=\"0 1 0 1 0 0\">"
        "<PointData><DataArray type=\"UInt8\" format=\"appended\" offset=\"0\"/></PointData></Piece></ImageData>"
        "<AppendedData encoding=\"raw\">_";
    text.append(reinterpret_cast<const char*>(header.data()), header.size() * sizeof(uint32_t));
    return text;
  };
  for (const std::vector<uint32_t>& header : {std::vector<uint32_t>{0, 4, 0},
                                              {0xffffffff, 4, 0},
                                              {1, 5, 0, 1},
                                              {1, 4, 5, 1},
                                              {2, 4, 0, 1, 1},
                                              {5, 0, 0, 1}}) {
    EXPECT_THROW(placed(compressed(header)), InputError) << header[0] << " " << header[1] << " " << header[2];
  }
}

}  // namespace
}  // namespace ocelli
