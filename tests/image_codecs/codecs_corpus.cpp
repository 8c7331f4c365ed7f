// Writes the seed corpus of the codec fuzzer anew: codecs_corpus tests/image_codecs/corpus
#include <filesystem>
#include <string>

#include "oc_core/base/file_bytes.h"
#include "oc_core/image_codecs/image_codec.h"
#include "tests/image_codecs/coded_samples.h"

namespace {

constexpr int kWidth = 12;
constexpr int kHeight = 8;

/// As fuzz/image_codecs_fuzzer.cpp takes them.
void writeSeed(const std::filesystem::path& path, size_t row, const std::vector<std::byte>& bytes) {
  std::string seed{static_cast<char>(row), static_cast<char>(kWidth), static_cast<char>(kHeight)};
  seed.append(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  ocelli::writeFile(path, seed);
}

}  // namespace

int main(int argumentCount, char** arguments) {
  if (argumentCount != 2) {
    return 2;
  }
  const std::filesystem::path folder = arguments[1];
  size_t row = 0;
  for (const ocelli::ColorCodec& codec : ocelli::colorCodecs()) {
    writeSeed(folder / (std::string("color_") + codec.name), row++,
              codec.encode(ocelli::test::coloredDisc(kWidth, kHeight), 80));
  }
  for (const ocelli::DepthCodec& codec : ocelli::depthCodecs()) {
    writeSeed(folder / (std::string("depth_") + codec.name), row++,
              codec.encode(ocelli::test::depthOfDisc(kWidth, kHeight)));
  }
}
