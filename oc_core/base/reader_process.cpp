#include "oc_core/base/reader_process.h"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <optional>

#include "oc_core/base/error.h"
#include "oc_core/base/machine.h"
#include "oc_core/base/number_text.h"

namespace ocelli {
namespace {

namespace fs = std::filesystem;

constexpr double kMebibyte = 1 << 20;
constexpr double kGibibyte = 1 << 30;
constexpr size_t kOutputBufferBytes = 1 << 16;

std::optional<double> positiveVariable(const char* name) {
  const char* text = std::getenv(name);
  if (text == nullptr || *text == '\0') {
    return std::nullopt;
  }
  const std::optional<double> value = numberFromText<double>(text);
  if (!value || *value <= 0 || *value > 1e9) {
    throw InputError("\"" + std::string(text) + "\" is not a number above 0, and at most 1e9", name,
                     std::string(name) + "=16");
  }
  return value;
}

std::string fixed(double value, int digits) {
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), "%.*f", digits, value);
  return text.data();
}

std::string moreSeconds(const ReaderProgram& reader) {
  return std::string(reader.convert) + ", or set " + reader.secondsVariable + " to more seconds";
}

/// The last line that a reader wrote before it ended, for those who look into it.
std::string lastLine(std::string_view messages) {
  constexpr size_t kMaxShown = 200;
  while (!messages.empty() && (messages.back() == '\n' || messages.back() == ' ')) {
    messages.remove_suffix(1);
  }
  const size_t start = messages.rfind('\n');
  messages.remove_prefix(start == std::string_view::npos ? 0 : start + 1);
  return std::string(messages.substr(0, kMaxShown));
}

[[noreturn]] void failSignal(const ReaderProgram& reader, const ChildEnd& end, const std::string& where,
                             double seconds) {
  if (end.code == SIGXCPU) {
    throw InputError("reading this file took longer than " + fixed(seconds, 0) + " s", where, moreSeconds(reader));
  }
  if (end.code == SIGKILL) {
    throw InputError("the system ended the reading of this file, probably for lack of memory", where,
                     std::string("close other programs, or ") + reader.reduce);
  }
  const std::string last = lastLine(end.messages);
  throw InputError(std::string(reader.library) + " crashed while it read this file (" + strsignal(end.code) +
                       (last.empty() ? "" : "; it last wrote: ") + last + ")",
                   where, reader.afterCrash);
}

void writeResult(std::span<const std::byte> bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(kChildResultDescriptor, bytes.data(), bytes.size());
    if (written < 0 && errno != EINTR) {
      throw WorkError(std::string("cannot hand back the result (") + std::strerror(errno) + ")", "", "");
    }
    bytes = bytes.subspan(written > 0 ? static_cast<size_t>(written) : 0);
  }
}

}  // namespace

uint64_t ReadingLimits::memoryBytes(uint64_t fileBytes) const {
  return static_cast<uint64_t>(std::min(memoryBase + memoryPerByte * static_cast<double>(fileBytes), memoryMax));
}

double ReadingLimits::processorSeconds(uint64_t fileBytes) const {
  return std::ceil(secondsBase + secondsPerByte * static_cast<double>(fileBytes));
}

double ReadingLimits::wallSeconds(uint64_t fileBytes) const {
  constexpr double kBusy = 4;
  return kBusy * processorSeconds(fileBytes);
}

ReadingLimits readingLimits(const ReaderProgram& reader) {
  ReadingLimits limits{kGibibyte, 64, 1e18, 30, 1 / kMebibyte};
  if (const auto memory = static_cast<double>(machineInfo().memoryBytes); memory > 0) {
    limits.memoryMax = std::max(kGibibyte, 0.75 * memory);
  }
  if (const std::optional<double> gibibytes = positiveVariable(reader.memoryVariable)) {
    limits.memoryBase = limits.memoryMax = *gibibytes * kGibibyte;
    limits.memoryPerByte = 0;
  }
  if (const std::optional<double> seconds = positiveVariable(reader.secondsVariable)) {
    limits.secondsBase = *seconds;
    limits.secondsPerByte = 0;
  }
  return limits;
}

ReaderResult runReaderProgram(const ReaderProgram& reader, const std::vector<std::string>& arguments,
                              const fs::path& path, uint64_t fileBytes, const std::function<void()>& tick) {
  const std::string where = path.string();
  const ReadingLimits limits = readingLimits(reader);
  ChildCommand command{findOwnProgram(reader.program), {std::to_string(getpid())}, limits.wallSeconds(fileBytes)};
  command.arguments.insert(command.arguments.end(), arguments.begin(), arguments.end());
  const ChildEnd end = runChild(command, tick);
  switch (end.how) {
    case ChildEnd::How::kOutOfTime:
      throw InputError("reading this file took longer than " + fixed(command.seconds, 0) + " s", where,
                       moreSeconds(reader));
    case ChildEnd::How::kKilledBySignal:
      failSignal(reader, end, where, limits.processorSeconds(fileBytes));
    case ChildEnd::How::kExited:
      break;
  }
  if (end.code == kReaderOutOfMemory) {
    throw InputError("reading this file takes more than " +
                         fixed(static_cast<double>(limits.memoryBytes(fileBytes)) / kGibibyte, 1) +
                         " GiB of memory, far more than its size explains",
                     where,
                     std::string("the file may be damaged; if not, set ") + reader.memoryVariable + " to more GiB");
  }
  if (end.code != kReaderDone) {
    throw WorkError(std::string("the program that ") + reader.program.does + " failed (exit code " +
                        std::to_string(end.code) + "): " + lastLine(end.messages),
                    command.program.string(), "install Ocelli whole, so that both are of one version");
  }
  return {end.result, command.program.string()};
}

void ReaderOutput::write(std::span<const std::byte> bytes) {
  if (buffer_.size() + bytes.size() > kOutputBufferBytes) {
    flush();
  }
  if (bytes.size() > kOutputBufferBytes) {
    writeResult(bytes);
  } else {
    buffer_.insert(buffer_.end(), bytes.begin(), bytes.end());
  }
}

void ReaderOutput::flush() {
  writeResult(buffer_);
  buffer_.clear();
}

}  // namespace ocelli
