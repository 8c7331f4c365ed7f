// Everything that differs between the truth and a representation, seen from one viewpoint, and its sums over several.
#pragma once

#include "oc_core/evaluation/false_surfaces.h"
#include "oc_core/image/png_file.h"

namespace ocelli {

/// What is seen from a viewpoint: points in space, and the image of them on black.
struct ViewFrame {
  Image<glm::vec4> points;  ///< world, w = 1 where something is seen
  Image<Rgb8> image;        ///< sRGB
};

ViewFrame renderFrame(const PinholeCamera& camera, const Mesh& mesh);
/// The same of what is no mesh.
ViewFrame renderFrame(const PinholeCamera& camera, const RayTarget& target);

/// The maps of coverage.h and false_surfaces.h.
struct FrameComparison {
  Image<SampleState> states;
  Image<uint8_t> wrongFronts;
  Image<uint8_t> falseSkins;
};

/// `scene` holds the mesh that `truth` shows.
FrameComparison compareViewFrames(const PinholeCamera& camera, const ViewFrame& truth, const ViewFrame& frame,
                                  const RayScene& scene);
/// The same of any scene (false_surfaces.h).
FrameComparison compareViewFrames(const PinholeCamera& camera, const ViewFrame& truth, const ViewFrame& frame,
                                  const SurfaceSearch& hasSurfaceNear);

/// Sums over viewpoints; the ratios and means of them weigh samples, or viewpoints, alike.
struct FrameErrors : MissingSamples {
  size_t wrongFront = 0;  ///< of the truth samples
  size_t frame = 0;       ///< frame samples
  size_t falseSkin = 0;   ///< of the frame samples
  size_t images = 0;      ///< viewpoints whose images were compared, and sums over them:
  double squaredError = 0;
  double ssim = 0;
  double flip = 0;

  FrameErrors& operator+=(const FrameErrors& other);
  double wrongFrontRatio() const { return mean(static_cast<double>(wrongFront), truth); }
  double falseSkinRatio() const { return mean(static_cast<double>(falseSkin), frame); }
  /// Of the mean squared error over all viewpoints, dB: infinite where no pixel differs, 0 where nothing was compared.
  double meanPsnrDecibels() const;
  double meanSsim() const { return mean(ssim, images); }
  double meanFlip() const { return mean(flip, images); }

 private:
  static double mean(double sum, size_t count) { return count > 0 ? sum / static_cast<double>(count) : 0; }
};

/// Of one viewpoint, without its image.
FrameErrors countErrors(const FrameComparison& comparison, const ViewFrame& frame);
/// Adds how the images of one viewpoint differ.
void addImageErrors(FrameErrors& errors, const ViewFrame& truth, const ViewFrame& frame);

}  // namespace ocelli
