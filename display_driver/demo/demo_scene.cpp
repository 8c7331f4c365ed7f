#include "display_driver/demo/demo_scene.h"

#include <fmt/format.h>

#include <array>
#include <chrono>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "display_driver/demo/demo_folder.h"
#include "display_driver/devices/coarse_frames.h"
#include "display_driver/wire/bandwidth_plan.h"
#include "display_sim/observing/observer.h"
#include "display_sim/slicing/slicer.h"
#include "oc_core/base/error.h"
#include "oc_core/image/color.h"
#include "oc_core/ocri/image_mesh.h"
#include "oc_core/ocri/resample.h"
#include "oc_core/page/html.h"
#include "oc_core/render/rasterize.h"
#include "oc_core/worlds/scene_source.h"

namespace ocelli {
namespace {

constexpr float kLeftRadii = 0.8f;               // 4 in at the reference display
constexpr glm::vec3 kSideEye{9.6f, 2.4f, 1.4f};  // from the right, a little above: Figure 3.48's side view
constexpr glm::vec3 kBackground{0.012f, 0.014f, 0.02f};
// Vermilion and yellow of the palette of Okabe and Ito: they differ in lightness, to every kind of colour vision.
const glm::vec3 kMissing = linearFromSrgb({0.835f, 0.369f, 0.0f});
const glm::vec3 kMissingThick = linearFromSrgb({0.941f, 0.894f, 0.259f});
constexpr float kDimmed = 0.4f;
constexpr float kDetailExtent = 0.5f;  // of the general pinhole's region, shares of its image
constexpr float kDetailZoom = 4;

// A mesh that stands for the scene, and how the page names it.
struct ShownMesh {
  std::string id;
  std::string name;
  const Mesh* mesh;
};

Image<glm::vec3> imageOf(const ReferenceImage& image) {
  Image<glm::vec3> shown = image.color;
  for (size_t i = 0; i < shown.size(); ++i) {
    if (image.t[i] <= 0) {
      shown[i] = kBackground;
    }
  }
  return shown;
}

Image<glm::vec3> imageOf(const Mesh& mesh, const PinholeCamera& camera) {
  return colorImage(rasterize(camera, mesh), mesh, kBackground);
}

// Grey and dim, so that what is missing stands out.
Image<glm::vec3> markMissing(Image<glm::vec3> image, const Image<SampleState>& states) {
  for (size_t i = 0; i < image.size(); ++i) {
    switch (states[i]) {
      case SampleState::kMissing:
        image[i] = kMissing;
        break;
      case SampleState::kMissingThick:
        image[i] = kMissingThick;
        break;
      case SampleState::kNoTruth:
      case SampleState::kPresent:
        image[i] = glm::vec3(kDimmed * glm::dot(image[i], glm::vec3(0.2126f, 0.7152f, 0.0722f)));
        break;
    }
  }
  return image;
}

DemoRow referenceRow(const DemoFolder& folder, const ReferenceImage& di, const ReferenceImage& ddoc) {
  return {
      "The reference images",
      "Both are taken from the same place. The rays of the occlusion camera are bent around silhouettes, so its image "
      "also holds what lies just behind them, in the same number of pixels.",
      {folder.write("reference-ppc", imageOf(di), "Pinhole camera (PPC)",
                    "The depth image: " + groupedDigits(di.sampleCount()) + " samples."),
       folder.write("reference-ddoc", imageOf(ddoc), "Occlusion camera (DDOC)",
                    "The OCRI: " + groupedDigits(ddoc.sampleCount()) + " samples in one layer.")}};
}

// Section 5.2.1: the same number of samples, more of them where someone will look closer.
DemoRow detailRow(const DemoFolder& folder, const ReferenceImage& di, const Mesh& geometry,
                  const PinholeCamera& reference) {
  CameraChoice choice = cameraChoice("gpc");
  choice.gpc.regions = {{.extent = glm::vec2(kDetailExtent), .zoom = kDetailZoom}};
  View closer = reference.view();
  const double halfAngle = glm::radians(closer.resolvedFovVerticalDegrees() / 2);
  // The view that looks at the region alone.
  const double shown = static_cast<double>(kDetailExtent) / static_cast<double>(kDetailZoom);
  closer.fovVerticalDegrees = 2 * glm::degrees(std::atan(shown * std::tan(halfAngle)));
  const PinholeCamera camera(closer, reference.width(), reference.height());
  const ReferenceImages gpc = buildReferenceImages(choice, reference, geometry);
  return {
      "Detail where it is wanted: a general pinhole",
      fmt::format(
          "The middle of the view, {:.0f} times closer, from images of equally many samples. The general pinhole "
          "(GPC) has {:.0f} times as many of them along either axis there, and fewer around: nothing is sent again "
          "when someone zooms in. With ocelli remote serve, browsers look at scenes by such images.",
          1 / shown, kDetailZoom),
      {folder.write("detail-di", resample({di}, camera).color, "Depth image", "As its own samples show it."),
       folder.write("detail-gpc", resample(gpc, camera).color, "General pinhole", "From an image of the same size."),
       folder.write("detail-geometry", imageOf(geometry, camera), "Full geometry", "Drawn at this view.")}};
}

DemoRow leftRow(const DemoFolder& folder, const std::vector<ShownMesh>& representations, const PinholeCamera& camera) {
  DemoRow row{"From 4 in to the left",
              "The head has moved; the data has not. The meshes of both reference images, seen from there.",
              {}};
  for (const ShownMesh& each : representations) {
    row.images.push_back(folder.write("left-" + each.id, imageOf(*each.mesh, camera), each.name,
                                      groupedDigits(each.mesh->triangles.size()) + " triangles."));
  }
  return row;
}

DemoRow missingRow(const DemoFolder& folder, const std::vector<ShownMesh>& representations, const Mesh& truth,
                   const PinholeCamera& camera) {
  DemoRow row{
      "What is missing there",
      "Samples of the full geometry that the mesh does not show: orange, and yellow in holes of three pixels or "
      "more.",
      {}};
  const Image<glm::vec4> truthPositions = positionImage(camera, truth);
  const Image<glm::vec3> truthImage = imageOf(truth, camera);
  for (const ShownMesh& each : representations) {
    if (each.mesh == &truth) {
      continue;
    }
    const Image<SampleState> states = compareFrames(camera, truthPositions, positionImage(camera, *each.mesh));
    const MissingSamples missing = countMissing(states);
    row.images.push_back(folder.write("left-missing-" + each.id, markMissing(truthImage, states), each.name,
                                      fmt::format("{:.2f} % of the samples are missing, {:.2f} % in larger holes.",
                                                  100 * missing.strictRatio(), 100 * missing.thickRatio())));
  }
  return row;
}

DemoRow sideRow(const DemoFolder& folder, const std::vector<ShownMesh>& representations, const PinholeCamera& side) {
  DemoRow row{
      "From the side: what the camera does not see",
      "No viewer in front of the display gets here; it shows what was left out. Behind the object, the depth image "
      "has no samples: its disocclusion region. The OCRI shrinks that region, and leaves out what no nearby view "
      "needs.",
      {}};
  for (const ShownMesh& each : representations) {
    row.images.push_back(folder.write("side-" + each.id, imageOf(*each.mesh, side), each.name, ""));
  }
  return row;
}

// The OCRI's volume as the link to a display brings it.
DemoRow wireRow(const DemoFolder& folder, const Volume& volume, const DemoOptions& options) {
  DemoRow row{
      "As it reaches the display",
      "Slices travel coarse to fine over the angle. Where the link is cut, or the frame comes late, what has come "
      "is a coarse volume, not half of one.",
      {}};
  ObserverOptions observer;
  observer.width = options.observedSide;
  observer.height = options.observedSide;
  observer.tone.gain = automaticGain(collectLight(volume, observer));
  for (const CoarseFrame& frame : coarseFrames(volume, std::array{1.0 / 16, 1.0 / 4, 1.0})) {
    row.images.push_back(
        folder.write(fmt::format("wire-{}", frame.slices), observe(frame.shown, observer),
                     fmt::format("{} of {} slices", frame.slices, volume.slices()),
                     fmt::format("{} KB have come: {:.1f} ms of USB 2.", groupedDigits(frame.bytes / 1000),
                                 1e3 * static_cast<double>(frame.bytes) / wire::kUsb2BytesPerSecond)));
  }
  return row;
}

// Every representation with the same gain: one that suits the OCRI.
DemoRow displayRow(const DemoFolder& folder, const std::vector<ShownMesh>& representations,
                   const std::vector<Volume>& volumes, const DemoOptions& options) {
  DemoRow row{
      "On the display, from the front",
      "Simulated light of every lit voxel, all with the same exposure. The display emits and hides nothing: the full "
      "geometry also shows its back and inner sides, which the reference images left out. What the OCRI keeps of them "
      "shines through along the silhouettes.",
      {}};
  ObserverOptions observer;
  observer.width = options.observedSide;
  observer.height = options.observedSide;
  observer.tone.gain = automaticGain(collectLight(volumes[1], observer));
  for (size_t i = 0; i < volumes.size(); ++i) {
    row.images.push_back(folder.write("display-front-" + representations[i].id, observe(volumes[i], observer),
                                      representations[i].name, groupedDigits(volumes[i].litVoxels()) + " lit voxels."));
  }
  return row;
}

// Of the same volumes, in the order of the page: what hides nothing first. Adds the figures to the scene.
DemoRow solidityRow(const DemoFolder& folder, const std::vector<ShownMesh>& representations,
                    const std::vector<Volume>& volumes, const Mesh& truth, const DemoOptions& options,
                    const View& reference, const View& left, DemoScene& scene, const Progress& progress) {
  DemoRow row{
      "How solid it looks, from 4 in to the left",
      "First what an opaque scene looks like from there, then what is seen of the display, each at the exposure that "
      "suits "
      "it best. With the full geometry, whatever is behind an object shines through it. The depth image leaves that "
      "out, "
      "but beside each object its disocclusion region stays dark. The OCRI fills that region, at the price of some "
      "light along "
      "silhouettes: little for most scenes, much for a fence, which is all silhouettes.",
      {}};
  scene.solidityEyes = {"in front", "to the left"};
  SolidityMeter meter(truth, {.profile = options.profile,
                              .groups = {{scene.solidityEyes[0], {reference.eye}}, {scene.solidityEyes[1], {left.eye}}},
                              .imageSide = options.profile.height / 2});
  for (const size_t i : {2, 0, 1}) {
    const ShownMesh& shown = representations[i];
    Image<Rgb8> opaque;
    Image<Rgb8> observed;
    scene.solidity.push_back(meter.measure(shown.name, volumes[i], shown.mesh->triangles.size(),
                                           SolidityMeter::Shown::kEverything, progress,
                                           [&](const ObservedFrame& frame) {
                                             opaque = frame.opaque;
                                             observed = frame.observed;
                                           }));
    if (row.images.empty()) {
      row.images.push_back(folder.write("solid-opaque", opaque, "Opaque", "As it should look."));
    }
    row.images.push_back(folder.write("solid-" + shown.id, observed, shown.name,
                                      fmt::format("{:.1f} % of the light should be hidden.",
                                                  100 * scene.solidity.back().groups.back().hiddenShare())));
  }
  return row;
}

double millisecondsSince(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace

DemoScene runDemoScene(const std::string& title, const std::string& source, const std::filesystem::path& folder,
                       const std::string& name, const DemoOptions& options, const Progress& progress) {
  DemoScene scene{title, source, {}, 0, 0, {}, {}, {}};
  const DemoFolder images(folder, name);
  const Mesh geometry = loadScene(source, {}, progress);
  const View view;
  const PinholeCamera reference(view, options.width, options.height);
  const ReferenceImage di = buildReferenceImages(cameraChoice("di"), reference, geometry, progress).front();
  const ReferenceImage ddoc = buildReferenceImages(cameraChoice("ddoc"), reference, geometry, progress).front();
  const Mesh diMesh = imageMesh(di);
  const Mesh ddocMesh = imageMesh(ddoc);
  const std::vector<ShownMesh> representations{
      {"di", "Depth image", &diMesh}, {"ddoc", "OCRI", &ddocMesh}, {"geometry", "Full geometry", &geometry}};

  scene.rows.push_back(referenceRow(images, di, ddoc));
  scene.rows.push_back(detailRow(images, di, geometry, reference));
  const PinholeCamera left(movedEye(view, {-kLeftRadii, 0, 0}), options.width, options.height);
  scene.rows.push_back(leftRow(images, representations, left));
  scene.rows.push_back(missingRow(images, representations, geometry, left));
  View sideView;
  sideView.eye = kSideEye;
  scene.rows.push_back(sideRow(images, representations, PinholeCamera(sideView, options.width, options.height)));

  std::vector<Volume> volumes;
  for (const ShownMesh& each : representations) {
    report(progress, "slicing", static_cast<double>(volumes.size()) / static_cast<double>(representations.size()));
    const auto start = std::chrono::steady_clock::now();
    volumes.push_back(slice(*each.mesh, options.profile));
    scene.geometrySliceMilliseconds = millisecondsSince(start);  // the last one is the geometry
  }
  scene.geometryTriangles = geometry.triangles.size();
  report(progress, "observing", 0);
  scene.rows.push_back(displayRow(images, representations, volumes, options));
  scene.rows.push_back(wireRow(images, volumes[1], options));
  scene.rows.push_back(
      solidityRow(images, representations, volumes, geometry, options, view, left.view(), scene, progress));

  EvaluationOptions evaluation;
  evaluation.view = view;
  evaluation.width = options.width;
  evaluation.height = options.height;
  evaluation.slice = [&options](const Mesh& mesh) { slice(mesh, options.profile); };
  std::vector<CameraChoice> cameras;
  for (const char* camera : {"di", "ddoc", "ddoc-constant", "eoc-hv", "cell"}) {
    cameras.push_back(cameraChoice(camera));
  }
  scene.figures = evaluate(geometry, cameras, evaluation, progress);
  return scene;
}

}  // namespace ocelli
