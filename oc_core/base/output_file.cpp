#include "oc_core/base/output_file.h"

#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <string>
#include <system_error>

#include "oc_core/base/error.h"

namespace ocelli {
namespace {

namespace fs = std::filesystem;

bool isReplaceable(const fs::path& path) {
  std::error_code ignored;
  const fs::file_status status = fs::status(path, ignored);
  return !fs::exists(status) || fs::is_regular_file(status);
}

}  // namespace

OutputFile::OutputFile(fs::path path) : path_(std::move(path)), target_(path_) {
  std::error_code ignored;
  const bool exists = fs::exists(path_, ignored);
  if (exists) {
    target_ = fs::canonical(path_, ignored);
  }
  written_ = target_;
  if (isReplaceable(path_)) {
    written_ += ".partial";
    // A rename would not ask for the rights on what it replaces.
    if (exists && access(target_.c_str(), W_OK) != 0) {
      fail(errno);
    }
  }
  file_.reset(std::fopen(written_.c_str(), "wb"));
  if (!file_) {
    fail(errno);
  }
}

OutputFile::~OutputFile() {
  file_.reset();
  if (written_ != target_) {
    std::error_code ignored;
    fs::remove(written_, ignored);
  }
}

void OutputFile::write(std::span<const uint8_t> bytes) {
  // Nothing may lie at no address, which fwrite() must not be given.
  if (!bytes.empty() && std::fwrite(bytes.data(), 1, bytes.size(), file_.get()) != bytes.size()) {
    fail(errno);
  }
}

void OutputFile::write(std::string_view text) {
  write(std::span(reinterpret_cast<const uint8_t*>(text.data()), text.size()));
}

void OutputFile::flush() {
  if (std::fflush(file_.get()) != 0) {
    fail(errno);
  }
}

void OutputFile::publish() {
  flush();
  rename();
}

void OutputFile::commit() {
  // A full disk may show itself only here.
  if (std::fclose(file_.release()) != 0) {
    fail(errno);
  }
  rename();
}

void OutputFile::rename() {
  if (written_ != target_) {
    std::error_code error;
    fs::rename(written_, target_, error);
    if (error) {
      fail(error.value());
    }
    written_ = target_;
  }
}

void OutputFile::fail(int reason) const {
  throw WorkError(std::string("cannot write this file (") + std::strerror(reason) + ")", path_.string(),
                  "check that the folder exists, is writable and has space");
}

void checkWritable(const fs::path& path) {
  // A pipe would take our closing it for the end of what it gets.
  if (isReplaceable(path)) {
    const OutputFile probe(path);
  }
}

}  // namespace ocelli
