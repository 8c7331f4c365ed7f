// Writes the corpus of `.svol` files anew: `frames_svol_corpus tests/display_sim_frames/corpus`, after the format has
// changed. Files of cases that are no more are removed.
#include <cstdio>
#include <filesystem>
#include <fstream>

#include "tests/display_sim_frames/svol_cases.h"

int main(int argumentCount, char** arguments) {
  if (argumentCount != 2 || !std::filesystem::is_directory(arguments[1])) {
    std::fprintf(stderr, "usage: display_sim_svol_corpus FOLDER\n");
    return 2;
  }
  const std::filesystem::path folder = arguments[1];
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() == ".svol") {
      std::filesystem::remove(entry.path());
    }
  }
  for (const ocelli::test::SvolCase& file : ocelli::test::svolCases()) {
    std::ofstream(folder / (file.name + ".svol"), std::ios::binary)
        .write(reinterpret_cast<const char*>(file.bytes.data()), static_cast<std::streamsize>(file.bytes.size()));
  }
  return 0;
}
