#include "oc_core/sea/sea_writer.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <system_error>

#include "oc_core/base/check.h"
#include "oc_core/base/error.h"

namespace ocelli {
namespace {

namespace fs = std::filesystem;
using sea::RecordHeader;
using sea::RecordKind;

std::span<const uint8_t> bytesOfText(const std::string& text) {
  return {reinterpret_cast<const uint8_t*>(text.data()), text.size()};
}

std::vector<uint8_t> poseBytes(const std::vector<SeaPose>& poses) {
  std::vector<uint8_t> bytes;
  bytes.reserve(poses.size() * sizeof(sea::PoseEntry));
  for (const SeaPose& pose : poses) {
    const sea::PoseEntry entry = sea::entryOf(pose);
    const auto part = sea::bytesOf(entry);
    bytes.insert(bytes.end(), part.begin(), part.end());
  }
  return bytes;
}

RecordHeader headerOf(RecordKind kind, uint32_t number, std::span<const uint8_t> first,
                      std::span<const uint8_t> second) {
  RecordHeader header;
  header.kind = kind;
  header.number = number;
  header.payloadBytes = first.size() + second.size();
  header.payloadCheck = crc32c(second, crc32c(first));
  return sea::sealed(header);
}

}  // namespace

SeaWriter::SeaWriter(const fs::path& path, const SeaPreamble& preamble, bool startOver)
    : path_(path), partial_(path.string() + ".partial"), entries_(preamble.poses.size()) {
  OC_CHECK(!preamble.poses.empty() && preamble.poses.size() <= sea::kMaxImages, "a sea has images");
  open(startOver);
  try {
    lock();
    struct stat status {};
    if (::fstat(file_, &status) != 0) {
      fail(errno);
    }
    if (status.st_size == 0) {
      begin(preamble);
    } else {
      resume(preamble);
    }
  } catch (...) {
    ::close(file_);
    throw;
  }
}

SeaWriter::~SeaWriter() {
  ::close(file_);
}

void SeaWriter::fail(int reason) const {
  throw WorkError("cannot write this sea: " + std::generic_category().message(reason), partial_.string(),
                  "free some space, or see who may write there; then run the same command again: it goes on with what "
                  "was built");
}

void SeaWriter::open(bool startOver) {
  const std::error_code failed = [&] {
    std::error_code code;
    if (startOver) {
      fs::remove(partial_, code);
    }
    return code;
  }();
  if (failed) {
    fail(failed.value());
  }
  file_ = ::open(partial_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
  if (file_ < 0) {
    fail(errno);
  }
}

void SeaWriter::lock() const {
  if (::flock(file_, LOCK_EX | LOCK_NB) != 0) {
    throw WorkError("another program is building this sea", partial_.string(), "wait for it, or choose another file");
  }
}

void SeaWriter::write(uint64_t at, std::span<const uint8_t> bytes) const {
  while (!bytes.empty()) {
    const ssize_t count = ::pwrite(file_, bytes.data(), bytes.size(), static_cast<off_t>(at));
    if (count < 0 && errno == EINTR) {
      continue;
    }
    if (count <= 0) {
      fail(count == 0 ? ENOSPC : errno);
    }
    at += static_cast<uint64_t>(count);
    bytes = bytes.subspan(static_cast<size_t>(count));
  }
}

void SeaWriter::read(uint64_t at, std::span<uint8_t> bytes) const {
  while (!bytes.empty()) {
    const ssize_t count = ::pread(file_, bytes.data(), bytes.size(), static_cast<off_t>(at));
    if (count < 0 && errno == EINTR) {
      continue;
    }
    if (count <= 0) {
      throw WorkError("cannot read what was built: " +
                          (count == 0 ? std::string("it ends too early") : std::generic_category().message(errno)),
                      partial_.string(), "remove the file, and build the sea anew");
    }
    at += static_cast<uint64_t>(count);
    bytes = bytes.subspan(static_cast<size_t>(count));
  }
}

uint64_t SeaWriter::append(RecordKind kind, uint32_t number, std::span<const uint8_t> first,
                           std::span<const uint8_t> second) {
  const RecordHeader header = headerOf(kind, number, first, second);
  // In one piece: what is killed in between leaves a record that is not whole, and that is seen.
  std::vector<uint8_t> bytes;
  bytes.reserve(sizeof(header) + sea::paddedBytes(header.payloadBytes));
  for (const auto part : {sea::bytesOf(header), first, second}) {
    bytes.insert(bytes.end(), part.begin(), part.end());
  }
  bytes.resize(sizeof(header) + sea::paddedBytes(header.payloadBytes));
  write(end_, bytes);
  const uint64_t payload = end_ + sizeof(header);
  end_ += bytes.size();
  return payload;
}

void SeaWriter::begin(const SeaPreamble& preamble) {
  write(0, sea::bytesOf(sea::sealed(sea::Header{})));
  end_ = sizeof(sea::Header);
  append(RecordKind::kSettings, 0, bytesOfText(preamble.settings));
  append(RecordKind::kNames, 0, bytesOfText(preamble.names));
  posesOffset_ = append(RecordKind::kPoses, 0, poseBytes(preamble.poses));
  append(RecordKind::kProxy, 0, preamble.proxy);
}

void SeaWriter::resume(const SeaPreamble& preamble) {
  const off_t size = ::lseek(file_, 0, SEEK_END);
  if (size < 0) {
    fail(errno);
  }
  const auto fileBytes = static_cast<uint64_t>(size);
  const auto isSame = [&](std::span<const uint8_t> expected) {
    std::vector<uint8_t> found(expected.size());
    if (end_ + expected.size() > fileBytes) {
      return false;
    }
    read(end_, found);
    end_ += expected.size();
    return std::equal(found.begin(), found.end(), expected.begin());
  };
  const auto isSameRecord = [&](RecordKind kind, std::span<const uint8_t> payload) {
    const std::vector<uint8_t> padding(sea::paddedBytes(payload.size()) - payload.size());
    return isSame(sea::bytesOf(headerOf(kind, 0, payload, {}))) && isSame(payload) && isSame(padding);
  };
  bool isOfThisBuild = isSame(sea::bytesOf(sea::sealed(sea::Header{}))) &&
                       isSameRecord(RecordKind::kSettings, bytesOfText(preamble.settings)) &&
                       isSameRecord(RecordKind::kNames, bytesOfText(preamble.names));
  if (isOfThisBuild) {
    posesOffset_ = end_ + sizeof(RecordHeader);
    isOfThisBuild =
        isSameRecord(RecordKind::kPoses, poseBytes(preamble.poses)) && isSameRecord(RecordKind::kProxy, preamble.proxy);
  }
  if (!isOfThisBuild) {
    throw InputError("what an earlier build has left here is of other images or options", partial_.string(),
                     "give the same options to go on with it, or --start-over to remove it");
  }
  resumeImages(fileBytes);
  if (::ftruncate(file_, static_cast<off_t>(end_)) != 0) {
    fail(errno);
  }
}

std::optional<SeaWriter::WholeRecord> SeaWriter::wholeRecord(uint64_t at, uint64_t fileBytes) const {
  WholeRecord record;
  RecordHeader& header = record.header;
  if (at + sizeof(header) > fileBytes) {
    return std::nullopt;
  }
  read(at, {reinterpret_cast<uint8_t*>(&header), sizeof(header)});
  if (header.check != sea::checkOf(header) || header.payloadBytes > sea::kMaxPayload ||
      at + sizeof(header) + sea::paddedBytes(header.payloadBytes) > fileBytes) {
    return std::nullopt;
  }
  record.payload.resize(header.payloadBytes);
  read(at + sizeof(header), record.payload);
  return crc32c(record.payload) == header.payloadCheck ? std::optional(std::move(record)) : std::nullopt;
}

void SeaWriter::resumeImages(uint64_t fileBytes) {
  while (true) {
    uint64_t at = end_;
    std::optional<WholeRecord> record = wholeRecord(at, fileBytes);
    // Hidden samples whose image is missing are made again with it.
    std::optional<RecordHeader> hidden;
    if (record && record->header.kind == RecordKind::kHidden) {
      hidden = record->header;
      at += sizeof(RecordHeader) + sea::paddedBytes(hidden->payloadBytes);
      record = wholeRecord(at, fileBytes);
    }
    if (!record || record->header.kind != RecordKind::kImage || record->header.number >= entries_.size() ||
        has(record->header.number) || record->payload.size() < sizeof(sea::ImagePrefix) ||
        (hidden && hidden->number != record->header.number)) {
      return;
    }
    sea::ImagePrefix prefix;
    std::copy_n(record->payload.begin(), sizeof(prefix), reinterpret_cast<uint8_t*>(&prefix));
    sea::IndexEntry& entry = entries_[record->header.number];
    entry.offset = at + sizeof(RecordHeader);
    entry.payloadBytes = static_cast<uint32_t>(record->payload.size());
    entry.payloadCheck = record->header.payloadCheck;
    entry.reference = prefix.reference;
    entry.hiddenBytes = hidden ? static_cast<uint32_t>(hidden->payloadBytes) : 0;
    end_ = entry.offset + sea::paddedBytes(entry.payloadBytes);
    ++count_;
  }
}

void SeaWriter::add(uint32_t image, const sea::ImagePrefix& prefix, std::span<const uint8_t> coded,
                    std::span<const uint8_t> hidden) {
  OC_CHECK(image < entries_.size() && !has(image), "each image is added once");
  OC_CHECK(sizeof(prefix) + coded.size() <= sea::kMaxPayload, "a coded image is no longer than that");
  OC_CHECK(hidden.empty() || prefix.reference == sea::kNoReference, "hidden samples are of I-nodes");
  OC_CHECK(hidden.size() <= sea::kMaxPayload, "hidden samples take no more bytes than that");
  sea::IndexEntry& entry = entries_[image];
  if (!hidden.empty()) {
    append(RecordKind::kHidden, image, hidden);
  }
  entry.hiddenBytes = static_cast<uint32_t>(hidden.size());
  entry.offset = append(RecordKind::kImage, image, sea::bytesOf(prefix), coded);
  entry.payloadBytes = static_cast<uint32_t>(sizeof(prefix) + coded.size());
  entry.payloadCheck = crc32c(coded, crc32c(sea::bytesOf(prefix)));
  entry.reference = prefix.reference;
  ++count_;
}

SeaWriter::StoredImage SeaWriter::read(uint32_t image) const {
  OC_CHECK(image < entries_.size() && has(image), "an image that is there");
  const sea::IndexEntry& entry = entries_[image];
  StoredImage stored;
  stored.coded.resize(entry.payloadBytes - sizeof(stored.prefix));
  read(entry.offset, {reinterpret_cast<uint8_t*>(&stored.prefix), sizeof(stored.prefix)});
  read(entry.offset + sizeof(stored.prefix), stored.coded);
  stored.hidden.resize(entry.hiddenBytes);
  read(sea::hiddenOffset(entry.offset, entry.hiddenBytes), stored.hidden);
  return stored;
}

void SeaWriter::finish() {
  OC_CHECK(count_ == entries_.size(), "all images are there");
  for (sea::IndexEntry& entry : entries_) {
    entry.additions = 0;
    for (uint32_t at = entry.reference; at != sea::kNoReference; at = entries_[at].reference) {
      ++entry.additions;
      OC_CHECK(entry.additions < entries_.size(), "references lead to an I-node");
    }
  }
  std::vector<uint8_t> index;
  index.reserve(entries_.size() * sizeof(sea::IndexEntry));
  for (const sea::IndexEntry& entry : entries_) {
    const sea::IndexEntry whole = sea::sealed(entry);
    const auto part = sea::bytesOf(whole);
    index.insert(index.end(), part.begin(), part.end());
  }
  sea::Header header;
  header.isComplete = 1;
  header.posesOffset = posesOffset_;
  header.indexOffset = append(RecordKind::kIndex, 0, index);
  header.fileBytes = end_;
  header.images = static_cast<uint32_t>(entries_.size());
  if (::fdatasync(file_) != 0) {
    fail(errno);
  }
  write(0, sea::bytesOf(sea::sealed(header)));
  if (::fdatasync(file_) != 0 || std::rename(partial_.c_str(), path_.c_str()) != 0) {
    fail(errno);
  }
}

}  // namespace ocelli
