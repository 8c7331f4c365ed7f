#include "display_sim/export_png.h"

#include <algorithm>
#include <cstdio>
#include <string>
#include <system_error>

#include "oc_core/base/error.h"
#include "oc_core/base/parallel.h"

namespace ocelli {

void exportPngStack(const std::filesystem::path& folder, const Volume& volume, const Progress& progress) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error || !std::filesystem::is_directory(folder)) {
    throw WorkError("cannot make this folder (" + error.message() + ")", folder.string(),
                    "give the path of a folder, in a place that is writable");
  }
  const auto count = static_cast<size_t>(volume.slices());
  // In batches, so that progress is reported from one thread.
  constexpr size_t kBatch = 32;
  for (size_t first = 0; first < count; first += kBatch) {
    report(progress, "writing slices", static_cast<double>(first) / static_cast<double>(count));
    parallelFor(std::min(kBatch, count - first), 1, [&](size_t begin, size_t end) {
      for (size_t i = first + begin; i < first + end; ++i) {
        char name[32];
        std::snprintf(name, sizeof name, "slice_%04d.png", static_cast<int>(i));
        writePng(folder / name, sliceImage(volume, static_cast<int>(i)));
      }
    });
  }
  report(progress, "writing slices", 1);
}

}  // namespace ocelli
