#include "display_sim/frames/svol_reader.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "display_sim/frames/svol_codec.h"
#include "display_sim/frames/svol_metadata.h"
#include "oc_core/base/check.h"

namespace ocelli {
namespace {

constexpr const char* kNext = "write the file again, or give another one";
constexpr const char* kNextWithFrames =
    "`ocelli volume join --salvage` makes a finished file of the frames before; or write the file again";

/// More than zstd needs for the worst planes, so that a hostile size cannot ask for much more memory than a frame has.
uint64_t maxPayloadBytes(const VolumeLayout& layout) {
  return 2 * layout.sliceBytes + 1024;
}

uint64_t payloadBytesOf(const svol::FrameHead& head) {
  uint64_t bytes = 0;
  for (const svol::SliceEntry& slice : head.slices) {
    bytes += slice.bytes;
  }
  return bytes;
}

/// Empty where the entry of a slice is possible in such a frame.
std::string problemOf(const svol::SliceEntry& slice, bool inKeyFrame, const VolumeLayout& layout) {
  if (inKeyFrame && (slice.kind == SvolSliceKind::kDelta || slice.kind == SvolSliceKind::kUnchanged)) {
    return "it needs the frame before, in a key frame";
  }
  if (!svol::hasPayload(slice.kind)) {
    return slice.bytes == 0 && slice.checksum == 0 ? "" : "a slice without a payload has a size or a checksum";
  }
  if (slice.bytes == 0 || slice.bytes > maxPayloadBytes(layout)) {
    return std::to_string(slice.bytes) + " compressed bytes are not possible here";
  }
  return "";
}

}  // namespace

SvolReader::SvolReader(const std::filesystem::path& path)
    : file_(path, std::ios::binary), in_(file_), where_(path.string()) {
  if (!file_ || std::filesystem::is_directory(path)) {
    throw InputError("cannot open this .svol file", where_, "check the path");
  }
  open();
}

SvolReader::SvolReader(std::istream& in, std::string where) : in_(in), where_(std::move(where)) {
  open();
}

void SvolReader::open() {
  in_.seekg(0, std::ios::end);
  const std::istream::pos_type end = in_.tellg();
  if (!in_ || end < std::istream::pos_type(0)) {
    throw InputError("the file cannot be positioned in (a pipe, perhaps)", where_, "give a file on a disk");
  }
  fileBytes_ = static_cast<uint64_t>(end);
  readHeader();
  if (!readIndex()) {
    scan();
  }
}

void SvolReader::fail(const std::string& part, uint64_t offset, const std::string& what, size_t framesBefore) const {
  std::string text = part;
  text += ": ";
  text += what;
  text += " (in the record at byte " + std::to_string(offset) + ")";
  throw InputError(text, where_, framesBefore > 0 ? kNextWithFrames : kNext);
}

void SvolReader::failInFrame(size_t frame, std::optional<size_t> slice, uint64_t offset,
                             const std::string& what) const {
  std::string part = "frame " + std::to_string(frame);
  if (slice) {
    part += ", slice ";
    part += std::to_string(*slice);
  }
  fail(part, offset, what, frame);
}

void SvolReader::fail(size_t frame, std::optional<size_t> slice, const std::string& what) const {
  OC_CHECK(frame < frames_.size(), "there is no such frame");
  failInFrame(frame, slice, frames_[frame].offset, what);
}

void SvolReader::readAt(uint64_t offset, std::span<uint8_t> bytes) {
  in_.clear();
  in_.seekg(static_cast<std::streamoff>(offset));
  in_.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  if (static_cast<size_t>(in_.gcount()) != bytes.size()) {
    fail("file", offset, "it ends too soon, or cannot be read");
  }
}

void SvolReader::readHeader() {
  if (fileBytes_ < svol::kHeaderBytes) {
    fail("header", 0, "the file ends too soon");
  }
  std::vector<uint8_t> header(svol::kHeaderBytes);
  readAt(0, header);
  if (!std::equal(svol::kMagic.begin(), svol::kMagic.end(), header.begin())) {
    fail("header", 0, "this is no .svol file (it does not begin with its eight magic bytes)");
  }
  const auto field = [&](size_t i) { return svol::load32(header.data() + svol::kMagic.size() + 4 * i); };
  if (field(0) != svol::kVersion) {
    fail("header", 0, "version " + std::to_string(field(0)) + " of the format, but only version 1 is known");
  }
  const size_t profileBytes = field(1);
  const size_t metadataBytes = field(2);
  if (profileBytes == 0 || profileBytes > svol::kMaxProfileBytes || metadataBytes > svol::kMaxMetadataBytes) {
    fail("header", 0,
         "a profile of " + std::to_string(profileBytes) + " bytes and metadata of " + std::to_string(metadataBytes) +
             " (1 to 65536, and up to 1048576, are allowed)");
  }
  const size_t checkedBytes = svol::kHeaderBytes + profileBytes + metadataBytes;
  headerEnd_ = checkedBytes + svol::kChecksumBytes;
  if (fileBytes_ < headerEnd_) {
    fail("header", 0, "the file ends too soon");
  }
  header.resize(headerEnd_);
  readAt(0, header);
  if (svol::load32(header.data() + checkedBytes) != svol::checksum(std::span(header).first(checkedBytes))) {
    fail("header", 0, "the checksum is wrong");
  }
  const char* texts = reinterpret_cast<const char*>(header.data()) + svol::kHeaderBytes;
  profile_ = profileFromJsonText(std::string(texts, profileBytes), where_);
  layout_ = VolumeLayout(profile_);
  if (field(3) != layout_.slices || field(4) != static_cast<uint32_t>(profile_.width) ||
      field(5) != static_cast<uint32_t>(profile_.height) ||
      field(6) != static_cast<uint32_t>(profile_.colorBitsPerChannel)) {
    fail("header", 0, "its counts contradict its profile");
  }
  metadata_.assign(texts + profileBytes, metadataBytes);
  svol::requireMetadata(metadata_, where_);
}

bool SvolReader::readIndex() {
  constexpr size_t kMin = svol::indexBytes(0) + svol::kEndBytes;
  if (fileBytes_ < headerEnd_ + kMin) {
    return false;
  }
  std::array<uint8_t, svol::kEndBytes> end{};
  readAt(fileBytes_ - end.size(), end);
  const uint64_t offset = svol::load64(end.data() + 4);
  if (offset < headerEnd_ || offset > fileBytes_ - kMin) {
    return false;
  }
  const uint64_t entryBytes = fileBytes_ - offset - kMin;
  const uint64_t count = entryBytes / svol::kIndexEntryBytes;
  if (entryBytes % svol::kIndexEntryBytes != 0 ||
      count > (offset - headerEnd_) / svol::frameHeadBytes(layout_.slices)) {
    return false;
  }
  std::vector<uint8_t> bytes(fileBytes_ - offset);
  readAt(offset, bytes);
  std::vector<SvolFrame> frames(count);
  for (size_t k = 0; k < frames.size(); ++k) {
    const uint8_t* entry = bytes.data() + svol::kIndexFieldBytes + k * svol::kIndexEntryBytes;
    frames[k] = {svol::load64(entry), svol::load64(entry + 8), svol::load32(entry + 16) == 0};
  }
  if (bytes != svol::indexAndEnd(frames, offset) || !placesFit(frames, offset)) {
    return false;
  }
  frames_ = std::move(frames);
  framesEnd_ = offset;
  return true;
}

bool SvolReader::placesFit(std::span<const SvolFrame> frames, uint64_t end) const {
  uint64_t least = headerEnd_;
  uint64_t time = 0;
  for (const SvolFrame& frame : frames) {
    const bool first = &frame == frames.data();
    if (first ? frame.offset != least || !frame.key : frame.offset < least) {
      return false;
    }
    if (frame.offset > end || frame.timeMicroseconds < time || frame.timeMicroseconds > svol::kMaxMicroseconds) {
      return false;
    }
    least = frame.offset + svol::frameHeadBytes(layout_.slices);
    time = frame.timeMicroseconds;
  }
  return frames.empty() ? end == headerEnd_ : least <= end;
}

void SvolReader::scan() {
  ending_ = SvolEnding::kUnfinished;
  framesEnd_ = headerEnd_;
  try {
    while (scanRecord()) {
    }
    checkLastPayloads();
  } catch (const InputError& error) {
    ending_ = SvolEnding::kDamaged;
    damage_ = error;
  }
}

bool SvolReader::scanRecord() {
  const uint64_t left = fileBytes_ - framesEnd_;
  const size_t number = frames_.size();
  std::array<uint8_t, 4> mark{};
  const std::span<uint8_t> start = std::span(mark).first(std::min<uint64_t>(mark.size(), left));
  readAt(framesEnd_, start);
  const auto begins = [&](uint32_t record) {
    std::array<uint8_t, 4> bytes{};
    svol::store32(bytes.data(), record);
    return std::equal(start.begin(), start.end(), bytes.begin());
  };
  if (!begins(svol::kFrameMark)) {
    if (!begins(svol::kIndexMark)) {
      failInFrame(number, {}, framesEnd_, "neither a frame nor the index begins here");
    }
    scanIndex();
    return false;
  }
  if (left < svol::frameHeadBytes(layout_.slices)) {
    return false;
  }
  const svol::FrameHead head = readHeadAt(number, framesEnd_);
  if (!frames_.empty() && head.timeMicroseconds < frames_.back().timeMicroseconds) {
    failInFrame(number, {}, framesEnd_, "it is shown before the frame before it");
  }
  const uint64_t bytes = svol::frameHeadBytes(layout_.slices) + payloadBytesOf(head);
  if (left < bytes) {
    return false;
  }
  frames_.push_back({framesEnd_, head.timeMicroseconds, head.key});
  framesEnd_ += bytes;
  return true;
}

void SvolReader::scanIndex() {
  const uint64_t left = fileBytes_ - framesEnd_;
  std::array<uint8_t, svol::kIndexFieldBytes> fields{};
  if (left < fields.size()) {
    return;
  }
  readAt(framesEnd_, fields);
  if (svol::load32(fields.data() + 4) != frames_.size()) {
    fail("index", framesEnd_, "it has another number of frames than the file", frames_.size());
  }
  const std::vector<uint8_t> expected = svol::indexAndEnd(frames_, framesEnd_);
  std::vector<uint8_t> bytes(std::min<uint64_t>(left, expected.size()));
  readAt(framesEnd_, bytes);
  if (!std::equal(bytes.begin(), bytes.end(), expected.begin())) {
    fail("index", framesEnd_, "it contradicts the frames, or its checksum is wrong", frames_.size());
  }
  if (left > expected.size()) {
    fail("index", framesEnd_, "there are bytes after the end of the file's last record", frames_.size());
  }
}

// What was written last may not have reached the disk when the machine lost its power.
void SvolReader::checkLastPayloads() {
  if (frames_.empty()) {
    return;
  }
  const size_t last = frames_.size() - 1;
  try {
    const svol::FrameHead head = readHead(last);
    std::vector<uint8_t> payloads;
    readPayloads(last, payloads);
    std::span<const uint8_t> rest = payloads;
    for (size_t i = 0; i < head.slices.size(); ++i) {
      const svol::SliceEntry& slice = head.slices[i];
      if (svol::hasPayload(slice.kind) && svol::checksum(rest.first(slice.bytes)) != slice.checksum) {
        fail(last, i, "the checksum is wrong");
      }
      rest = rest.subspan(slice.bytes);
    }
  } catch (const InputError&) {
    framesEnd_ = frames_[last].offset;
    frames_.pop_back();
    throw;
  }
}

svol::FrameHead SvolReader::readHeadAt(size_t number, uint64_t offset) {
  std::vector<uint8_t> bytes(svol::frameHeadBytes(layout_.slices));
  readAt(offset, bytes);
  const auto problem = [&](const std::string& what) { failInFrame(number, {}, offset, what); };
  const size_t checkedBytes = bytes.size() - svol::kChecksumBytes;
  if (svol::load32(bytes.data()) != svol::kFrameMark) {
    problem("no frame begins here");
  }
  if (svol::load32(bytes.data() + checkedBytes) != svol::checksum(std::span(bytes).first(checkedBytes))) {
    problem("the checksum is wrong");
  }
  svol::FrameHead head;
  head.number = svol::load32(bytes.data() + 4);
  head.timeMicroseconds = svol::load64(bytes.data() + 8);
  const uint32_t kind = svol::load32(bytes.data() + 16);
  head.key = kind == 0;
  if (head.number != number) {
    problem("frame " + std::to_string(head.number) + " stands in its place");
  }
  if (kind > 1 || (number == 0 && !head.key)) {
    problem("it cannot be of kind " + std::to_string(kind));
  }
  if (head.timeMicroseconds > svol::kMaxMicroseconds) {
    problem("it is shown after " + std::to_string(head.timeMicroseconds) + " microseconds, later than is allowed");
  }
  head.slices.resize(layout_.slices);
  for (size_t i = 0; i < head.slices.size(); ++i) {
    const uint8_t* entry = bytes.data() + svol::kFrameFieldBytes + i * svol::kSliceEntryBytes;
    const uint32_t sizeAndKind = svol::load32(entry);
    head.slices[i] = {static_cast<SvolSliceKind>(sizeAndKind & 3u), sizeAndKind >> 2, svol::load32(entry + 4)};
    const std::string what = problemOf(head.slices[i], head.key, layout_);
    if (!what.empty()) {
      failInFrame(number, i, offset, what);
    }
  }
  if (payloadBytesOf(head) != svol::load32(bytes.data() + 20)) {
    problem("its slices do not add up to its size");
  }
  return head;
}

uint64_t SvolReader::frameEnd(size_t frame) const {
  return frame + 1 < frames_.size() ? frames_[frame + 1].offset : framesEnd_;
}

uint64_t SvolReader::payloadsOffset(size_t frame) const {
  return frames_[frame].offset + svol::frameHeadBytes(layout_.slices);
}

svol::FrameHead SvolReader::readHead(size_t frame) {
  OC_CHECK(frame < frames_.size(), "there is no such frame");
  const SvolFrame& place = frames_[frame];
  svol::FrameHead head = readHeadAt(frame, place.offset);
  if (head.timeMicroseconds != place.timeMicroseconds || head.key != place.key ||
      payloadsOffset(frame) + payloadBytesOf(head) != frameEnd(frame)) {
    fail(frame, {}, "it contradicts the index");
  }
  return head;
}

void SvolReader::readPayloads(size_t frame, std::vector<uint8_t>& payloads) {
  payloads.resize(frameEnd(frame) - payloadsOffset(frame));
  readAt(payloadsOffset(frame), payloads);
}

size_t SvolReader::keyFrameOf(size_t frame) const {
  while (!frames_[frame].key) {
    --frame;
  }
  return frame;
}

size_t SvolReader::frameAt(uint64_t timeMicroseconds) const {
  const auto after = std::ranges::upper_bound(frames_, timeMicroseconds, {}, &SvolFrame::timeMicroseconds);
  return after == frames_.begin() ? 0 : static_cast<size_t>(after - frames_.begin()) - 1;
}

uint64_t SvolReader::durationMicroseconds(size_t frames) const {
  OC_CHECK(frames <= frames_.size(), "there are fewer frames");
  if (frames == 0) {
    return 0;
  }
  return frames_[frames - 1].timeMicroseconds - frames_.front().timeMicroseconds +
         static_cast<uint64_t>(std::llround(1e6 / profile_.refreshHertz()));
}

void SvolReader::readSlice(size_t frame, int slice, std::span<uint8_t> planes) {
  OC_CHECK(slice >= 0 && static_cast<size_t>(slice) < layout_.slices && planes.size() == layout_.sliceBytes,
           "no such slice, or its buffer has another size");
  struct Step {
    size_t frame;
    svol::SliceEntry entry;
    uint64_t offset;
  };
  const auto i = static_cast<size_t>(slice);
  std::vector<Step> steps;
  for (bool more = true; more; --frame) {
    const svol::FrameHead head = readHead(frame);
    uint64_t offset = payloadsOffset(frame);
    for (size_t before = 0; before < i; ++before) {
      offset += head.slices[before].bytes;
    }
    steps.push_back({frame, head.slices[i], offset});
    more = head.slices[i].kind == SvolSliceKind::kDelta || head.slices[i].kind == SvolSliceKind::kUnchanged;
  }
  svol::SliceDecoder decoder(profile_);
  std::vector<uint8_t> payload;
  for (auto step = steps.rbegin(); step != steps.rend(); ++step) {
    payload.resize(step->entry.bytes);
    readAt(step->offset, payload);
    const svol::SliceDecoder::Result result = decoder.apply(step->entry, payload, planes);
    if (!result.problem.empty()) {
      fail(step->frame, i, result.problem);
    }
  }
}

}  // namespace ocelli
