// How long the image of a graph camera from video takes, beside what OpenCV does with the same frames in the same run:
// a grid of panes (cv::resize), and the same image by cv::remap, which shows each subject as often as feeds see it.
//
// Takes a folder that `ocelli feeds simulate` wrote. Frames are read before; times are means over them, the least of
// --runs runs.
#include <array>
#include <atomic>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "bench/bench_program.h"
#include "bench/timing.h"
#include "oc_core/feeds_live/feed_composer.h"
#include "oc_core/feeds_video/video_reader.h"

namespace ocelli {
namespace {

struct FeedsBenchChoice {
  std::string folder;
  int frames = 60;
  int runs = 3;
  int threads = 0;
};

using FeedFrames = std::vector<Image<Rgb8>>;  ///< one of each feed

cv::Mat viewOf(const Image<Rgb8>& image) {
  return {image.height(), image.width(), CV_8UC3, const_cast<Rgb8*>(image.data())};
}

/// The nth frames of all feeds together, whatever their clocks say.
std::vector<FeedFrames> readFrames(const FeedSetup& setup, int count) {
  std::vector<FeedFrames> frames(static_cast<size_t>(count));
  const std::atomic<bool> stop{false};
  for (const Feed& feed : setup.feeds) {
    VideoReader reader({feed.source, feed.width, feed.height, feed.framesPerSecond, feed.ffmpegOptions}, 10, stop);
    for (FeedFrames& frame : frames) {
      VideoFrame read;
      if (!reader.next(read)) {
        throw InputError("the feed has too few frames", feed.source, "give --frames, or simulate more seconds");
      }
      frame.push_back(std::move(read.image));
    }
  }
  return frames;
}

/// The peers, of as many threads as OpenCV takes.
class OpenCvPeers {
 public:
  explicit OpenCvPeers(const FeedGraph& graph) : feeds_(graph.setup().feeds.size()), frusta_(graph.frusta()) {
    const FeedOutput& output = graph.setup().output;
    image_ = cv::Mat(output.height, output.width, CV_8UC3, cv::Scalar(0));
    std::vector<cv::Mat> maps;
    for (size_t i = 0; i < frusta_; ++i) {
      maps.emplace_back(output.height, output.width, CV_32FC2, cv::Scalar(-1, -1));
      masks_.emplace_back(output.height, output.width, CV_8U, cv::Scalar(0));
      feedOf_.push_back(graph.feedIndexOf(i));
    }
    for (int y = 0; y < output.height; ++y) {
      for (int x = 0; x < output.width; ++x) {
        const size_t frustum = graph.chainAt({x + 0.5, y + 0.5}).back();
        if (const auto at = graph.feedPixelAt(frustum, {x + 0.5, y + 0.5})) {
          maps[frustum].at<cv::Vec2f>(y, x) = {static_cast<float>(at->x - 0.5), static_cast<float>(at->y - 0.5)};
          masks_[frustum].at<uint8_t>(y, x) = 255;
        }
      }
    }
    places_.resize(frusta_);
    fractions_.resize(frusta_);
    for (size_t i = 0; i < frusta_; ++i) {
      parts_.push_back(cv::boundingRect(masks_[i]));
      cv::convertMaps(maps[i](parts_[i]), {}, places_[i], fractions_[i], CV_16SC2);
    }
  }

  void panes(const FeedFrames& frames) {
    const auto columns = static_cast<int>(std::ceil(std::sqrt(static_cast<double>(feeds_))));
    const int rows = (static_cast<int>(feeds_) + columns - 1) / columns;
    const cv::Size pane(image_.cols / columns, image_.rows / rows);
    for (int i = 0; i < static_cast<int>(feeds_); ++i) {
      cv::Mat at = image_({i % columns * pane.width, i / columns * pane.height, pane.width, pane.height});
      cv::resize(viewOf(frames[static_cast<size_t>(i)]), at, pane, 0, 0, cv::INTER_AREA);
    }
  }

