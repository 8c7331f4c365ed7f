// Writes a sea of images (`.sea`), record by record, as `PATH.partial`, which gets its name when it is complete. What a
// build that was stopped or killed has left, the next one goes on with.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "oc_core/sea/sea_format.h"

namespace ocelli {

/// What a sea begins with: all that its images depend on.
struct SeaPreamble {
  std::string settings;        ///< JSON
  std::string names;           ///< a line each
  std::vector<SeaPose> poses;  ///< of all images
  std::vector<uint8_t> proxy;  ///< proxyBytes()
};

class SeaWriter {
 public:
  /// Goes on with a file that begins with the same; `startOver` removes any. Throws InputError where one begins with
  /// something else, WorkError where nothing can be written, or another build writes it.
  SeaWriter(const std::filesystem::path& path, const SeaPreamble& preamble, bool startOver = false);
  ~SeaWriter();
  SeaWriter(const SeaWriter&) = delete;
  SeaWriter& operator=(const SeaWriter&) = delete;

  /// Images that are there already.
  size_t count() const { return count_; }
  bool has(uint32_t image) const { return entries_[image].payloadBytes > 0; }
  uint64_t bytes() const { return end_; }

  /// Throws WorkError where the disk is full: what was written stays.
  /// `hidden`: hiddenBytes(), of an I-node that has hidden samples.
  void add(uint32_t image, const sea::ImagePrefix& prefix, std::span<const uint8_t> coded,
           std::span<const uint8_t> hidden = {});
  struct StoredImage {
    sea::ImagePrefix prefix;
    std::vector<uint8_t> coded;
    std::vector<uint8_t> hidden;
  };
  /// Of one that is there. Any thread may call it while none adds.
  StoredImage read(uint32_t image) const;

  /// All images are there: writes the index, and gives the file its name.
  void finish();

 private:
  void open(bool startOver);
  void lock() const;
  void begin(const SeaPreamble& preamble);
  /// Where the records end that a file has, if it begins as this one does; nothing if it begins with something else.
  void resume(const SeaPreamble& preamble);
  /// Takes the images on whose records are whole, from `end_` on.
  void resumeImages(uint64_t fileBytes);
  /// The record that begins there, with its payload; nothing where it is not whole.
  struct WholeRecord {
    sea::RecordHeader header;
    std::vector<uint8_t> payload;
  };
  std::optional<WholeRecord> wholeRecord(uint64_t at, uint64_t fileBytes) const;
  uint64_t append(sea::RecordKind kind, uint32_t number, std::span<const uint8_t> first,
                  std::span<const uint8_t> second = {});
  void write(uint64_t at, std::span<const uint8_t> bytes) const;
  void read(uint64_t at, std::span<uint8_t> bytes) const;
  [[noreturn]] void fail(int reason) const;

  std::filesystem::path path_;
  std::filesystem::path partial_;
  int file_ = -1;
  uint64_t end_ = 0;
  uint64_t posesOffset_ = 0;
  size_t count_ = 0;
  std::vector<sea::IndexEntry> entries_;
};

}  // namespace ocelli
