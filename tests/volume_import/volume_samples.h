// Volumes that other programs wrote: samples/make_samples.py.
#pragma once

#include <filesystem>
#include <string_view>

namespace ocelli::test {

inline std::filesystem::path volumeSample(std::string_view name) {
  return std::filesystem::path(VOLUME_SAMPLES) / name;
}

}  // namespace ocelli::test
