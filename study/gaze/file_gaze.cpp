// A file that another program writes, or a named pipe: lines are taken as they appear.
#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <thread>

#include "oc_core/base/error.h"
#include "study/gaze/gaze_input.h"

namespace ocelli {
namespace {

constexpr size_t kMaxBuffered = 1 << 16;
constexpr int kNewLinesMilliseconds = 2;  ///< a file does not say when it grows

class FileGaze : public GazeBytes {
 public:
  explicit FileGaze(int descriptor) : file_(descriptor) {}
  ~FileGaze() override { close(file_); }
  FileGaze(const FileGaze&) = delete;
  FileGaze& operator=(const FileGaze&) = delete;

  std::string read(int waitMilliseconds) override {
    for (int waited = 0;; waited += kNewLinesMilliseconds) {
      std::array<char, 1 << 14> bytes{};
      const ssize_t count = ::read(file_, bytes.data(), bytes.size());
      if (count > 0) {
        begun_.append(bytes.data(), static_cast<size_t>(count));
        const size_t end = begun_.size() > kMaxBuffered ? begun_.size() - 1 : begun_.rfind('\n');
        if (end != std::string::npos) {
          std::string lines = begun_.substr(0, end + 1);
          begun_.erase(0, end + 1);
          return lines;
        }
      }
      if (waited >= waitMilliseconds) {
        return {};
      }
      std::this_thread::sleep_for(std::chrono::milliseconds(kNewLinesMilliseconds));
    }
  }

 private:
  int file_;
  std::string begun_{};  ///< a line that has not ended yet
};

std::unique_ptr<GazeBytes> openFile(const std::string& text) {
  const std::string where = "--gaze file:" + text;
  if (text.empty()) {
    throw InputError("must name a file", where, "such as file:gaze.csv");
  }
  const int descriptor = open(text.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
  if (descriptor < 0) {
    throw InputError(std::string("the file cannot be read (") + std::strerror(errno) + ")", where,
                     "a file that the tracker's program writes, or a named pipe");
  }
  return std::make_unique<FileGaze>(descriptor);
}

}  // namespace

GazeInputKind fileGaze() {
  return {"file", "file:PATH[,norm]", "lines that another program adds to a file, or writes to a named pipe", openFile};
}

}  // namespace ocelli
