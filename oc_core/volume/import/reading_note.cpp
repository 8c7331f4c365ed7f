#include "oc_core/volume/import/reading_note.h"

#include <unistd.h>

#include <array>
#include <csignal>
#include <cstring>
#include <string>

namespace ocelli {
namespace {

// A signal handler can reach nothing but a global.
std::array<char, 512> notedLine{};

extern "C" void writeNoteAndDie(int signal) {
  const size_t length = ::strnlen(notedLine.data(), notedLine.size());
  // What was not written is not shown; there is nothing else to do here.
  [[maybe_unused]] const ssize_t written = ::write(STDERR_FILENO, notedLine.data(), length);
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

}  // namespace

void noteCrashes() {
  for (const int signal : {SIGSEGV, SIGABRT, SIGFPE, SIGBUS, SIGILL}) {
    std::signal(signal, writeNoteAndDie);
  }
}

void noteFileRead(const std::filesystem::path& file) {
  const std::string line = "\nit was reading " + file.string().substr(0, notedLine.size() - 32) + "\n";
  notedLine.fill('\0');
  line.copy(notedLine.data(), notedLine.size() - 1);
}

}  // namespace ocelli
