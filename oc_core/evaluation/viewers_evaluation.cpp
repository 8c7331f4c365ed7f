#include "oc_core/evaluation/viewers_evaluation.h"

#include <fmt/format.h>

#include <chrono>

#include "oc_core/base/json_fields.h"
#include "oc_core/ocri/union_mesh.h"

namespace ocelli {
namespace {

using Json = nlohmann::ordered_json;

size_t samplesOf(const ReferenceImages& images) {
  return Representation{{}, images, {}}.sampleCount();
}

RepresentationFigures measure(Evaluator& evaluator, const std::string& name, const Representation& representation,
                              const Progress& progress) {
  return evaluator.measure(
      name, [&](RepresentationTimes&) { return representation; }, progress);
}

std::string percentOf(double ratio) {
  return fmt::format("{:.3f} %", 100 * ratio);
}

template <class Ratio>
Json ratiosAtPlaces(const RepresentationFigures& row, Ratio ratio) {
  return {
      {"edges", (row.edges.*ratio)()}, {"interior", (row.interior.*ratio)()}, {"reference", (row.reference.*ratio)()}};
}

Json errorsJson(const RepresentationFigures& row) {
  return {{"triangles", row.triangles},
          {"missing_strict", ratiosAtPlaces(row, &FrameErrors::strictRatio)},
          {"missing_thick", ratiosAtPlaces(row, &FrameErrors::thickRatio)},
          {"wrong_front", ratiosAtPlaces(row, &FrameErrors::wrongFrontRatio)},
          {"false_skins", ratiosAtPlaces(row, &FrameErrors::falseSkinRatio)}};
}

}  // namespace

ViewersFigures evaluateViewers(const Mesh& scene, const CameraChoice& camera, const std::vector<View>& views,
                               const EvaluationOptions& options, const Progress& progress) {
  std::vector<Representation> own;
  std::vector<ReferenceImages> images;
  for (const View& view : views) {
    own.push_back(buildRepresentation(camera, {view, options.width, options.height}, scene, progress));
    images.push_back(own.back().images);
  }
  const auto start = std::chrono::steady_clock::now();
  MergedViewers merging = mergeViewers(std::move(images));
  Representation merged{camera.name, std::move(merging.images), {}};
  merged.mesh = unionMesh(merged.images);
  const std::chrono::duration<double, std::milli> time = std::chrono::steady_clock::now() - start;
  ViewersFigures figures{camera.name, merged.mesh.triangles.size(), samplesOf(merged.images), time.count(), {}};
  for (size_t i = 0; i < views.size(); ++i) {
    const std::string name = fmt::format("viewer {}", i + 1);
    EvaluationOptions his = options;
    his.view = views[i];
    Evaluator evaluator(scene, his);
    figures.viewers.push_back({views[i], merging.shares[i], measure(evaluator, name + ", own", own[i], progress),
                               measure(evaluator, name + ", merged", merged, progress)});
  }
  return figures;
}

std::string viewersTable(const ViewersFigures& figures) {
  std::string text =
      fmt::format("{} viewer{}, {}: {} triangles, {} samples\n", figures.viewers.size(),
                  figures.viewers.size() == 1 ? "" : "s", figures.camera, figures.triangles, figures.samples);
  text += fmt::format("{:>6} {:>17}   {:^17}   {:^17}   {:^17}   {:^17}   {:^17}\n", "", "samples", "strict, edges",
                      "strict, interior", "thick, edges", "wrong front", "false skins");
  text += fmt::format("{:>6} {:>8} {:>8}", "viewer", "built", "kept");
  for (int column = 0; column < 5; ++column) {
    text += fmt::format("   {:>8} {:>8}", "own", "merged");
  }
  text += "\n";
  int number = 1;
  for (const ViewerFigures& viewer : figures.viewers) {
    const auto both = [&](double own, double merged) {
      text += fmt::format("   {:>8} {:>8}", percentOf(own), percentOf(merged));
    };
    text += fmt::format("{:>6} {:>8} {:>8}", number++, viewer.samples.built, viewer.samples.kept);
    both(viewer.own.edges.strictRatio(), viewer.merged.edges.strictRatio());
    both(viewer.own.interior.strictRatio(), viewer.merged.interior.strictRatio());
    both(viewer.own.edges.thickRatio(), viewer.merged.edges.thickRatio());
    both(viewer.own.edges.wrongFrontRatio(), viewer.merged.edges.wrongFrontRatio());
    both(viewer.own.edges.falseSkinRatio(), viewer.merged.edges.falseSkinRatio());
    text += "\n";
  }
  return text;
}

std::string viewersJson(const std::string& scene, const EvaluationOptions& options, const ViewersFigures& figures) {
  Json json;
  json["scene"] = scene;
  json["camera"] = figures.camera;
  json["size"] = {options.width, options.height};
  json["cell"] = {{"side_radii", options.cell.sideRadii},
                  {"interior_views", options.interiorViews},
                  {"shape", cellShapeName(options.cell.shape)}};
  json["seed"] = options.seed;
  json["triangles"] = figures.triangles;
  json["samples"] = figures.samples;
  json["merge_ms"] = figures.mergeMilliseconds;
  json["viewers"] = Json::array();
  for (const ViewerFigures& viewer : figures.viewers) {
    json["viewers"].push_back({{"view", Json::parse(jsonText(viewer.view))},
                               {"samples_built", viewer.samples.built},
                               {"samples_kept", viewer.samples.kept},
                               {"own", errorsJson(viewer.own)},
                               {"merged", errorsJson(viewer.merged)}});
  }
  // A path need not be UTF-8.
  return textOfJson(json, 2) + "\n";
}

}  // namespace ocelli
