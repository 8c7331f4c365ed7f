#include "oc_core/base/output_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <optional>
#include <string>

#include "oc_core/base/error.h"
#include "oc_core/base/number_text.h"

namespace ocelli {
namespace {

namespace fs = std::filesystem;

/// Of a path that names a stream which this program has open already.
std::optional<int> descriptorOf(const fs::path& path) {
  const std::string text = path.string();
  if (text == "/dev/stdout") {
    return STDOUT_FILENO;
  }
  if (text == "/dev/stderr") {
    return STDERR_FILENO;
  }
  for (const std::string_view folder : {"/dev/fd/", "/proc/self/fd/"}) {
    if (text.starts_with(folder)) {
      if (const std::optional<int> number = numberFromText<int>(std::string_view(text).substr(folder.size()))) {
        return number;
      }
    }
  }
  return std::nullopt;
}

}  // namespace

bool isStream(const fs::path& path) {
  std::error_code ignored;
  const fs::file_status status = fs::status(path, ignored);
  return descriptorOf(path) || (fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status));
}

bool isStandardOutput(const fs::path& path) {
  return descriptorOf(path) == STDOUT_FILENO;
}

OutputFile::OutputFile(fs::path path) : path_(std::move(path)), target_(path_), written_(path_) {
  if (isStream(path_)) {
    if (const std::optional<int> descriptor = descriptorOf(path_)) {
      // Opened anew, a file would be written from its start, and a socket could not be.
      const int own = fcntl(*descriptor, F_DUPFD_CLOEXEC, 0);
      file_.reset(own < 0 ? nullptr : fdopen(own, "wb"));
    } else {
      file_.reset(std::fopen(path_.c_str(), "wb"));
    }
    if (!file_) {
      fail(errno);
    }
    return;
  }
  std::error_code ignored;
  if (fs::exists(path_, ignored)) {
    target_ = fs::canonical(path_, ignored);
    // A rename would not ask for the rights on what it replaces.
    if (access(target_.c_str(), W_OK) != 0) {
      fail(errno);
    }
    if (fs::is_directory(target_, ignored)) {
      fail(EISDIR);
    }
  }
  written_ = target_;
  written_ += ".partial";
  int error = 0;
  unfinished_ = UnfinishedOutput(written_, [&] {
    file_.reset(std::fopen(written_.c_str(), "wb"));
    error = file_ ? 0 : errno;
  });
  if (!file_) {
    unfinished_.finish([] {});
    fail(error);
  }
}

OutputFile::~OutputFile() {
  file_.reset();
  if (written_ != target_) {
    unfinished_.finish([this] {
      std::error_code ignored;
      fs::remove(written_, ignored);
    });
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
    unfinished_.finish([&] { fs::rename(written_, target_, error); });
    if (error) {
      std::error_code ignored;
      fs::remove(written_, ignored);
      written_ = target_;
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
  if (!isStream(path)) {
    const OutputFile probe(path);
  }
}

}  // namespace ocelli
