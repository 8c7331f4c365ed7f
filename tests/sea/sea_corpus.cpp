// Writes the corpus of seas anew: `sea_corpus tests/sea/corpus`, after the format has changed. Files of cases that are
// no more are removed.
#include <cstdio>
#include <filesystem>
#include <fstream>

#include "tests/sea/sea_cases.h"

int main(int argumentCount, char** arguments) {
  if (argumentCount != 2 || !std::filesystem::is_directory(arguments[1])) {
    std::fprintf(stderr, "usage: sea_corpus FOLDER\n");
    return 2;
  }
  const std::filesystem::path folder = arguments[1];
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() == ".sea") {
      std::filesystem::remove(entry.path());
    }
  }
  for (const ocelli::test::SeaCase& file : ocelli::test::seaCases()) {
    std::ofstream(folder / (file.name + ".sea"), std::ios::binary)
        .write(reinterpret_cast<const char*>(file.bytes.data()), static_cast<std::streamsize>(file.bytes.size()));
  }
  return 0;
}
