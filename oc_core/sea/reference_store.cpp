#include "oc_core/sea/reference_store.h"

#include <algorithm>

#include "oc_core/base/parallel.h"
#include "oc_core/sea/residual.h"

namespace ocelli {
namespace {

constexpr size_t kMaxKept = 48;  ///< 4 MB each for a million pixels

}  // namespace

void ReferenceStore::prepare(const std::vector<uint32_t>& images) {
  ++uses_;
  std::vector<uint32_t> missing;
  for (const uint32_t image : images) {
    const auto found = kept_.find(image);
    if (found != kept_.end()) {
      found->second.lastUse = uses_;
    } else if (std::find(missing.begin(), missing.end(), image) == missing.end()) {
      missing.push_back(image);
    }
  }
  std::vector<std::shared_ptr<const WarpReference>> made(missing.size());
  parallelFor(missing.size(), 1, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      made[i] = decoded(missing[i]);
    }
  });
  for (size_t i = 0; i < missing.size(); ++i) {
    kept_[missing[i]] = {made[i], uses_};
  }
  while (kept_.size() > kMaxKept) {
    const auto oldest = std::min_element(
        kept_.begin(), kept_.end(), [](const auto& a, const auto& b) { return a.second.lastUse < b.second.lastUse; });
    if (oldest->second.lastUse == uses_) {
      break;
    }
    kept_.erase(oldest);
  }
}

std::shared_ptr<const WarpReference> ReferenceStore::decoded(uint32_t image) const {
  std::vector<uint32_t> chain;
  std::shared_ptr<const WarpReference> reference;
  for (uint32_t at = image;;) {
    const auto found = kept_.find(at);
    if (found != kept_.end()) {
      reference = found->second.reference;
      break;
    }
    chain.push_back(at);
    at = writer_.read(at).prefix.reference;
    if (at == sea::kNoReference) {
      break;
    }
  }
  const SeaProjection& projection = decoder_.settings().projection;
  for (size_t i = chain.size(); i-- > 0;) {
    const SeaWriter::StoredImage stored = writer_.read(chain[i]);
    if (stored.prefix.reference == sea::kNoReference) {
      reference = std::make_shared<const WarpReference>(decoder_.innerReference(stored.coded, stored.hidden));
      continue;
    }
    const auto vector = [](const std::array<float, 3>& values) { return glm::dvec3(values[0], values[1], values[2]); };
    const SeaPose target = movedBy(poses_[chain[i]], vector(stored.prefix.translation), vector(stored.prefix.rotation));
    Image<Rgb8> whole = decoder_.predicted(*reference, poses_[stored.prefix.reference], target);
    addResidual(whole, decoder_.residual(stored.coded));
    reference = std::make_shared<const WarpReference>(whole, projection);
  }
  return reference;
}

}  // namespace ocelli
