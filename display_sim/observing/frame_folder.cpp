#include "display_sim/observing/frame_sink.h"
#include "display_sim/observing/image_folder.h"

namespace ocelli {
namespace {

class FrameFolder : public FrameSink {
 public:
  explicit FrameFolder(const std::filesystem::path& folder) : folder_(folder, "frame") {}

  void add(const Image<Rgb8>& frame) override { writePng(folder_.path(count_++), frame); }
  void finish() override { folder_.finish(); }

 private:
  ImageFolder folder_;
  int count_ = 0;
};

}  // namespace

std::unique_ptr<FrameSink> frameFolder(const std::filesystem::path& folder) {
  return std::make_unique<FrameFolder>(folder);
}

}  // namespace ocelli
