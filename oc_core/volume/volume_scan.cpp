#include "oc_core/volume/volume_scan.h"

#include <algorithm>

#include "oc_core/base/parallel.h"

namespace ocelli {
namespace {

/// What is read at once of a volume that may not fit into memory.
constexpr size_t kBytesAtOnce = size_t{128} << 20U;
/// Ranges of slices that what is read at once is divided into, about.
constexpr size_t kPartsAtOnce = 32;

}  // namespace

RowsInMemory::RowsInMemory(const ScalarVolume& volume, const IndexRange& slices, const IndexRange& rows,
                           bool readsAhead)
    : store_(volume.store()) {
  if (store_ == nullptr) {
    return;
  }
  const glm::ivec3& size = volume.grid().size;
  const size_t rowBytes = static_cast<size_t>(size.x) * bytesOf(volume.type());
  const auto height = static_cast<size_t>(size.y);
  const size_t lastSlice = std::min(slices.last, static_cast<size_t>(size.z));
  const size_t lastRow = std::min(rows.last, height);
  stride_ = height * rowBytes;
  firstByte_ = slices.first * stride_ + rows.first * rowBytes;
  pieceBytes_ = (lastRow - rows.first) * rowBytes;
  pieces_ = lastSlice - slices.first;
  if (pieceBytes_ == stride_) {
    // Whole slices are one piece: memory is given back by pages, and none is left between them.
    pieceBytes_ *= pieces_;
    pieces_ = 1;
  }
  forEachPiece([&](size_t begin, size_t end) {
    if (readsAhead && !store_->isKnownZero(begin, end)) {
      store_->willRead(begin, end);
    }
  });
}

RowsInMemory::~RowsInMemory() {
  forEachPiece([&](size_t begin, size_t end) { store_->release(begin, end); });
}

void RowsInMemory::forEachPiece(const std::function<void(size_t begin, size_t end)>& visit) const {
  for (size_t piece = 0; piece < pieces_; ++piece) {
    const size_t begin = firstByte_ + piece * stride_;
    visit(begin, begin + pieceBytes_);
  }
}

void scanSlices(const ScalarVolume& volume, size_t first, size_t last,
                const std::function<void(size_t begin, size_t end)>& body) {
  const size_t sliceBytes = volume.voxels().size() / static_cast<size_t>(volume.grid().size.z);
  // All at once, where they are in memory.
  const size_t atOnce = volume.store() == nullptr ? last - first : std::max<size_t>(1, kBytesAtOnce / sliceBytes);
  for (size_t begin = first; begin < last; begin += atOnce) {
    const size_t end = std::min(begin + atOnce, last);
    const RowsInMemory slices(volume, {begin, end});
    // What each call sets up, such as bins, pays for some slices.
    const size_t grain = std::max<size_t>(1, (end - begin) / kPartsAtOnce);
    parallelFor(end - begin, grain, [&](size_t from, size_t to) { body(begin + from, begin + to); });
  }
}

bool areRowsKnownZero(const ScalarVolume& volume, size_t slice, size_t firstRow, size_t lastRow) {
  const size_t rowBytes = static_cast<size_t>(volume.grid().size.x) * bytesOf(volume.type());
  const size_t sliceBytes = static_cast<size_t>(volume.grid().size.y) * rowBytes;
  const size_t begin = slice * sliceBytes;
  return volume.store() != nullptr &&
         volume.store()->isKnownZero(begin + firstRow * rowBytes, begin + lastRow * rowBytes);
}

}  // namespace ocelli
