// Writes the seed corpus of the log fuzzer anew: device_log_corpus tests/display_driver_pacing/corpus
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "tests/display_driver_pacing/device_log_cases.h"

int main(int argumentCount, char** arguments) {
  if (argumentCount != 2) {
    return 2;
  }
  const std::filesystem::path folder = arguments[1];
  const std::filesystem::path whole = folder / "whole.session";
  ocelli::test::writeDeviceLog(whole);
  std::ifstream in(whole, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(in), {}};
  for (const double share : {0.2, 0.5, 0.9}) {
    const std::string name = "cut_" + std::to_string(static_cast<int>(100 * share)) + ".session";
    std::ofstream out(folder / name, std::ios::binary);
    out.write(bytes.data(), static_cast<std::streamsize>(share * static_cast<double>(bytes.size())));
  }
}