  void remapped(const FeedFrames& frames) {
    for (size_t i = 0; i < frusta_; ++i) {
      cv::remap(viewOf(frames[feedOf_[i]]), part_, places_[i], fractions_[i], cv::INTER_LINEAR);
      cv::Mat at = image_(parts_[i]);
      part_.copyTo(at, masks_[i](parts_[i]));
    }
  }

 private:
  size_t feeds_;
  size_t frusta_;
  std::vector<size_t> feedOf_;
  std::vector<cv::Rect> parts_;  ///< of the image, around what each frustum shows
  std::vector<cv::Mat> places_;
  std::vector<cv::Mat> fractions_;
  std::vector<cv::Mat> masks_;
  cv::Mat part_;
  cv::Mat image_;
};

void measure(const FeedsBenchChoice& choice) {
  cv::setNumThreads(threadCount());
  const FeedSetup setup = readFeedSetup(std::filesystem::path(choice.folder) / "setup.json");
  const FeedGraph graph(setup);
  const std::vector<FeedFrames> frames = readFrames(setup, choice.frames);
  const auto eachFrame = [&](const auto& work) {
    return leastMilliseconds(choice.runs,
                             [&] {
                               for (const FeedFrames& frame : frames) {
                                 work(frame);
                               }
                             }) /
           choice.frames;
  };
  OpenCvPeers peers(graph);
  const double panes = eachFrame([&](const FeedFrames& frame) { peers.panes(frame); });
  const double remapped = eachFrame([&](const FeedFrames& frame) { peers.remapped(frame); });
  const FeedMap map(graph);
  Image<Rgb8> image;
  const double plain = eachFrame([&](const FeedFrames& frame) {
    std::vector<FeedPicture> pictures;
    for (size_t i = 0; i < graph.frusta(); ++i) {
      pictures.push_back({&frame[graph.feedIndexOf(i)]});
    }
    composeFeeds(map, pictures, ErasedLook::kBackground, image);
  });
  FeedComposer composer(graph);
  double seconds = 0;
  double composing = 0;
  const double all = eachFrame([&](const FeedFrames& frame) {
    FeedFrames taken = frame;
    composer.take(taken);
    composing += milliseconds([&] { composer.compose(seconds += 1.0 / 30, ErasedLook::kBackground, image); });
  });
  composing /= choice.frames * (choice.runs + 1.0);
  fmt::print("{} feeds of {}x{}, image of {}x{}, {} threads, {} frames, best of {} runs\n\n", setup.feeds.size(),
             setup.feeds[0].width, setup.feeds[0].height, setup.output.width, setup.output.height, threadCount(),
             choice.frames, choice.runs);
  fmt::print("{:<44} {:>8} {:>9}\n", "", "ms", "x remap");
  const auto row = [&](const char* name, double time) {
    fmt::print("{:<44} {:>8.2f} {:>9.2f}\n", name, time, time / remapped);
  };
  row("OpenCV: panes", panes);
  row("OpenCV: remap, each subject where feeds see it", remapped);
  row("the same image by the composer", plain);
  row("with subjects: all, without reading", all);
  row("  of it, who is who, and the image (mean)", composing);
}

int run(int argumentCount, char** arguments) {
  CLI::App program("The image of a graph camera from video, beside what OpenCV makes of the same frames.",
                   "feeds_bench");
  FeedsBenchChoice choice;
  program.add_option("folder", choice.folder, "A folder that `ocelli feeds simulate` wrote")->required();
  program.add_option("--frames", choice.frames, "Of each feed")->check(CLI::Range(1, 10000))->capture_default_str();
  program.add_option("--runs", choice.runs, "Runs a figure")->check(CLI::Range(1, 1000))->capture_default_str();
  program.add_option("--threads", choice.threads, "0 stands for all cores")->check(CLI::Range(0, 1024));
  return runProgram(program, argumentCount, arguments, choice, measure);
}

}  // namespace
}  // namespace ocelli

int main(int argumentCount, char** arguments) {
  return ocelli::run(argumentCount, arguments);
}
