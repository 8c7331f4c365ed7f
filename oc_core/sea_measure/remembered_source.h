// Images of a source that are asked for again and again, such as those that a search for an equal error compares with.
#pragma once

#include <map>
#include <mutex>

#include "oc_core/sea/sea_source.h"

namespace ocelli {

/// The same images; the first ones that are asked for are made once, as many as `kMaxRememberedBytes` hold.
class RememberedSource final : public SeaSource {
 public:
  static constexpr size_t kMaxRememberedBytes = size_t{512} << 20;

  explicit RememberedSource(const SeaSource& source) : source_(source) {}

  std::string description() const override { return source_.description(); }
  const SeaProjection& projection() const override { return source_.projection(); }
  const std::vector<SeaPose>& poses() const override { return source_.poses(); }
  const std::vector<std::string>& names() const override { return source_.names(); }
  Image<Rgb8> image(uint32_t index) const override;

 private:
  const SeaSource& source_;
  mutable std::mutex mutex_;
  mutable std::map<uint32_t, Image<Rgb8>> images_;
  mutable size_t bytes_ = 0;
};

}  // namespace ocelli
