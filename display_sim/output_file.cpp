#include "display_sim/output_file.h"

#include <cerrno>
#include <cstring>
#include <string>
#include <system_error>

#include "oc_core/base/error.h"

namespace ocelli {

OutputFile::OutputFile(std::filesystem::path path) : path_(std::move(path)), writtenPath_(path_) {
  std::error_code ignored;
  const std::filesystem::file_status status = std::filesystem::status(path_, ignored);
  if (!std::filesystem::exists(status) || std::filesystem::is_regular_file(status)) {
    writtenPath_ += ".partial";
  }
  file_.reset(std::fopen(writtenPath_.c_str(), "wb"));
  if (!file_) {
    fail();
  }
}

OutputFile::~OutputFile() {
  if (file_ && writtenPath_ != path_) {
    file_.reset();
    std::error_code ignored;
    std::filesystem::remove(writtenPath_, ignored);
  }
}

void OutputFile::write(std::span<const uint8_t> bytes) {
  if (std::fwrite(bytes.data(), 1, bytes.size(), file_.get()) != bytes.size()) {
    fail();
  }
}

void OutputFile::write(std::string_view text) {
  write(std::span(reinterpret_cast<const uint8_t*>(text.data()), text.size()));
}

void OutputFile::commit() {
  if (std::fflush(file_.get()) != 0) {
    fail();
  }
  if (writtenPath_ != path_) {
    std::error_code error;
    std::filesystem::rename(writtenPath_, path_, error);
    if (error) {
      errno = error.value();
      fail();
    }
  }
  file_.reset();
}

void OutputFile::fail() const {
  throw WorkError(std::string("cannot write this file (") + std::strerror(errno) + ")", path_.string(),
                  "check that the folder exists, is writable and has space");
}

}  // namespace ocelli
