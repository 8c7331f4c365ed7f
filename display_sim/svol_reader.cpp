#include <zstd.h>

#include <algorithm>
#include <array>

#include "display_sim/svol_file.h"
#include "display_sim/svol_format.h"
#include "oc_core/base/error.h"

namespace ocelli {
namespace {

/// The bits of a row's last byte that lie beyond the width.
uint8_t paddingMask(int width) {
  return static_cast<uint8_t>(width % 8 == 0 ? 0 : 0xff << (width % 8));
}

}  // namespace

SvolReader::SvolReader(const std::filesystem::path& path)
    : file_(path, std::ios::binary), in_(file_), where_(path.string()) {
  if (!file_ || std::filesystem::is_directory(path)) {
    throw InputError("cannot open this .svol file", where_, "check the path");
  }
  readHeader();
}

SvolReader::SvolReader(std::istream& in, std::string where) : in_(in), where_(std::move(where)) {
  readHeader();
}

void SvolReader::fail(const std::string& what) const {
  const std::string part = inSlice_ ? "slice " + std::to_string(next_) + ": " : "header: ";
  throw InputError(part + what, where_, "write the file again, or give another one");
}

void SvolReader::readExactly(std::span<uint8_t> bytes) {
  in_.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  if (static_cast<size_t>(in_.gcount()) != bytes.size()) {
    fail("the file ends too soon");
  }
}

uint64_t SvolReader::bytesLeft() {
  const std::istream::pos_type here = in_.tellg();
  in_.seekg(0, std::ios::end);
  const std::istream::pos_type end = in_.tellg();
  in_.seekg(here);
  if (!in_ || end < here) {
    fail("the file cannot be positioned in (a pipe, perhaps)");
  }
  return static_cast<uint64_t>(end - here);
}

void SvolReader::readHeader() {
  std::array<uint8_t, svol::kHeaderBytes> header{};
  readExactly(header);
  if (!std::equal(svol::kMagic.begin(), svol::kMagic.end(), header.begin())) {
    fail("this is no .svol file (it does not begin with its eight magic bytes)");
  }
  const auto field = [&](size_t i) { return svol::load32(header.data() + svol::kMagic.size() + 4 * i); };
  if (field(0) != svol::kVersion) {
    fail("version " + std::to_string(field(0)) + " of the format, but only version 1 is known");
  }
  if (field(1) == 0 || field(1) > svol::kMostProfileBytes) {
    fail("a profile of " + std::to_string(field(1)) + " bytes (1 to 65536 are allowed)");
  }
  std::string json(field(1), '\0');
  const std::span<uint8_t> jsonBytes(reinterpret_cast<uint8_t*>(json.data()), json.size());
  readExactly(jsonBytes);
  std::array<uint8_t, svol::kChecksumBytes> sum{};
  readExactly(sum);
  if (svol::load32(sum.data()) != svol::checksum(jsonBytes, svol::checksum(header))) {
    fail("the checksum is wrong");
  }
  profile_ = profileFromJsonText(json, where_);
  layout_ = VolumeLayout(profile_);
  if (field(2) != layout_.slices || field(3) != static_cast<uint32_t>(profile_.width) ||
      field(4) != static_cast<uint32_t>(profile_.height) || field(5) != kColorChannels) {
    fail("its counts contradict its profile");
  }
  // No record is smaller than this, so a short file cannot ask for the memory of a large volume.
  if (bytesLeft() < layout_.slices * (svol::kRecordHeaderBytes + svol::kChecksumBytes + 1)) {
    fail("the file is too short for its " + std::to_string(layout_.slices) + " slices");
  }
}

void SvolReader::readSlice(std::span<uint8_t> planes) {
  OC_CHECK(!atEnd() && planes.size() == layout_.sliceBytes, "no slice is left, or its buffer has another size");
  inSlice_ = true;
  std::array<uint8_t, svol::kRecordHeaderBytes> header{};
  readExactly(header);
  if (svol::load32(header.data()) != next_) {
    fail("slice " + std::to_string(svol::load32(header.data())) + " stands in its place");
  }
  const size_t size = svol::load32(header.data() + 4);
  if (size == 0 || size > ZSTD_compressBound(layout_.sliceBytes)) {
    fail(std::to_string(size) + " compressed bytes are not possible here");
  }
  payload_.resize(size);
  readExactly(payload_);
  std::array<uint8_t, svol::kChecksumBytes> sum{};
  readExactly(sum);
  if (svol::load32(sum.data()) != svol::checksum(payload_, svol::checksum(header))) {
    fail("the checksum is wrong");
  }
  if (ZSTD_findFrameCompressedSize(payload_.data(), size) != size ||
      ZSTD_getFrameContentSize(payload_.data(), size) != layout_.sliceBytes ||
      ZSTD_decompress(planes.data(), planes.size(), payload_.data(), size) != layout_.sliceBytes) {
    fail("its bytes are not one zstd frame of " + std::to_string(layout_.sliceBytes) + " bytes");
  }
  const uint8_t padding = paddingMask(profile_.width);
  for (size_t last = layout_.rowBytes - 1; padding != 0 && last < planes.size(); last += layout_.rowBytes) {
    if ((planes[last] & padding) != 0) {
      fail("a bit beyond the width is set");
    }
  }
  ++next_;
  if (atEnd() && in_.peek() != std::istream::traits_type::eof()) {
    inSlice_ = false;
    throw InputError("there are bytes after the last slice", where_, "write the file again, or give another one");
  }
}

Volume readSvol(std::istream& in, const std::string& where) {
  SvolReader reader(in, where);
  Volume volume(reader.profile());
  for (int i = 0; !reader.atEnd(); ++i) {
    reader.readSlice(volume.slice(i));
  }
  return volume;
}

Volume readSvol(const std::filesystem::path& path) {
  SvolReader reader(path);
  Volume volume(reader.profile());
  for (int i = 0; !reader.atEnd(); ++i) {
    reader.readSlice(volume.slice(i));
  }
  return volume;
}

SvolSummary verifySvol(const std::filesystem::path& path) {
  SvolReader reader(path);
  SvolSummary summary;
  summary.profile = reader.profile();
  summary.fileBytes = std::filesystem::file_size(path);
  summary.planeBytesTotal = reader.layout().slices * reader.layout().sliceBytes;
  std::vector<uint8_t> planes(reader.layout().sliceBytes);
  while (!reader.atEnd()) {
    reader.readSlice(planes);
    summary.litVoxels += countLit(planes, reader.layout());
  }
  return summary;
}

}  // namespace ocelli
