#include "oc_core/remote_measure/unnamed_file.h"

#include <gtest/gtest.h>

#include <fstream>

#include "oc_core/base/error.h"
#include "tests/base/temporary_folder.h"

namespace ocelli {
namespace {

std::span<const std::byte> bytesOfText(std::string_view text) {
  return std::as_bytes(std::span(text.data(), text.size()));
}

TEST(UnnamedFile, isReadByItsPathWhileItLives) {
  const test::TemporaryFolder folder;
  std::string path;
  {
    UnnamedFile file(folder / ".");
    file.append(bytesOfText("one "));
    file.append(bytesOfText("two"));
    path = file.path();
    std::string text;
    std::getline(std::ifstream(path), text);
    EXPECT_EQ(text, "one two");
    EXPECT_TRUE(std::filesystem::is_empty(folder / "."));
    EXPECT_EQ(file.size(), 7u);
    const std::span<const std::byte> mapped = file.map();
    EXPECT_EQ(std::string(reinterpret_cast<const char*>(mapped.data()), mapped.size()), "one two");
  }
  EXPECT_FALSE(std::ifstream(path).good());
}

TEST(UnnamedFile, isWrittenByItsPath) {
  UnnamedFile file;
  EXPECT_TRUE(file.map().empty());
  std::ofstream(file.path()) << "three";
  EXPECT_EQ(file.map().size(), 5u);
}

TEST(UnnamedFile, needsAFolder) {
  const test::TemporaryFolder folder;
  EXPECT_THROW(UnnamedFile(folder / "missing"), WorkError);
}

}  // namespace
}  // namespace ocelli
