// A sea of images (`.sea`) to be read: any image at once, and views between them.
//
//   const SeaFile sea("museum.sea");
//   const Image<Rgb8> image = sea.image(1234);
//
// The file is mapped into memory (mapped_file.h, which says what happens where it becomes shorter meanwhile): what is
// not touched is not read. Everything is checked when it is read, against checksums and against files that were made to
// mislead.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "oc_core/base/mapped_file.h"
#include "oc_core/base/progress.h"
#include "oc_core/sea/sea_decoder.h"
#include "oc_core/sea/sea_format.h"

namespace ocelli {

class SeaFile {
 public:
  /// Throws InputError where the file is missing, no sea, of another version, not complete, or damaged where it says
  /// what it holds.
  explicit SeaFile(const std::filesystem::path& path);
  ~SeaFile();
  SeaFile(const SeaFile&) = delete;
  SeaFile& operator=(const SeaFile&) = delete;

  const SeaSettings& settings() const { return decoder_->settings(); }
  const SeaProxy& proxy() const { return *proxy_; }
  uint32_t count() const { return header_.images; }
  uint64_t fileBytes() const { return file_.bytes().size(); }

  /// These throw InputError, naming the file and the image, where it is damaged. Any thread may call them.
  SeaPose pose(uint32_t image) const;
  struct Stored {
    uint32_t reference = sea::kNoReference;
    uint32_t additions = 0;
    uint64_t bytes = 0;        ///< of what its codec wrote
    uint64_t hiddenBytes = 0;  ///< of its hidden samples
    double quality = 0;
    SeaPose refinedPose;
  };
  Stored stored(uint32_t image) const;
  /// All names, in order; none where the images had none.
  std::vector<std::string> names() const;

  /// The image, with what it hangs on decoded for it. On the calling thread alone.
  Image<Rgb8> image(uint32_t image) const;
  /// What `image()` of the image that it hangs on gives, ready to be warped: for those who keep some.
  WarpReference reference(uint32_t image) const;
  /// The same as image(), where `reference` is reference() of the image that it hangs on.
  Image<Rgb8> imageFrom(const WarpReference& reference, uint32_t image) const;

  /// Of all images. Reads all poses once.
  std::vector<glm::dvec3> positions() const;
  /// What is seen from any place: the nearest three images, warped there and blended. On the calling thread alone.
  Image<Rgb8> view(const SeaPose& pose) const;

  /// What image() reads of the file, bytes; without what opening the file reads.
  uint64_t bytesToRead(uint32_t image) const;
  /// What opening reads.
  uint64_t bytesToOpen() const { return openBytes_; }

  /// Gives the memory of what was read back to the system.
  void release() const { file_.release(); }

  /// Checks every byte of the file, and with `decode` that each image can be had; throws as above. `progress` gets
  /// shares of the images.
  void verify(bool decode, const Progress& progress = {}) const;

 private:
  struct Record {
    sea::RecordHeader header;
    uint64_t at = 0;  ///< of its payload
    std::span<const uint8_t> payload;
  };

  [[noreturn]] void refuse(const std::string& what) const;
  /// The record that begins there; its payload is checked.
  Record record(uint64_t at) const;
  Record expect(uint64_t at, sea::RecordKind kind) const;
  sea::IndexEntry entry(uint32_t image) const;
  struct Payload {
    sea::ImagePrefix prefix;
    std::span<const uint8_t> coded;
  };
  Payload payload(uint32_t image, const sea::IndexEntry& entry) const;
  /// Of an I-node; none where it has none.
  std::span<const uint8_t> hidden(uint32_t image, const sea::IndexEntry& entry) const;
  WarpReference innerReference(uint32_t image) const;
  /// What a record of an image and the one of its hidden samples before it say, as the index must too.
  struct ImagePlace {
    uint64_t offset = 0;
    uint64_t hiddenBytes = 0;
  };
  std::vector<ImagePlace> checkedPlaces(const Progress& progress) const;
  Image<Rgb8> withResidual(const WarpReference& reference, uint32_t image, const sea::IndexEntry& entry) const;
  static uint64_t endOf(const Record& record);

  std::filesystem::path path_;
  MappedFile file_;
  sea::Header header_;
  uint64_t namesAt_ = 0;
  uint64_t imagesAt_ = 0;
  uint64_t openBytes_ = 0;
  std::unique_ptr<SeaProxy> proxy_;
  std::unique_ptr<SeaDecoder> decoder_;
};

}  // namespace ocelli
