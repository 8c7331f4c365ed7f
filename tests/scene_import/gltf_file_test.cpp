#include "oc_core/scene/import/gltf_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/base/temporary_folder.h"
#include "tests/scene/animated_gltf.h"

namespace ocelli {
namespace {

using test::TemporaryFolder;
using testing::ElementsAre;
using testing::FloatEq;
using testing::Optional;

/// The numbers of accessor 0 of a file with one buffer of 16 bytes: the floats 1, 2, 3, 4.
std::optional<std::vector<float>> numbersOf(const std::string& accessor, const std::string& view,
                                            const std::string& buffer = "0") {
  const TemporaryFolder folder;
  GltfFile file(folder.write(
      "a.gltf", R"({"accessors": [{)" + accessor + R"(}], "bufferViews": [{"buffer": )" + buffer + ", " + view +
                    R"(}], "buffers": [{"byteLength": 16, "uri": "data:;base64,AACAPwAAAEAAAEBAAACAQA=="}]})"));
  return file.numbers(0U);
}

constexpr const char* kWholeView = R"("byteLength": 16)";

TEST(GltfFile, ReadsViewsWithOffsetsAndStrides) {
  const std::string floats = R"("bufferView": 0, "componentType": 5126, )";
  EXPECT_THAT(numbersOf(floats + R"("type": "SCALAR", "count": 4)", kWholeView), Optional(ElementsAre(1, 2, 3, 4)));
  EXPECT_THAT(numbersOf(floats + R"("type": "VEC2", "count": 2)", kWholeView), Optional(ElementsAre(1, 2, 3, 4)));
  EXPECT_THAT(numbersOf(floats + R"("type": "SCALAR", "count": 2, "byteOffset": 4)",
                        R"("byteLength": 12, "byteOffset": 4, "byteStride": 4)"),
              Optional(ElementsAre(3, 4)));
  EXPECT_THAT(numbersOf(floats + R"("type": "SCALAR", "count": 2)", R"("byteLength": 16, "byteStride": 8)"),
              Optional(ElementsAre(1, 3)));
}

TEST(GltfFile, NormalizesWholeNumbers) {
  // The bytes of 1.0f are 0, 0, 128 and 63.
  const auto read = [](int type, int count) {
    return numbersOf(R"("bufferView": 0, "type": "SCALAR", "componentType": )" + std::to_string(type) +
                         R"(, "count": )" + std::to_string(count),
                     kWholeView);
  };
  EXPECT_THAT(read(5121, 4), Optional(ElementsAre(0, 0, FloatEq(128 / 255.0f), FloatEq(63 / 255.0f))));
  EXPECT_THAT(read(5120, 4), Optional(ElementsAre(0, 0, -1, FloatEq(63 / 127.0f))));
  EXPECT_THAT(read(5123, 2), Optional(ElementsAre(0, FloatEq(0x3f80 / 65535.0f))));
  EXPECT_THAT(read(5122, 2), Optional(ElementsAre(0, FloatEq(0x3f80 / 32767.0f))));
}

TEST(GltfFile, ReadsNothingBeyondWhatThereIs) {
  const std::string floats = R"("bufferView": 0, "componentType": 5126, "type": "SCALAR", )";
  for (const auto& [accessor, view] : std::vector<std::pair<std::string, std::string>>{
           {floats + R"("count": 5)", kWholeView},
           {floats + R"("count": 5)", R"("byteLength": 20)"},
           {floats + R"("count": 0)", kWholeView},
           {floats + R"("count": -1)", kWholeView},
           {floats + R"("count": 1e30)", kWholeView},
           {floats + R"("count": 4611686018427387905)", kWholeView},
           {floats + R"("count": 1, "byteOffset": 16)", kWholeView},
           {floats + R"("count": 1, "byteOffset": 18446744073709551615)", kWholeView},
           {floats + R"("count": 1)", R"("byteLength": 4, "byteOffset": 13)"},
           {floats + R"("count": 2)", R"("byteLength": 16, "byteStride": 1)"},
           {floats + R"("count": 2)", R"("byteLength": 16, "byteStride": 4000000000)"},
           {floats + R"("count": 1, "sparse": {})", kWholeView},
           {R"("bufferView": 7, "componentType": 5126, "type": "SCALAR", "count": 1)", kWholeView},
           {R"("bufferView": 0, "componentType": 5130, "type": "SCALAR", "count": 1)", kWholeView},
           {R"("bufferView": 0, "componentType": 5126, "type": "MAT4", "count": 1)", kWholeView}}) {
    EXPECT_FALSE(numbersOf(accessor, view)) << accessor << view;
  }
  EXPECT_FALSE(numbersOf(floats + R"("count": 1)", kWholeView, "1"));
}

TEST(GltfFile, TakesBinaryFilesThatEndAnywhere) {
  test::AnimatedGltf made;
  made.floats("SCALAR", {1, 2, 3});
  const std::string whole = made.binary(R"("nodes": [])");
  const TemporaryFolder folder;
  GltfFile file(folder.write("a.glb", whole));
  EXPECT_THAT(file.numbers(0U), Optional(ElementsAre(1, 2, 3)));
  for (size_t size = 0; size < whole.size(); ++size) {
    GltfFile cut(folder.write("b.glb", whole.substr(0, size)));
    EXPECT_FALSE(cut.numbers(0U)) << size;
  }
  GltfFile missing(folder / "none.gltf");
  EXPECT_FALSE(missing.numbers(0U));
}

}  // namespace
}  // namespace ocelli
