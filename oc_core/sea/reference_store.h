// The images that others hang on while a sea is built: decoded as they will be when it is read, and a few kept.
#pragma once

#include <cstdint>
#include <list>
#include <map>
#include <memory>
#include <vector>

#include "oc_core/sea/sea_decoder.h"
#include "oc_core/sea/sea_writer.h"

namespace ocelli {

class ReferenceStore {
 public:
  /// All must outlive it.
  ReferenceStore(const SeaWriter& writer, const SeaDecoder& decoder, const std::vector<SeaPose>& poses)
      : writer_(writer), decoder_(decoder), poses_(poses) {}

  /// Makes those ready that are not, several at a time; at least these stay until the next call. All are written.
  void prepare(const std::vector<uint32_t>& images);
  /// One that is ready.
  const WarpReference& at(uint32_t image) const { return *kept_.at(image).reference; }

 private:
  struct Kept {
    std::shared_ptr<const WarpReference> reference;
    uint64_t lastUse = 0;
  };

  /// From the nearest image up the chain that is kept.
  std::shared_ptr<const WarpReference> decoded(uint32_t image) const;

  const SeaWriter& writer_;
  const SeaDecoder& decoder_;
  const std::vector<SeaPose>& poses_;
  std::map<uint32_t, Kept> kept_;
  uint64_t uses_ = 0;
};

}  // namespace ocelli
