#include "tests/display_sim_frames/svol_cases.h"

#include <zstd.h>

#include <functional>

#include "display_sim/frames/svol_format.h"
#include "display_sim/frames/svol_writer.h"
#include "tests/base/temporary_folder.h"
#include "tests/display_sim_frames/svol_repair.h"
#include "tests/display_sim_observing/recorded_frames.h"
#include "tests/display_sim_slicing/test_files.h"
#include "tests/display_sim_slicing/test_meshes.h"

namespace ocelli::test {
namespace {

using Bytes = std::vector<uint8_t>;

constexpr int kFramesPerKey = 3;

Bytes recording(const DisplayProfile& profile, const std::vector<Volume>& volumes) {
  const TemporaryFolder folder;
  SvolWriter writer(folder / "a.svol", profile, {.metadata = R"({"software":"tests"})", .framesPerKey = kFramesPerKey});
  for (uint32_t k = 0; k < volumes.size(); ++k) {
    writer.append(volumes[k], recordedTime(k));
  }
  writer.finish();
  return bytesOf(folder / "a.svol");
}

Bytes one(const Volume& volume) {
  return recording(volume.profile(), {volume});
}

size_t headerBytes(const Bytes& file) {
  return svol::kHeaderBytes + svol::load32(file.data() + 12) + svol::load32(file.data() + 16) + svol::kChecksumBytes;
}

/// Where each frame of a whole file begins, and behind them where the index does.
std::vector<size_t> frameOffsets(const Bytes& file) {
  const size_t headBytes = svol::frameHeadBytes(svol::load32(file.data() + 20));
  std::vector<size_t> offsets = {headerBytes(file)};
  while (svol::load32(file.data() + offsets.back()) == svol::kFrameMark) {
    offsets.push_back(offsets.back() + headBytes + svol::load32(file.data() + offsets.back() + 20));
  }
  return offsets;
}

Bytes cut(const Bytes& file, size_t size) {
  return {file.begin(), file.begin() + static_cast<std::ptrdiff_t>(size)};
}

/// The profile's one frame with a single payload, in slice 0, whatever its bytes are.
Bytes withPayload(const DisplayProfile& profile, const Bytes& payload) {
  Bytes file = svol::headerRecord(profile, "{}");
  const size_t offset = file.size();
  svol::FrameHead head{0, 0, true, std::vector<svol::SliceEntry>(static_cast<size_t>(profile.storedSlices()))};
  head.slices[0] = {SvolSliceKind::kWhole, static_cast<uint32_t>(payload.size()), svol::checksum(payload)};
  const auto append = [&](const Bytes& bytes) { file.insert(file.end(), bytes.begin(), bytes.end()); };
  append(svol::frameRecordHead(head));
  append(payload);
  const SvolFrame frame{offset, 0, true};
  append(svol::indexAndEnd({&frame, 1}, file.size()));
  return file;
}

Bytes compressed(const Bytes& content) {
  Bytes bytes(ZSTD_compressBound(content.size()));
  bytes.resize(ZSTD_compress(bytes.data(), bytes.size(), content.data(), content.size(), 19));
  return bytes;
}

class Cases {
 public:
  void add(std::string name, Bytes bytes) { cases_.push_back({std::move(name), std::move(bytes)}); }
  /// A changed copy, its checksums made right again unless `repaired` is false.
  void change(const std::string& name, Bytes bytes, const std::function<void(Bytes&)>& edit, bool repaired = true) {
    edit(bytes);
    if (repaired) {
      repairSvolChecksums(bytes);
    }
    add(name, std::move(bytes));
  }
  std::vector<SvolCase> take() { return std::move(cases_); }

