#include "display_driver/device/file_device.h"

#include <optional>

#include "display_driver/device/ideal_device.h"
#include "display_sim/frames/svol_writer.h"
#include "oc_core/base/error.h"
#include "oc_core/base/output_file.h"

namespace ocelli {
namespace {

bool isSystemFile(const std::filesystem::path& path) {
  return path.string().starts_with("/dev/");
}

/// The file is made with the first volume, so that a recording which never begins leaves what was there.
class SvolRecording final : public ShownFrames {
 public:
  SvolRecording(const std::filesystem::path& path, const DisplayProfile& profile) : path_(path), profile_(profile) {
    if (isSystemFile(path)) {
      writer_.emplace(path_, profile_, SvolOptions{.growing = true});
    } else {
      checkWritable(path);
    }
  }

  void shown(const Volume& volume, HostTime time) override {
    if (!writer_) {
      writer_.emplace(path_, profile_, SvolOptions{.growing = true});
    }
    if (!start_) {
      start_ = time;
    }
    const auto since = std::chrono::duration_cast<std::chrono::microseconds>(time - *start_);
    writer_->append(volume, static_cast<uint64_t>(since.count()));
  }
  void finish() override {
    if (writer_) {
      writer_->finish();
    }
  }

 private:
  const std::filesystem::path path_;
  const DisplayProfile profile_;
  std::optional<SvolWriter> writer_;
  std::optional<HostTime> start_;
};

}  // namespace

std::unique_ptr<Device> openFileDevice(const std::filesystem::path& path, const DisplayProfile& profile) {
  if (path.extension() != ".svol" && !isSystemFile(path)) {
    throw InputError("the device \"file\" writes a .svol file", path.string(), "give a name that ends in .svol");
  }
  const DeviceInfo info{.kind = "file", .name = path.string(), .serial = "", .link = "a file"};
  return std::make_unique<IdealDevice>(info, profile, std::make_unique<SvolRecording>(path, profile));
}

}  // namespace ocelli
