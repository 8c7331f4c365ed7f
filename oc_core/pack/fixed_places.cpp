#include "oc_core/pack/fixed_places.h"

#include <fcntl.h>

#include <algorithm>

#include "oc_core/base/error.h"

namespace ocelli {
namespace {

constexpr size_t kBlockPlaces = 256;

}  // namespace

void sortPlaces(std::vector<FixedPlace>& fixed) {
  std::sort(fixed.begin(), fixed.end());
  fixed.erase(std::unique(fixed.begin(), fixed.end()), fixed.end());
}

PlaceSet placesOf(const std::vector<FixedPlace>& fixed) {
  std::vector<PlaceBits> places;
  places.reserve(fixed.size());
  for (const FixedPlace& each : fixed) {
    places.push_back(each.place);
  }
  return PlaceSet(std::move(places));
}

std::vector<FixedPlace> fixedAbove(const ScenePlan& plan, uint32_t part, std::vector<FixedPlace> ofChildren) {
  // All that stands below a part stands before it in the plan, without others in between.
  uint32_t first = part;
  while (!plan.parts[first].children.empty()) {
    first = plan.parts[first].children.front();
  }
  std::erase_if(ofChildren, [&](const FixedPlace& each) { return first <= each.part && each.part <= part; });
  sortPlaces(ofChildren);
  return ofChildren;
}

FixedPlaceWriter::FixedPlaceWriter(const std::filesystem::path& path, size_t parts)
    : file_(path, O_WRONLY | O_CREAT | O_TRUNC), buffers_(parts) {}

void FixedPlaceWriter::add(uint32_t part, const FixedPlace& place) {
  // A vertex comes with several triangles that follow each other.
  std::vector<FixedPlace>& buffer = buffers_[part];
  if (std::find(buffer.rbegin(), buffer.rbegin() + static_cast<std::ptrdiff_t>(std::min<size_t>(buffer.size(), 8)),
                place) != buffer.rbegin() + static_cast<std::ptrdiff_t>(std::min<size_t>(buffer.size(), 8))) {
    return;
  }
  buffer.push_back(place);
  if (buffer.size() == kBlockPlaces) {
    flush(part);
  }
}

void FixedPlaceWriter::flush(uint32_t part) {
  std::vector<FixedPlace>& buffer = buffers_[part];
  if (!buffer.empty()) {
    file_.write(buffer.data(), buffer.size() * sizeof(FixedPlace), end_);
    blocks_.push_back({end_, part, static_cast<uint32_t>(buffer.size())});
    end_ += buffer.size() * sizeof(FixedPlace);
    buffer.clear();
  }
}

void FixedPlaceWriter::finish() {
  for (uint32_t part = 0; part < buffers_.size(); ++part) {
    flush(part);
  }
  const uint64_t blocks = blocks_.size();
  file_.write(blocks_.data(), blocks * sizeof(Block), end_);
  file_.write(&blocks, sizeof(blocks), end_ + blocks * sizeof(Block));
}

std::vector<FixedPlace> readFixedPlaces(const std::filesystem::path& path, uint32_t part) {
  const PlacedFile file(path, O_RDONLY);
  const uint64_t size = file.size();
  uint64_t blockCount = 0;
  if (size >= sizeof(blockCount)) {
    file.read(&blockCount, sizeof(blockCount), size - sizeof(blockCount));
  }
  if (size < sizeof(blockCount) || blockCount > (size - sizeof(blockCount)) / sizeof(FixedPlaceWriter::Block)) {
    throw WorkError("what was made of the parts of the scene is damaged", path.string(),
                    "remove its folder, and pack the scene again");
  }
  std::vector<FixedPlaceWriter::Block> blocks(blockCount);
  file.read(blocks.data(), blocks.size() * sizeof(FixedPlaceWriter::Block),
            size - sizeof(blockCount) - blocks.size() * sizeof(FixedPlaceWriter::Block));
  std::vector<FixedPlace> places;
  for (const FixedPlaceWriter::Block& block : blocks) {
    if (block.part == part) {
      places.resize(places.size() + block.count);
      file.read(&places[places.size() - block.count], block.count * sizeof(FixedPlace), block.at);
    }
  }
  return places;
}

}  // namespace ocelli
