#include "text_device.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <string>
#include <string_view>
#include <vector>

#include "display_driver/device/ideal_device.h"
#include "display_sim/frames/sweep_geometry.h"
#include "oc_core/base/error.h"

using namespace ocelli;

namespace {

/// The voxels that lie behind each letter, added up. A display hides nothing: what is behind shines through.
std::vector<std::string> lettersOf(const Volume& volume, int columns) {
  constexpr std::string_view kFromDarkToBright = " .:-=+*#%@";
  const int rows = columns / 2;  // letters are twice as high as wide
  const SweepGeometry geometry(volume.profile());
  std::vector<size_t> light(size_t(columns) * size_t(rows));
  for (int slice = 0; slice < volume.slices(); ++slice) {
    forEachLitVoxel(volume, slice, [&](int column, int row) {
      const glm::dvec3 place = geometry.voxelCenter(slice, column, row);
      const int x = std::clamp(int((place.x + 1) / 2 * columns), 0, columns - 1);
      const int y = std::clamp(int((1 - place.y) / 2 * rows), 0, rows - 1);
      ++light[size_t(y) * size_t(columns) + size_t(x)];
    });
  }
  const double most = std::max(1.0, double(*std::max_element(light.begin(), light.end())));
  std::vector<std::string> lines(size_t(rows), std::string(size_t(columns), ' '));
  for (size_t i = 0; i < light.size(); ++i) {
    // The square root shows dim parts too, and what has any light is no blank.
    const double level = std::ceil(std::sqrt(double(light[i]) / most) * double(kFromDarkToBright.size() - 1));
    lines[i / size_t(columns)][i % size_t(columns)] = kFromDarkToBright[size_t(level)];
  }
  return lines;
}

/// What gets each volume as it is shown. IdealDevice does the rest of a device: fences, the rotation, telemetry. A
/// device with hardware of its own implements Device (display_driver/device/device.h) instead.
class Printer final : public ShownFrames {
 public:
  explicit Printer(int columns) : columns_(columns) {}

  void shown(const Volume& volume, HostTime) override {
    for (const std::string& line : lettersOf(volume, columns_)) {
      std::printf("%s\n", line.c_str());
    }
  }
  void finish() override { std::fflush(stdout); }

 private:
  const int columns_;
};

std::unique_ptr<Device> openTextDevice(const std::string& rest, const DeviceOptions& options) {
  int columns = 72;
  const char* end = rest.data() + rest.size();
  const auto [stopped, error] = std::from_chars(rest.data(), end, columns);
  if (!rest.empty() && (error != std::errc() || stopped != end || columns < 8 || columns > 400)) {
    throw InputError("the device \"text\" has 8 to 400 columns", rest, "text:72");
  }
  return std::make_unique<IdealDevice>(
      DeviceInfo{.kind = "text", .name = "letters", .serial = "", .link = "the standard output"},
      options.profile ? *options.profile : loadProfile("perspecta"), std::make_unique<Printer>(columns));
}

}  // namespace

DeviceKind textDevice() {
  return {.name = "text",
          .rest = DeviceKind::Rest::kOptional,
          .restName = "COLUMNS",
          .help = "prints each volume as letters, as it looks from the front",
          .open = openTextDevice};
}