 private:
  std::vector<SvolCase> cases_;
};

void addGood(Cases& cases) {
  cases.add("good_small", one(coloredTorus(smallProfile(5, 17, 9))));
  cases.add("good_own_second_half", one(coloredTorus(smallProfile(3, 16, 9, SecondHalfTurn::kOwn))));
  cases.add("good_dark", one(Volume(smallProfile(5, 17, 9))));
  cases.add("good_3_bits", one(recordedVolume(recordedProfile(5, 17, 9, 3), 0)));
  cases.add("good_8_bits", one(recordedVolume(recordedProfile(5, 17, 9, 8), 0)));
  cases.add("good_recording", smallRecording(5));
  cases.add("good_without_frames", smallRecording(0));
}

void addUnfinished(Cases& cases) {
  const Bytes file = smallRecording(3);
  const std::vector<size_t> frames = frameOffsets(file);
  cases.add("unfinished_header_alone", cut(file, headerBytes(file)));
  cases.add("unfinished_two_frames", cut(file, frames[2]));
  cases.add("unfinished_in_mark", cut(file, frames[2] + 2));
  cases.add("unfinished_in_head", cut(file, frames[2] + 30));
  cases.add("unfinished_in_payload", cut(file, frames[3] - 1));
  cases.add("unfinished_in_index", cut(file, frames[3] + 20));
  cases.add("unfinished_in_end", cut(file, file.size() - 1));
}

void addBadHeaders(Cases& cases) {
  const Bytes file = one(coloredTorus(smallProfile(5, 17, 9)));
  const auto field = [&](const std::string& name, size_t at, uint32_t value) {
    cases.change(name, file, [&](Bytes& bytes) { svol::store32(bytes.data() + at, value); });
  };
  cases.add("bad_empty", {});
  cases.add("bad_header_truncated", cut(file, headerBytes(file) - 1));
  cases.change("bad_magic", file, [](Bytes& bytes) { bytes[1] = 'X'; });
  field("bad_version", 8, 2);
  field("bad_profile_size", 12, 0xffffffff);
  field("bad_metadata_size", 16, 0x7fffffff);
  field("bad_slice_count", 20, 6);
  field("bad_width", 24, 18);
  field("bad_height", 28, 10);
  field("bad_bits", 32, 2);
  cases.change("bad_profile_json", file, [](Bytes& bytes) { bytes[svol::kHeaderBytes] = '['; });
  cases.change("bad_metadata_json", file, [](Bytes& bytes) { bytes[headerBytes(bytes) - 5] = ']'; });
  cases.change(
      "bad_header_checksum", file, [](Bytes& bytes) { bytes[svol::kHeaderBytes + 12] ^= 1; }, false);
}

void addBadFrames(Cases& cases) {
  const Bytes file = smallRecording(3);
  const std::vector<size_t> frames = frameOffsets(file);
  const auto field = [&](const std::string& name, size_t frame, size_t at, uint32_t value) {
    cases.change(name, file, [&](Bytes& bytes) { svol::store32(bytes.data() + frames[frame] + at, value); });
  };
  field("bad_frame_mark", 1, 0, 0);
  field("bad_frame_number", 1, 4, 7);
  field("bad_frame_time", 1, 8, 4000000000u);  // later than the next one
  field("bad_frame_kind", 1, 16, 2);
  field("bad_first_frame_delta", 0, 16, 1);
  field("bad_key_frame_with_deltas", 1, 16, 0);
  field("bad_frame_size", 1, 20, 0xfffffff0);
  field("bad_dark_slice_with_size", 0, svol::kFrameFieldBytes, 40);
  field("bad_dark_slice_with_checksum", 0, svol::kFrameFieldBytes + 4, 1);
  field("bad_slice_size", 0, svol::kFrameFieldBytes + svol::kSliceEntryBytes, 0xfffffffd);
  cases.change(
      "bad_frame_checksum", file, [&](Bytes& bytes) { bytes[frames[1] + 25] ^= 1; }, false);
  cases.change(
      "bad_slice_checksum", file, [&](Bytes& bytes) { bytes[frames[1] - 1] ^= 1; }, false);
  cases.change("bad_frame_time_limit", file, [&](Bytes& bytes) {
    const size_t inIndex = frames[3] + svol::kIndexFieldBytes + 2 * svol::kIndexEntryBytes + 8;
    svol::store32(bytes.data() + frames[2] + 12, 1u << 21);
    svol::store32(bytes.data() + inIndex + 4, 1u << 21);
  });
  cases.change("bad_frame_missing", file, [&](Bytes& bytes) {
    bytes.erase(bytes.begin() + static_cast<std::ptrdiff_t>(frames[1]),
                bytes.begin() + static_cast<std::ptrdiff_t>(frames[2]));
  });
}

void addBadPayloads(Cases& cases) {
  const DisplayProfile profile = smallProfile(5, 17, 9);
  const VolumeLayout layout(profile);
  Bytes planes(layout.sliceBytes, 0);
  planes[2] = 0x80;  // column 23 of 17
  cases.add("bad_padding_bit", withPayload(profile, compressed(planes)));
  cases.add("bad_zstd", withPayload(profile, {1, 2, 3, 4, 5, 6, 7, 8}));
  cases.add("bad_zstd_bomb", withPayload(profile, compressed(Bytes(size_t{1} << 20, 0))));
  Bytes two = compressed(Bytes(layout.sliceBytes, 0));
  two.insert(two.end(), two.begin(), two.end());
  cases.add("bad_zstd_two_frames", withPayload(profile, two));
}

void addBadIndices(Cases& cases) {
  const Bytes file = smallRecording(3);
  const size_t index = frameOffsets(file).back();
  const auto field = [&](const std::string& name, size_t at, uint32_t value, bool repaired = true) {
    cases.change(
        name, file, [&](Bytes& bytes) { svol::store32(bytes.data() + at, value); }, repaired);
  };
  field("bad_index_mark", index, 0);
  field("bad_index_count", index + 4, 0xffffffff);
  field("bad_index_offset", index + svol::kIndexFieldBytes + svol::kIndexEntryBytes, 0);
  field("bad_index_time", index + svol::kIndexFieldBytes + svol::kIndexEntryBytes + 8, 1);
  field("bad_index_kind", index + svol::kIndexFieldBytes + svol::kIndexEntryBytes + 16, 0);
  field("bad_index_checksum", index + svol::indexBytes(3) - 4, 0, false);
  field("bad_end_mark", file.size() - svol::kEndBytes, 0);
  field("bad_end_offset", file.size() - svol::kEndBytes + 4, 1);
  field("bad_end_checksum", file.size() - 4, 0, false);
  cases.change("bad_trailing_byte", file, [](Bytes& bytes) { bytes.push_back(0); });
}

}  // namespace

Bytes smallRecording(int frames) {
  const DisplayProfile profile = recordedProfile(5, 17, 9, 1);
  std::vector<Volume> volumes;
  for (int k = 0; k < frames; ++k) {
    volumes.push_back(recordedVolume(profile, static_cast<uint32_t>(k)));
  }
  return recording(profile, volumes);
}

std::vector<SvolCase> svolCases() {
  Cases cases;
  addGood(cases);
  addUnfinished(cases);
  addBadHeaders(cases);
  addBadFrames(cases);
  addBadPayloads(cases);
  addBadIndices(cases);
  return cases.take();
}

}  // namespace ocelli::test
