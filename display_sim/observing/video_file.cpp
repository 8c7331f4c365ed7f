// Frames go to ffmpeg's standard input as raw pixels, through a socket: a write to one whose reader has gone can fail
// without a signal.
#include <fcntl.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <string>
#include <system_error>
#include <vector>

#include "display_sim/observing/frame_sink.h"
#include "oc_core/base/check.h"
#include "oc_core/base/error.h"
#include "oc_core/base/machine.h"
#include "oc_core/base/output_file.h"

extern char** environ;

namespace ocelli {
namespace {

namespace fs = std::filesystem;

constexpr const char* kInsteadOfVideo = "give a folder, which gets a PNG file for each frame";

/// How ffmpeg is told to encode; both take an even number of rows and columns only.
std::vector<std::string> ffmpegArguments(const std::string& output, bool webm, const VideoFormat& format) {
  char rate[32];
  std::snprintf(rate, sizeof rate, "%.6f", format.framesPerSecond);
  std::vector<std::string> arguments = {"ffmpeg",
                                        "-hide_banner",
                                        "-loglevel",
                                        "error",
                                        "-y",
                                        "-f",
                                        "rawvideo",
                                        "-pixel_format",
                                        "rgb24",
                                        "-video_size",
                                        std::to_string(format.width) + "x" + std::to_string(format.height),
                                        "-framerate",
                                        rate,
                                        "-i",
                                        "pipe:0",
                                        "-an",
                                        "-vf",
                                        "pad=ceil(iw/2)*2:ceil(ih/2)*2",
                                        "-pix_fmt",
                                        "yuv420p"};
  const std::vector<std::string> codec =
      webm ? std::vector<std::string>{"-c:v", "libvpx-vp9", "-crf", "20", "-b:v", "0", "-f", "webm"}
           : std::vector<std::string>{"-c:v", "libx264", "-crf", "16", "-movflags", "+faststart", "-f", "mp4"};
  arguments.insert(arguments.end(), codec.begin(), codec.end());
  arguments.push_back(output);
  return arguments;
}

class Descriptor {
 public:
  explicit Descriptor(int value = -1) : value_(value) {}
  ~Descriptor() { close(); }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;

  int get() const { return value_; }
  void reset(int value) {
    close();
    value_ = value;
  }
  void close() {
    if (value_ >= 0) {
      ::close(value_);
      value_ = -1;
    }
  }

 private:
  int value_;
};

class VideoFile : public FrameSink {
 public:
  VideoFile(fs::path path, const VideoFormat& format) : path_(std::move(path)), partial_(path_), format_(format) {
    partial_ += ".partial";
    const auto program = findProgram("ffmpeg");
    if (!program) {
      throw WorkError("a video takes ffmpeg, which is not installed", path_.string(),
                      std::string("apt-get install ffmpeg, or ") + kInsteadOfVideo);
    }
    if (isStream(path_)) {
      throw InputError("a video is not written in one go, which this output needs", path_.string(),
                       "give the name of a file that ends in .mp4 or .webm");
    }
    checkWritable(path_);
    unfinished_ = UnfinishedOutput(partial_, [] {});
    start(*program);
  }
  ~VideoFile() override {
    frames_.close();
    if (process_ > 0) {
      kill(process_, SIGKILL);
      wait();
    }
    unfinished_.finish([this] {
      std::error_code ignored;
      fs::remove(partial_, ignored);
    });
  }

  void add(const Image<Rgb8>& frame) override {
    OC_CHECK(frame.width() == format_.width && frame.height() == format_.height, "a frame of another size");
    static_assert(sizeof(Rgb8) == 3);
    const auto* at = reinterpret_cast<const char*>(frame.data());
    for (size_t left = frame.size() * sizeof(Rgb8); left > 0;) {
      const ssize_t sent = send(frames_.get(), at, left, MSG_NOSIGNAL);
      if (sent < 0 && errno == EINTR) {
        continue;
      }
      if (sent < 0) {
        frames_.close();
        wait();
        fail();
      }
      at += sent;
      left -= static_cast<size_t>(sent);
    }
  }

  void finish() override {
    frames_.close();
    const int status = wait();
    std::error_code error;
    if (!WIFEXITED(status) || WEXITSTATUS(status) != 0 || fs::file_size(partial_, error) == 0 || error) {
      fail();
    }
    unfinished_.finish([&] { fs::rename(partial_, path_, error); });
    if (error) {
      throw WorkError("cannot write this file (" + error.message() + ")", path_.string(),
                      "check that the folder is writable");
    }
  }

 private:
  void start(const fs::path& program) {
    int ends[2];
    messages_.reset(std::tmpfile());
    if (!messages_ || socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0) {
      throw WorkError(std::string("cannot talk to ffmpeg (") + std::strerror(errno) + ")", path_.string(),
                      "check the space in the folder for temporary files");
    }
    frames_.reset(ends[0]);
    const Descriptor theirs(ends[1]);
    std::vector<std::string> arguments = ffmpegArguments(partial_.string(), path_.extension() == ".webm", format_);
    std::vector<char*> pointers;
    for (std::string& argument : arguments) {
      pointers.push_back(argument.data());
    }
    pointers.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, theirs.get(), STDIN_FILENO);
    posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_adddup2(&actions, fileno(messages_.get()), STDERR_FILENO);
    // A group of its own: Ctrl-C is for this program, which then ends ffmpeg and removes what it wrote.
    posix_spawnattr_t attributes;
    posix_spawnattr_init(&attributes);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
    const int error = posix_spawn(&process_, program.c_str(), &actions, &attributes, pointers.data(), environ);
    posix_spawnattr_destroy(&attributes);
    posix_spawn_file_actions_destroy(&actions);
    if (error != 0) {
      process_ = -1;
      throw WorkError(std::string("cannot start ffmpeg (") + std::strerror(error) + ")", program.string(),
                      kInsteadOfVideo);
    }
  }

  int wait() {
    int status = -1;
    while (process_ > 0 && waitpid(process_, &status, 0) < 0 && errno == EINTR) {
    }
    process_ = -1;
    return status;
  }

  [[noreturn]] void fail() {
    std::string said;
    std::rewind(messages_.get());
    for (int c = 0; (c = std::fgetc(messages_.get())) != EOF && said.size() < 2000;) {
      said += static_cast<char>(c);
    }
    while (said.ends_with('\n')) {
      said.pop_back();
    }
    throw WorkError("ffmpeg failed" + (said.empty() ? said : ": " + said), path_.string(), kInsteadOfVideo);
  }

  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };

  fs::path path_;
  fs::path partial_;
  VideoFormat format_;
  Descriptor frames_;
  std::unique_ptr<std::FILE, Close> messages_;  ///< what ffmpeg says
  pid_t process_ = -1;
  UnfinishedOutput unfinished_;
};

}  // namespace

bool isVideo(const std::filesystem::path& path) {
  return path.extension() == ".mp4" || path.extension() == ".webm";
}

std::unique_ptr<FrameSink> videoFile(const std::filesystem::path& path, const VideoFormat& format) {
  if (!isVideo(path)) {
    throw InputError("a video ends in .mp4 or .webm", path.string(), kInsteadOfVideo);
  }
  return std::make_unique<VideoFile>(path, format);
}

}  // namespace ocelli
