// Remote visualisation measured (section 5.3.1.3): one path over several links, with images that the client draws from,
// with compressed frames and with streams of video; what each shows is compared with what should be seen at that
// moment.
//
// So latency counts as an error, and so does the time before the first picture, in which the screen is black: all modes
// are judged at the same frames of the path. Beside it stands, for peers, the error without latency: of each frame that
// was shown against the view that it is of.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "oc_core/base/progress.h"
#include "oc_core/remote_measure/image_play.h"
#include "oc_core/remote_measure/rate_curve.h"

namespace ocelli {

struct RemoteMeasureOptions {
  std::string scene;  ///< what reports call it
  RemotePath path;
  glm::ivec2 screen{1280, 720};
  RemoteSettings settings;
  ClientRule rule;
  int truthSamples = 3;  ///< rays along either axis of a pixel of what should be seen
  std::vector<LinkSpeed> links = defaultLinks();
  std::vector<std::string> modes;  ///< names of remoteModes(), in the order of the report
  std::vector<double> jpegQualities{10, 50, 90};
  std::vector<double> rateFactors{14, 20, 26, 32, 38};  ///< of the curves that compare bytes at equal error
  double streamFactor = 20;                             ///< of streams over a link, as far as it carries that
  size_t every = 15;                                    ///< one of so many frames is judged
  std::optional<double> serverSeconds{};                ///< to draw and encode an image; nothing: what it takes
  std::optional<double> clientSeconds{};                ///< to draw a picture; nothing: what it takes
  std::optional<double> decodeSeconds{};                ///< to decode a message; nothing: what it takes
  double peerSeconds = 0.01;                            ///< to draw and encode a frame
};

struct RemoteModeName {
  std::string name;
  std::string meaning;
};
/// Images (image_play.h), "jpeg", and streams (video_stream.h).
std::vector<RemoteModeName> remoteModes();

/// Errors of the pictures that were judged.
struct PictureErrors {
  std::vector<double> flips;  ///< means over each picture
  double squaredErrors = 0;   ///< sum of their means

  void add(double flip, double squaredError);
  double meanFlip() const;
  double flip95() const;  ///< 95 % of them are no worse
  /// Of the mean of the squared errors.
  double psnrDecibels() const;
};

struct ModeFigures {
  std::string mode;     ///< of remoteModes()
  std::string variant;  ///< "quality 50, asked"; empty where there is one
  LinkSpeed link;
  size_t bytes = 0;
  size_t images = 0;
  std::optional<double> firstPictureSeconds{};  ///< nothing: no picture came, and no error is known
  double viewsPerSecond = 0;
  double meanLagSeconds = 0;
  double clientFrameSeconds = 0;
  double clientDecodeSeconds = 0;
  double covered = 1;
  StallFigures stalls;
  StallFigures coveredStalls;  ///< of views that the client's image covers
  PictureErrors shown;
  size_t blackFrames = 0;                ///< of those judged: the first ones, before the first picture
  PictureErrors withoutLatency;          ///< of frames and streams alone
  std::vector<double> lags;              ///< of each frame of the path, seconds
  std::vector<size_t> judged;            ///< frames of the path, as shown.flips
  std::map<size_t, Image<Rgb8>> kept{};  ///< pictures at some moments, over the first link

  /// Mean FLIP since the first picture; 0 where none was judged.
  double pictureFlip() const;
  std::string name() const { return variant.empty() ? mode : mode + " " + variant; }
};

struct StreamCurve {
  std::string mode;
  std::vector<RatePoint> points;
  std::vector<std::vector<double>> flips;  ///< of each point, of each frame of the path that is judged
};

struct RemoteMeasurement {
  std::vector<ModeFigures> rows;
  std::vector<StreamCurve> curves;
  std::vector<std::string> leftOut;  ///< peers that could not be measured, and why
  std::vector<size_t> moments;       ///< frames whose pictures were kept
  std::map<size_t, Image<Rgb8>> truth{};
  double equalSize = 0;  ///< of plain images, pixels by those of the screen; 0 where none was measured
};

/// Throws InputError for an unknown mode, and where there is no link, no mode or no frame.
RemoteMeasurement measureRemote(const RemoteScene& scene, const RemoteMeasureOptions& options,
                                const Progress& progress = {});

/// The bytes on the wire that a stream of this codec takes where its error without latency is pictureFlip() of the row,
/// over the same frames: nothing beyond its curve, and where the row has no picture.
std::optional<double> bytesOfEqualStream(const RemoteMeasurement& measurement, const std::string& mode,
                                         const ModeFigures& row);

}  // namespace ocelli
