// A film as a stream of video, by the program ffmpeg: frame by frame as soon as each is there, without frames that wait
// for later ones.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "oc_core/base/progress.h"
#include "oc_core/remote_measure/path_film.h"

namespace ocelli {

/// One row of streamKinds().
struct StreamKind {
  const char* name;
  const char* encoder;  ///< ffmpeg's name
  const char* meaning;
  const char* pixelFormat;  ///< ffmpeg's name
  /// What ffmpeg is told besides quality and rate.
  std::vector<std::string> (*arguments)();
};
std::span<const StreamKind> streamKinds();
const StreamKind* findStreamKind(std::string_view name);
/// Those of films that are there as a whole, whose frames may wait for later ones: nothing for a stream.
std::span<const StreamKind> filmKinds();

/// How much a frame may cost: the constant rate factor of x264 and x265 (0 to 51, less is better), and at most so many
/// bytes a second, over a tenth of a second, where given.
struct StreamQuality {
  double rateFactor = 20;
  std::optional<double> maxBytesPerSecond{};
};

/// ffmpeg on the search path, with the encoder of a kind; the reason for messages where it is not.
class StreamEncoder {
 public:
  explicit StreamEncoder(const StreamKind& kind);

  const StreamKind& kind() const { return kind_; }
  bool isThere() const { return missing_.empty(); }
  /// "ffmpeg is not installed: apt-get install ffmpeg"
  const std::string& missing() const { return missing_; }

  struct Stream {
    std::vector<size_t> frameBytes;  ///< as many as the film has frames
    std::unique_ptr<UnnamedFile> file;

    size_t bytes() const;
  };
  /// Throws WorkError with what ffmpeg says. Width and height are even.
  Stream encode(const PathFilm& film, const StreamQuality& quality, const Progress& progress = {}) const;
  /// Frames of a stream, by their indices in rising order. Calls `sink` with each.
  void decode(const Stream& stream, const glm::ivec2& size, const std::vector<size_t>& frames,
              const std::function<void(size_t frame, const Image<Rgb8>& picture)>& sink) const;

 private:
  void run(const std::vector<std::string>& arguments, const Progress& progress) const;

  const StreamKind& kind_;
  std::optional<std::filesystem::path> program_;
  std::string missing_;
};

}  // namespace ocelli
