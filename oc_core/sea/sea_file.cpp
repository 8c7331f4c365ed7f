#include "oc_core/sea/sea_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <optional>

#include "oc_core/base/check.h"
#include "oc_core/base/error.h"
#include "oc_core/sea/proxy_bytes.h"
#include "oc_core/sea/residual.h"
#include "oc_core/sea/sea_between.h"

namespace ocelli {
namespace {

using sea::RecordHeader;
using sea::RecordKind;

template <class Value>
Value valueAt(std::span<const uint8_t> bytes, uint64_t at) {
  Value value;
  std::memcpy(&value, bytes.data() + at, sizeof(value));
  return value;
}

bool isPose(const SeaPose& pose) {
  const glm::dvec3& p = pose.position;
  const double length = glm::length(pose.worldFromCamera);
  constexpr double kMost = 1e15;
  return std::abs(p.x) < kMost && std::abs(p.y) < kMost && std::abs(p.z) < kMost && std::abs(length - 1) < 1e-6;
}

}  // namespace

SeaFile::SeaFile(const std::filesystem::path& path) : path_(path), file_(path) {
  const std::span<const uint8_t> bytes = file_.bytes();
  if (bytes.size() < sizeof(header_) || !std::equal(sea::kMagic.begin(), sea::kMagic.end(), bytes.begin())) {
    throw InputError("this is no sea of images", path_.string(), "make one with `ocelli sea build`");
  }
  header_ = valueAt<sea::Header>(bytes, 0);
  if (header_.check != sea::checkOf(header_)) {
    refuse("its header");
  }
  if (header_.version != sea::kVersion) {
    throw InputError(
        fmt::format("this sea is of version {}; this program reads version {}", header_.version, sea::kVersion),
        path_.string(), "use a newer program");
  }
  if (header_.isComplete == 0) {
    throw InputError("this sea is not complete", path_.string(), "run the command that builds it again: it goes on");
  }
  if (header_.fileBytes != bytes.size() || header_.images == 0 || header_.images > sea::kMaxImages) {
    refuse(fmt::format("it has {} bytes, and should have {}", bytes.size(), header_.fileBytes));
  }
  const auto fits = [&](uint64_t offset, size_t entryBytes) {
    return offset >= sizeof(header_) + sizeof(RecordHeader) && offset <= bytes.size() &&
           header_.images <= (bytes.size() - offset) / entryBytes;
  };
  if (!fits(header_.posesOffset, sizeof(sea::PoseEntry)) || !fits(header_.indexOffset, sizeof(sea::IndexEntry))) {
    refuse("its index lies outside of it");
  }
  const Record settings = expect(sizeof(header_), RecordKind::kSettings);
  const std::string text(reinterpret_cast<const char*>(settings.payload.data()), settings.payload.size());
  const SeaSettings read = seaSettingsFromJson(text, path_.string());
  namesAt_ = endOf(settings);
  // Names and poses are read when they are asked for: only their headers are here.
  const auto skipped = [&](uint64_t at, RecordKind kind) {
    if (at + sizeof(RecordHeader) > bytes.size()) {
      refuse("it ends too early");
    }
    const auto header = valueAt<RecordHeader>(bytes, at);
    if (header.check != sea::checkOf(header) || header.kind != kind ||
        header.payloadBytes > bytes.size() - at - sizeof(header)) {
      refuse(fmt::format("the record at byte {}", at));
    }
    return at + sizeof(header) + sea::paddedBytes(header.payloadBytes);
  };
  const uint64_t posesAt = skipped(namesAt_, RecordKind::kNames);
  if (posesAt + sizeof(RecordHeader) != header_.posesOffset) {
    refuse("its poses are not where it says");
  }
  const Record proxy = expect(skipped(posesAt, RecordKind::kPoses), RecordKind::kProxy);
  imagesAt_ = endOf(proxy);
  proxy_ = std::make_unique<SeaProxy>(proxyFromBytes(proxy.payload, path_.string()));
  decoder_ = std::make_unique<SeaDecoder>(read, *proxy_);
  openBytes_ = sizeof(header_) + settings.payload.size() + proxy.payload.size() + 4 * sizeof(RecordHeader);
}

SeaFile::~SeaFile() = default;

void SeaFile::refuse(const std::string& what) const {
  throw InputError("this sea is damaged: " + what, path_.string(),
                   "take another copy; `ocelli sea verify` tells what else is");
}

uint64_t SeaFile::endOf(const Record& record) {
  return record.at + sea::paddedBytes(record.payload.size());
}

SeaFile::Record SeaFile::record(uint64_t at) const {
  const std::span<const uint8_t> bytes = file_.bytes();
  if (at > bytes.size() || bytes.size() - at < sizeof(RecordHeader)) {
    refuse("it ends too early");
  }
  Record record;
  record.header = valueAt<RecordHeader>(bytes, at);
  record.at = at + sizeof(RecordHeader);
  if (record.header.mark != RecordHeader{}.mark || record.header.check != sea::checkOf(record.header) ||
      record.header.payloadBytes > sea::kMaxPayload ||
      sea::paddedBytes(record.header.payloadBytes) > bytes.size() - record.at) {
    refuse(fmt::format("the record at byte {}", at));
  }
  record.payload = bytes.subspan(record.at, record.header.payloadBytes);
  if (crc32c(record.payload) != record.header.payloadCheck) {
    refuse(fmt::format("what the record at byte {} holds", at));
  }
  return record;
}

SeaFile::Record SeaFile::expect(uint64_t at, RecordKind kind) const {
  const Record found = record(at);
  if (found.header.kind != kind) {
    refuse(fmt::format("the record at byte {} is of another kind", at));
  }
  return found;
}

SeaPose SeaFile::pose(uint32_t image) const {
  OC_CHECK(image < count(), "an image of this sea");
  const auto entry =
      valueAt<sea::PoseEntry>(file_.bytes(), header_.posesOffset + uint64_t{image} * sizeof(sea::PoseEntry));
  const SeaPose pose = sea::poseOf(entry);
  if (entry.check != sea::checkOf(entry) || !isPose(pose)) {
    refuse(fmt::format("the pose of image {}", image));
  }
  return pose;
}

sea::IndexEntry SeaFile::entry(uint32_t image) const {
  OC_CHECK(image < count(), "an image of this sea");
  const std::span<const uint8_t> bytes = file_.bytes();
  const auto at = [&](uint32_t number) {
    return valueAt<sea::IndexEntry>(bytes, header_.indexOffset + uint64_t{number} * sizeof(sea::IndexEntry));
  };
  const sea::IndexEntry found = at(image);
  const bool isWhole = found.check == sea::checkOf(found) && found.payloadBytes > sizeof(sea::ImagePrefix) &&
                       found.offset <= bytes.size() && found.payloadBytes <= bytes.size() - found.offset;
  // A chain of references gets shorter by one each time: it ends.
  const bool isInner = found.reference == sea::kNoReference;
  const bool hasRoom = found.hiddenBytes == 0 ||
                       (isInner && found.offset >= imagesAt_ + 2 * sizeof(RecordHeader) &&
                        sea::paddedBytes(found.hiddenBytes) <= found.offset - imagesAt_ - 2 * sizeof(RecordHeader));
  if (!isWhole || !hasRoom || isInner != (found.additions == 0) ||
      (!isInner && (found.reference >= count() || at(found.reference).additions + 1 != found.additions))) {
    refuse(fmt::format("the index of image {}", image));
  }
  return found;
}

SeaFile::Payload SeaFile::payload(uint32_t image, const sea::IndexEntry& entry) const {
  const auto all = file_.bytes().subspan(entry.offset, entry.payloadBytes);
  const auto prefix = valueAt<sea::ImagePrefix>(all, 0);
  const auto isFine = [](const std::array<float, 3>& values) {
    return std::all_of(values.begin(), values.end(), [](float x) { return std::abs(x) < 1e15f; });
  };
  if (crc32c(all) != entry.payloadCheck || prefix.reference != entry.reference || !isFine(prefix.translation) ||
      !isFine(prefix.rotation)) {
    refuse(fmt::format("image {}", image));
  }
  return {prefix, all.subspan(sizeof(prefix))};
}

std::span<const uint8_t> SeaFile::hidden(uint32_t image, const sea::IndexEntry& entry) const {
  if (entry.hiddenBytes == 0) {
    return {};
  }
  // Its record ends where the image's begins.
  const uint64_t at = sea::hiddenOffset(entry.offset, entry.hiddenBytes) - sizeof(RecordHeader);
  const Record found = expect(at, RecordKind::kHidden);
  if (found.header.number != image || found.payload.size() != entry.hiddenBytes) {
    refuse(fmt::format("the hidden samples of image {}", image));
  }
  return found.payload;
}

WarpReference SeaFile::innerReference(uint32_t image) const {
  const sea::IndexEntry found = entry(image);
  return decoder_->innerReference(payload(image, found).coded, hidden(image, found));
}

SeaFile::Stored SeaFile::stored(uint32_t image) const {
  const sea::IndexEntry found = entry(image);
  const auto [prefix, coded] = payload(image, found);
  const auto vector = [](const std::array<float, 3>& values) { return glm::dvec3(values[0], values[1], values[2]); };
  return {found.reference, found.additions,
          coded.size(),    found.hiddenBytes,
          prefix.quality,  movedBy(pose(image), vector(prefix.translation), vector(prefix.rotation))};
}

std::vector<std::string> SeaFile::names() const {
  const Record found = expect(namesAt_, RecordKind::kNames);
  std::vector<std::string> names;
  const char* at = reinterpret_cast<const char*>(found.payload.data());
  const char* end = at + found.payload.size();
  while (at < end) {
    const char* stop = std::find(at, end, '\n');
    names.emplace_back(at, stop);
    at = stop < end ? stop + 1 : end;
  }
  if (!names.empty() && names.size() != count()) {
    refuse("the names of its images");
  }
  return names;
}

Image<Rgb8> SeaFile::withResidual(const WarpReference& reference, uint32_t image, const sea::IndexEntry& entry) const {
  const Payload held = payload(image, entry);
  Image<Rgb8> result = decoder_->predicted(reference, pose(entry.reference), stored(image).refinedPose);
  addResidual(result, decoder_->residual(held.coded));
  return result;
}

Image<Rgb8> SeaFile::image(uint32_t image) const {
  // From the I-node down.
  std::vector<uint32_t> chain{image};
  for (sea::IndexEntry at = entry(image); at.reference != sea::kNoReference; at = entry(at.reference)) {
    chain.push_back(at.reference);
  }
  const uint32_t inner = chain.back();
  if (inner == image) {
    return decoder_->inner(payload(inner, entry(inner)).coded);
  }
  WarpReference reference = innerReference(inner);
  for (size_t i = chain.size() - 1; i-- > 1;) {
    reference = {withResidual(reference, chain[i], entry(chain[i])), settings().projection};
  }
  return withResidual(reference, image, entry(image));
}

WarpReference SeaFile::reference(uint32_t image) const {
  const sea::IndexEntry found = entry(image);
  OC_CHECK(found.reference != sea::kNoReference, "an I-node hangs on nothing");
  if (entry(found.reference).reference == sea::kNoReference) {
    return innerReference(found.reference);
  }
  return {this->image(found.reference), settings().projection};
}

Image<Rgb8> SeaFile::imageFrom(const WarpReference& reference, uint32_t image) const {
  const sea::IndexEntry found = entry(image);
  OC_CHECK(found.reference != sea::kNoReference, "an I-node hangs on nothing");
  return withResidual(reference, image, found);
}

std::vector<glm::dvec3> SeaFile::positions() const {
  std::vector<glm::dvec3> positions;
  positions.reserve(count());
  for (uint32_t i = 0; i < count(); ++i) {
    positions.push_back(pose(i).position);
  }
  return positions;
}

Image<Rgb8> SeaFile::view(const SeaPose& pose) const {
  const std::vector<SeaNeighbor> neighbors = nearestNeighbors(positions(), pose.position);
  std::vector<WarpReference> references;
  references.reserve(neighbors.size());
  std::vector<BlendedImage> blended;
  for (const SeaNeighbor& neighbor : neighbors) {
    references.emplace_back(image(neighbor.image), settings().projection);
    blended.push_back({&references.back(), this->pose(neighbor.image), neighbor.weight});
  }
  return blendedView(*decoder_, blended, {settings().projection, pose});
}

uint64_t SeaFile::bytesToRead(uint32_t image) const {
  uint64_t bytes = 0;
  for (uint32_t at = image; at != sea::kNoReference; at = entry(at).reference) {
    bytes += entry(at).payloadBytes + sizeof(sea::IndexEntry) + sizeof(sea::PoseEntry);
    bytes += at != image ? entry(at).hiddenBytes : 0;
  }
  return bytes;
}

std::vector<SeaFile::ImagePlace> SeaFile::checkedPlaces(const Progress& progress) const {
  const std::span<const uint8_t> bytes = file_.bytes();
  std::vector<ImagePlace> places(count());
  std::optional<RecordHeader> hidden;
  uint64_t at = sizeof(header_);
  uint64_t lastPayload = 0;
  while (at < bytes.size()) {
    const Record found = record(at);
    const auto padding = bytes.subspan(found.at + found.payload.size(), endOf(found) - found.at - found.payload.size());
    if (found.header.reserved != 0 || !std::all_of(padding.begin(), padding.end(), [](uint8_t b) { return b == 0; })) {
      refuse(fmt::format("what lies behind the record at byte {}", at));
    }
    if (hidden && (found.header.kind != RecordKind::kImage || found.header.number != hidden->number)) {
      refuse(fmt::format("the hidden samples before byte {} are of another image", at));
    }
    if (found.header.kind == RecordKind::kImage) {
      if (found.header.number >= count() || places[found.header.number].offset != 0) {
        refuse(fmt::format("the record at byte {} is of no image, or of one that stands elsewhere", at));
      }
      places[found.header.number] = {found.at, hidden ? hidden->payloadBytes : 0};
    }
    hidden = found.header.kind == RecordKind::kHidden ? std::optional(found.header) : std::nullopt;
    lastPayload = found.at;
    at = endOf(found);
    report(progress, "checking", 0.5 * static_cast<double>(at) / static_cast<double>(bytes.size()));
  }
  if (lastPayload != header_.indexOffset) {
    refuse("its index is not where it says");
  }
  return places;
}

void SeaFile::verify(bool decode, const Progress& progress) const {
  const std::vector<ImagePlace> places = checkedPlaces(progress);
  names();
  for (uint32_t i = 0; i < count(); ++i) {
    pose(i);
    const sea::IndexEntry found = entry(i);
    if (found.offset != places[i].offset || found.hiddenBytes != places[i].hiddenBytes) {
      refuse(fmt::format("the index of image {}", i));
    }
    stored(i);
    if (decode) {
      try {
        image(i);
        if (found.hiddenBytes > 0) {
          innerReference(i);
        }
      } catch (const InputError& error) {
        refuse(fmt::format("image {}: {}", i, error.parts().problem));
      }
    }
    report(progress, decode ? "decoding" : "checking", 0.5 + 0.5 * (i + 1) / count());
  }
}

}  // namespace ocelli
