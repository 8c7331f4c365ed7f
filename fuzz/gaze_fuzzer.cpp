// libFuzzer target: any bytes as lines of an eye tracker. What is read is finite and on a screen, and the same in
// pieces of whole lines as at once.
#include <cmath>
#include <cstdlib>
#include <string_view>

#include "study/gaze/gaze_lines.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  for (const ocelli::GazeUnit unit : {ocelli::GazeUnit::kPixels, ocelli::GazeUnit::kShares}) {
    ocelli::GazeLines lines(unit, 1920, 1200);
    const std::vector<ocelli::GazeRecord> samples = lines.read(text, 1);
    for (const ocelli::GazeRecord& sample : samples) {
      if (!std::isfinite(sample.deviceTime) || !(std::abs(sample.x) <= 1e6) || !(std::abs(sample.y) <= 1e6) ||
          !std::isfinite(sample.pupil.value_or(0))) {
        std::abort();
      }
    }
    ocelli::GazeLines pieces(unit, 1920, 1200);
    std::vector<ocelli::GazeRecord> again;
    for (std::string_view rest = text; !rest.empty();) {
      const size_t end = rest.find('\n');
      const std::string_view line = rest.substr(0, end == std::string_view::npos ? end : end + 1);
      rest.remove_prefix(line.size());
      for (const ocelli::GazeRecord& sample : pieces.read(line, 1)) {
        again.push_back(sample);
      }
    }
    if (again != samples || pieces.malformed() != lines.malformed()) {
      std::abort();
    }
  }
  return 0;
}
