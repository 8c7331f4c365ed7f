#include "display_sim/exports/export_png.h"

#include <algorithm>

#include "display_sim/observing/image_folder.h"
#include "oc_core/base/parallel.h"

namespace ocelli {

void exportPngStack(const std::filesystem::path& folder, const Volume& volume, const Progress& progress) {
  ImageFolder images(folder, "slice");
  const auto count = static_cast<size_t>(volume.slices());
  // In batches, so that progress is reported from one thread.
  constexpr size_t kBatch = 32;
  for (size_t first = 0; first < count; first += kBatch) {
    report(progress, "writing slices", static_cast<double>(first) / static_cast<double>(count));
    parallelFor(std::min(kBatch, count - first), 1, [&](size_t begin, size_t end) {
      for (size_t i = first + begin; i < first + end; ++i) {
        writePng(images.path(static_cast<int>(i)), sliceImage(volume, static_cast<int>(i)));
      }
    });
  }
  images.finish();
  report(progress, "writing slices", 1);
}

}  // namespace ocelli
