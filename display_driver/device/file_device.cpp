#include "display_driver/device/file_device.h"

#include <optional>

#include "display_driver/device/ideal_device.h"
#include "display_sim/frames/svol_writer.h"
#include "oc_core/base/error.h"

namespace ocelli {
namespace {

class SvolRecording final : public ShownFrames {
 public:
  SvolRecording(const std::filesystem::path& path, const DisplayProfile& profile)
      : writer_(path, profile, {.growing = true}) {}

  void shown(const Volume& volume, HostTime time) override {
    if (!start_) {
      start_ = time;
    }
    const auto since = std::chrono::duration_cast<std::chrono::microseconds>(time - *start_);
    writer_.append(volume, static_cast<uint64_t>(since.count()));
  }
  void finish() override { writer_.finish(); }

 private:
  SvolWriter writer_;
  std::optional<HostTime> start_;
};

}  // namespace

std::unique_ptr<Device> openFileDevice(const std::filesystem::path& path, const DisplayProfile& profile) {
  if (path.extension() != ".svol" && !path.string().starts_with("/dev/")) {
    throw InputError("the device \"file\" writes a .svol file", path.string(), "give a name that ends in .svol");
  }
  const DeviceInfo info{.kind = "file", .name = path.string(), .serial = "", .link = "a file"};
  return std::make_unique<IdealDevice>(info, profile, std::make_unique<SvolRecording>(path, profile));
}

}  // namespace ocelli
