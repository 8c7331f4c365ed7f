#include "oc_core/feeds_page/page_frames.h"

#include "oc_core/image_codecs/image_codec.h"

namespace ocelli {
namespace {

constexpr double kQuality = 85;

const ColorCodec& codec() {
  const ColorCodec* const jpeg = findColorCodec("jpeg_baseline");
  return jpeg != nullptr ? *jpeg : *findColorCodec("png");
}

}  // namespace

const char* PageFrames::mediaType() {
  return codec().mediaType;
}

void PageFrames::set(const Image<Rgb8>& image, const std::vector<PageFeed>& feeds) {
  const std::lock_guard lock(mutex_);
  image_ = image;
  feeds_ = feeds;
  ++number_;
  changed_.notify_all();
}

std::shared_ptr<const std::string> PageFrames::next(uint64_t& seen) {
  {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return isStopped_ || number_ != seen; });
    if (isStopped_) {
      return nullptr;
    }
  }
  const std::lock_guard encoding(encoding_);
  Image<Rgb8> image;
  {
    const std::lock_guard lock(mutex_);
    seen = number_;
    if (fileNumber_ == number_) {
      return file_;
    }
    image = image_;
  }
  const std::vector<std::byte> bytes = codec().encode(image, kQuality);
  file_ = std::make_shared<const std::string>(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  fileNumber_ = seen;
  return file_;
}

std::vector<PageFeed> PageFrames::feeds() const {
  const std::lock_guard lock(mutex_);
  return feeds_;
}

void PageFrames::stop() {
  const std::lock_guard lock(mutex_);
  isStopped_ = true;
  changed_.notify_all();
}

}  // namespace ocelli
