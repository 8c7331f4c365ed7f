#include "oc_core/relief/relief_kinds.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "oc_core/base/error.h"
#include "oc_core/base/number_text.h"
#include "oc_core/ocri/camera_choice.h"
#include "oc_core/ocri/representation_kind.h"
#include "oc_core/ocri/spoc_builder.h"
#include "oc_core/relief/height_field_relief.h"
#include "oc_core/relief/relief_clock.h"
#include "oc_core/relief/relief_view.h"
#include "oc_core/relief/sampled_relief.h"

namespace ocelli {
namespace {

/// A cell's images may have so many times the texels: it adds rows below those of the view from above.
constexpr double kCellTexels = 1.2;
/// Rows are added for what is seen from the eight corners of the cell. From more viewpoints, slivers come that take
/// more texels, in tiles of 16 x 16 pixels, than their samples are worth.
constexpr int kCellSatellites = 8;
constexpr float kAnyNumber = 64;  ///< of the samples of the view from above: texels are bounded here
constexpr int kMaxSteps = 4096;
constexpr int kMaxLayers = 16;

/// The number behind a name; nothing where there is another one, or no number from 1 to `most`.
std::optional<int> numberAfter(const std::string& name, const std::string& start, int most) {
  if (!name.starts_with(start)) {
    return std::nullopt;
  }
  const std::optional<int> number = numberFromText<int>(std::string_view(name).substr(start.size()));
  return number && *number >= 1 && *number <= most ? number : std::nullopt;
}

struct Conventional {
  ReliefSearch search;
  int layers = 1;
};

std::optional<Conventional> conventionalOf(const std::string& name) {
  if (name == "height-field") {
    return Conventional{};
  }
  if (const auto steps = numberAfter(name, "height-field-", kMaxSteps)) {
    return Conventional{{.linearSteps = *steps}, 1};
  }
  if (const auto layers = numberAfter(name, "layered-", kMaxLayers)) {
    return Conventional{{}, *layers};
  }
  return std::nullopt;
}

CameraChoice choiceOf(const std::string& name, const ViewCell& cell) {
  if (!name.ends_with(".json") && !findRepresentation(name)) {
    throw InputError("there is no \"" + name + "\" for relief tiles", "--by",
                     fmt::format("use traced, height-field, height-field-N for N from 1 to {}, layered-N for N from 1 "
                                 "to {}, or a camera of `ocelli camera list`",
                                 kMaxSteps, kMaxLayers));
  }
  const CameraChoice choice = cameraChoice(name, cell);
  if (!choice.hasImages()) {
    throw InputError("\"" + name + "\" is a mesh and has no image for relief tiles", "--by",
                     "use traced, height-field, layered-4, or a camera of `ocelli camera list`");
  }
  return choice;
}

size_t texelsOf(const ReferenceImages& images) {
  size_t texels = 0;
  for (const ReferenceImage& image : images) {
    texels += image.t.size();
  }
  return texels;
}

/// Images of a choice for a view of so many texels.
ReferenceImages imagesOf(const CameraChoice& choice, const Mesh& mesh, const ReliefViews& views,
                         const Progress& progress) {
  return buildReferenceImages(choice, PinholeCamera(views.reference, views.size.x, views.size.y), mesh, progress);
}

/// The image of a cell camera: half of its texels for the view from above, and as many samples of what that does not
/// see as fit below.
ReferenceImages cellImages(CameraChoice choice, const Mesh& mesh, size_t texels, const Progress& progress) {
  const Box bounds = boundsOf(mesh);
  const auto limit = static_cast<size_t>(kCellTexels * static_cast<double>(texels));
  ReferenceImages best;
  double share = 0.5;
  constexpr int kRounds = 6;
  for (int round = 0; round < kRounds; ++round) {
    const ReliefViews views =
        reliefViews(bounds, std::max<size_t>(1, static_cast<size_t>(share * static_cast<double>(texels))), true);
    const double own = static_cast<double>(views.size.x) * views.size.y;
    choice.cell.maxSamples = kAnyNumber;
    choice.cell.coarsestSpacing = 1;
    choice.cell.seamPixels = 2;
    choice.cell.maxSatellites = std::min(choice.cell.maxSatellites, kCellSatellites);
    ReferenceImages images = imagesOf(choice, mesh, views, progress);
    const size_t taken = texelsOf(images);
    if (taken <= limit && taken > texelsOf(best)) {
      best = std::move(images);
    }
    // What it takes grows with the texels of the view from above, about.
    const double wanted = 0.985 * static_cast<double>(limit) * own / static_cast<double>(std::max<size_t>(taken, 1));
    const double next = wanted / static_cast<double>(texels);
    if (std::abs(next - share) < 0.01 * share) {
      break;
    }
    share = std::min(next, 1.0);
  }
  return best;
}

ReferenceImages reliefImages(const std::string& name, const Mesh& mesh, size_t texels, const Progress& progress) {
  const Box bounds = boundsOf(mesh);
  const ReliefViews views = reliefViews(bounds, texels, false);
  const CameraChoice choice = choiceOf(name, views.cell);
  if (name == "spoc") {
    return {buildSpocImage(reliefSpoc(bounds, texels), mesh)};
  }
  if (choice.kind->name == std::string("cell")) {
    return cellImages(choice, mesh, texels, progress);
  }
  return imagesOf(choice, mesh, views, progress);
}

}  // namespace

void checkReliefKind(const std::string& name) {
  if (!conventionalOf(name)) {
    choiceOf(name, {});
  }
}

BuiltRelief buildReliefObject(const std::string& name, const Mesh& mesh, size_t texels, const Progress& progress) {
  checkReliefKind(name);
  BuiltRelief built{.name = name};
  auto start = std::chrono::steady_clock::now();
  const SurfaceLabels labels(mesh);
  if (const auto conventional = conventionalOf(name)) {
    const Box bounds = boundsOf(mesh);
    const glm::ivec2 size = bounds.empty() ? glm::ivec2(1)
                                           : imageSizeFor(static_cast<double>(bounds.size().x),
                                                          static_cast<double>(bounds.size().z), texels);
    built.object = std::make_shared<HeightFieldRelief>(orthographicLayers(labels, size.x, size.y, conventional->layers),
                                                       conventional->search);
    built.buildMilliseconds = millisecondsSince(start);
    return built;
  }
  const ReferenceImages images =
      mesh.empty() ? ReferenceImages{} : reliefImages(name, labels.labelledMesh(), texels, progress);
  built.buildMilliseconds = millisecondsSince(start);
  start = std::chrono::steady_clock::now();
  built.object = std::make_shared<SampledRelief>(images, labels);
  built.structureMilliseconds = millisecondsSince(start);
  return built;
}

}  // namespace ocelli
