#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "oc_core/base/error.h"
#include "oc_core/volume/import/meta_image_file.h"
#include "oc_core/volume/import/volume_reader_rows.h"
#include "tests/base/temporary_folder.h"

namespace ocelli {
namespace {

using test::fileBytes;
using test::TemporaryFolder;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::ThrowsMessage;

MetaImageHeader parsed(const std::string& text) {
  const MemorySource source(std::as_bytes(std::span(text)), "a.mha");
  return parseMetaImage(source);
}

/// A header of 3 x 2 x 2 bytes, with more fields.
std::string metaHeader(const std::string& fields = "", const std::string& data = "LOCAL") {
  return "ObjectType = Image\nNDims = 3\nDimSize = 3 2 2\nElementSpacing = 1 2 3\nElementType = MET_UCHAR\n" + fields +
         "ElementDataFile = " + data + "\n";
}

TEST(MetaImage, MatrixHasADirectionAfterTheOther) {
  const MetaImageHeader header =
      parsed(metaHeader("TransformMatrix = 0 1 0 0 0 1 1 0 0\nOffset = 7 8 9\nAnatomicalOrientation = AIR\n"));
  const glm::dmat4& world = header.record.grid.worldFromIndex;
  EXPECT_EQ(world[0], glm::dvec4(0, 1, 0, 0));
  EXPECT_EQ(world[1], glm::dvec4(0, 0, 2, 0));
  EXPECT_EQ(world[2], glm::dvec4(3, 0, 0, 0));
  EXPECT_EQ(world[3], glm::dvec4(7, 8, 9, 1));
  EXPECT_TRUE(header.record.grid.isAnatomical);
  EXPECT_THAT(header.record.warnings, IsEmpty()) << "the letters are those of the matrix";
}

TEST(MetaImage, SaysWhatItDoesNotKeep) {
  EXPECT_THAT(parsed(metaHeader("AnatomicalOrientation = LPS\n")).record.warnings,
              ElementsAre(HasSubstr("AnatomicalOrientation = LPS, but its TransformMatrix is RAI")));
  EXPECT_THAT(parsed(metaHeader("CenterOfRotation = 1 0 0\nFoo = 3\nBar = 4\n")).record.warnings,
              ElementsAre(HasSubstr("centre of rotation"), HasSubstr("Bar, Foo")));
  EXPECT_FALSE(parsed(metaHeader()).record.grid.isAnatomical);
}

TEST(MetaImage, KeepsModalityAndMeaning) {
  const VolumeRecord record = parsed(metaHeader("Modality = MET_MOD_CT\nElementToIntensityFunctionSlope = 2\n"
                                                "ElementToIntensityFunctionOffset = -5\n"))
                                  .record;
  EXPECT_EQ(record.facts.modality, "CT");
  EXPECT_EQ(record.scale, 2);
  EXPECT_EQ(record.offset, -5);
}

TEST(MetaImage, FourthDimensionIsTime) {
  const MetaImageHeader header = parsed(
      "NDims = 4\nDimSize = 3 2 2 3\nElementSpacing = 1 1 1 0.5\nOffset = 0 0 0 2\nElementType = MET_FLOAT\n"
      "ElementDataFile = LOCAL\n");
  EXPECT_EQ(header.volumes, 3U);
  EXPECT_THAT(header.record.times, ElementsAre(2, 2.5, 3));
}

TEST(MetaImage, NamesFilesByListAndPattern) {
  EXPECT_THAT(parsed(metaHeader("", "LIST") + "a.raw\nb.raw\n").files, ElementsAre("a.raw", "b.raw"));
  EXPECT_THAT(parsed(metaHeader("", "s%03d.raw 7 11 2")).files, ElementsAre("s007.raw", "s009.raw", "s011.raw"));
  EXPECT_THAT(parsed(metaHeader("", "s%d.raw")).files, ElementsAre("s1.raw", "s2.raw"));
  for (const char* name : {"LISTct.raw", "50%_ct.raw", "100%"}) {
    EXPECT_THAT(parsed(metaHeader("", name)).files, ElementsAre(name));
  }
  for (const char* bad : {"s%s.raw 1 2 1", "s%d%d.raw 1 2 1", "s%03n.raw", "s%d.raw 5 1 1", "s%d.raw 1 1e12 1",
                          "s%99999999999d.raw 1 2 1"}) {
    EXPECT_THROW(parsed(metaHeader("", bad)), InputError) << bad;
  }
}

TEST(MetaImage, ReadsSlicesOfSeveralFilesAndVoxelsAtTheEnd) {
  const TemporaryFolder folder;
  folder.write("s1.raw", "xxabcdef");
  folder.write("s2.raw", "xxghijkl");
  const std::filesystem::path scratchPath = folder.write("scratch", "");
  ScratchOutput scratch(scratchPath, folder.path(), nullptr);
  const VolumeRecord record =
      readMetaImage({folder.write("a.mhd", metaHeader("HeaderSize = -1\n", "s%d.raw 1 2 1"))}, scratch, nullptr);
  EXPECT_THAT(record.file, IsEmpty());
  EXPECT_EQ(fileBytes(scratchPath), "abcdefghijkl");

  folder.write("all.raw", "a header, then abcdefghijkl");
  const VolumeRecord mapped =
      readMetaImage({folder.write("b.mhd", metaHeader("HeaderSize = -1\n", "all.raw"))}, scratch, nullptr);
  EXPECT_EQ(mapped.file, (folder / "all.raw").string());
  EXPECT_THAT(mapped.begins, ElementsAre(15));

  folder.write("s2.raw", "xxghi");
  ScratchOutput other(folder.write("scratch2", ""), folder.path(), nullptr);
  EXPECT_THAT(
      [&] { readMetaImage({folder.write("c.mhd", metaHeader("HeaderSize = 2\n", "s%d.raw 1 2 1"))}, other, nullptr); },
      ThrowsMessage<InputError>(HasSubstr("s2.raw: the file ends too early")));
}

TEST(MetaImage, SaysWhatIsWrong) {
  const auto expect = [](const std::string& text, const std::string& message) {
    EXPECT_THAT([&] { parsed(text); }, ThrowsMessage<InputError>(HasSubstr(message))) << text;
  };
  expect("", "no ElementDataFile");
  expect("NDims = 3\n", "no ElementDataFile");
  expect("what is this\nElementDataFile = LOCAL\n", "line 1 of the header is not");
  expect("NDims = 3\nNDims = 3\nElementDataFile = LOCAL\n", "line 2 of the header repeats NDims");
  expect("ObjectType = Mesh\nElementDataFile = LOCAL\n", "ObjectType = Mesh");
  expect("NDims = 2\nDimSize = 3 2\nElementDataFile = LOCAL\n", "2 dimensions");
  expect("NDims = 3\nDimSize = 3 2\nElementDataFile = LOCAL\n", "DimSize has 2 numbers");
  expect("NDims = 3\nDimSize = 3 2 x\nElementDataFile = LOCAL\n", "no numbers");
  expect("NDims = 3\nDimSize = 3 2 0.5\nElementDataFile = LOCAL\n", "not whole");
  expect("NDims = 3\nDimSize = 3 2 0\nElementDataFile = LOCAL\n", "3 x 2 x 0 voxels");
  expect("NDims = 3\nDimSize = 1e6 1e6 1e6\nElementType = MET_SHORT\nElementDataFile = LOCAL\n",
         "larger than any file");
  expect(metaHeader("ElementNumberOfChannels = 3\n"), "3 numbers each");
  expect(metaHeader("BinaryData = False\n"), "written as text");
  expect(metaHeader("TransformMatrix = 1 0 0 1\n"), "TransformMatrix has 4 numbers, and must have 9");
  expect(metaHeader("Offset = nan 0 0\n"), "no numbers");
  expect(metaHeader("HeaderSize = -2\n"), "HeaderSize = -2");
  expect(metaHeader("HeaderSize = -1\nCompressedData = True\n"), "HeaderSize = -1");
}

}  // namespace
}  // namespace ocelli
