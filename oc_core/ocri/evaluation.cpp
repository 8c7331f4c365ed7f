#include "oc_core/ocri/evaluation.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

#include "oc_core/base/json_fields.h"
#include "oc_core/ocri/representation.h"
#include "oc_core/ocri/union_mesh.h"

namespace ocelli {
namespace {

double milliseconds(const std::function<void()>& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

/// A viewpoint with what the scene's own mesh shows there.
struct TruthFrame {
  PinholeCamera camera;
  Image<glm::vec4> points;
};

MissingSamples missingFrom(const Mesh& mesh, const std::vector<TruthFrame>& truth) {
  MissingSamples missing;
  for (const TruthFrame& frame : truth) {
    missing += countMissing(compareFrames(frame.camera, frame.points, positionImage(frame.camera, mesh)));
  }
  return missing;
}

double ratio(double value, double reference) {
  return reference > 0 ? value / reference : 0;
}

}  // namespace

std::vector<RepresentationFigures> evaluate(const Mesh& mesh, const std::vector<CameraChoice>& choices,
                                            const EvaluationOptions& options, const Progress& progress) {
  const auto cameraAt = [&](const View& view) { return PinholeCamera(view, options.width, options.height); };
  const PinholeCamera reference = cameraAt(options.view);
  const auto truthAt = [&](const std::vector<View>& views, const char* stage) {
    std::vector<TruthFrame> frames;
    for (const View& view : views) {
      report(progress, stage, static_cast<double>(frames.size()) / static_cast<double>(views.size()));
      frames.push_back({cameraAt(view), positionImage(cameraAt(view), mesh)});
    }
    return frames;
  };
  const std::vector<TruthFrame> edges = truthAt(options.cell.edgeViews(options.view), "truth, edges");
  const std::vector<TruthFrame> interior =
      truthAt(options.cell.interiorViews(options.view, options.interiorViews, options.seed), "truth, interior");
  const std::vector<TruthFrame> centre = truthAt({options.view}, "truth, reference");

  const auto measure = [&](const CameraChoice& choice) {
    RepresentationFigures figures;
    figures.name = choice.name;
    RepresentationTimes times;
    const Representation representation = buildRepresentation(choice, reference, mesh, progress, &times);
    figures.buildMilliseconds = times.buildMilliseconds;
    figures.meshMilliseconds = times.meshMilliseconds;
    if (options.slice) {
      figures.sliceMilliseconds = milliseconds([&] { options.slice(representation.mesh); });
    }
    figures.triangles = representation.mesh.triangles.size();
    figures.samples = representation.sampleCount();
    report(progress, choice.name, 0);
    figures.edges = missingFrom(representation.mesh, edges);
    figures.interior = missingFrom(representation.mesh, interior);
    figures.reference = missingFrom(representation.mesh, centre);
    report(progress, choice.name, 1);
    return figures;
  };

  std::vector<RepresentationFigures> rows(choices.size());
  std::transform(choices.begin(), choices.end(), rows.begin(), measure);
  // The ratios need the depth image, whether or not it was asked for.
  const Mesh depthMesh = unionMesh({buildDepthImage(reference, mesh)});
  const MissingSamples depth = missingFrom(depthMesh, edges);
  for (RepresentationFigures& row : rows) {
    row.strictRatioToDi = ratio(row.edges.strictRatio(), depth.strictRatio());
    row.thickRatioToDi = ratio(row.edges.thickRatio(), depth.thickRatio());
  }
  return rows;
}

std::string evaluationJson(const std::string& scene, const EvaluationOptions& options,
                           const std::vector<RepresentationFigures>& figures) {
  nlohmann::ordered_json json;
  json["scene"] = scene;
  json["view"] = nlohmann::ordered_json::parse(jsonText(options.view));
  json["size"] = {options.width, options.height};
  json["cell"] = {{"side_radii", options.cell.sideRadii}, {"interior_views", options.interiorViews}};
  json["seed"] = options.seed;
  json["representations"] = nlohmann::ordered_json::array();
  for (const RepresentationFigures& row : figures) {
    nlohmann::ordered_json entry;
    entry["name"] = row.name;
    entry["triangles"] = row.triangles;
    entry["samples"] = row.samples;
    entry["build_ms"] = row.buildMilliseconds;
    entry["mesh_ms"] = row.meshMilliseconds;
    entry["slice_ms"] = options.slice ? nlohmann::ordered_json(row.sliceMilliseconds) : nlohmann::ordered_json();
    entry["missing_strict"] = {{"edges", row.edges.strictRatio()},
                               {"interior", row.interior.strictRatio()},
                               {"reference", row.reference.strictRatio()}};
    entry["missing_thick"] = {{"edges", row.edges.thickRatio()},
                              {"interior", row.interior.thickRatio()},
                              {"reference", row.reference.thickRatio()}};
    entry["ratio_to_di"] = {{"strict", row.strictRatioToDi}, {"thick", row.thickRatioToDi}};
    json["representations"].push_back(entry);
  }
  return json.dump(2) + "\n";
}

std::string evaluationTable(const std::vector<RepresentationFigures>& figures) {
  std::string text = fmt::format("{:<14} {:>10} {:>9} {:>9} {:>8} {:>9}   {:^26}   {:^17}   {:^15}\n", "", "", "", "",
                                 "", "", "missing, strict", "missing, thick", "ratio to di");
  text += fmt::format("{:<14} {:>10} {:>9} {:>9} {:>8} {:>9}   {:>8} {:>8} {:>8}   {:>8} {:>8}   {:>7} {:>7}\n",
                      "camera", "triangles", "samples", "build ms", "mesh ms", "slice ms", "edges", "interior",
                      "at ref.", "edges", "interior", "strict", "thick");
  const auto percent = [](double ratio) { return fmt::format("{:.3f} %", 100 * ratio); };
  for (const RepresentationFigures& row : figures) {
    text += fmt::format(
        "{:<14} {:>10} {:>9} {:>9.1f} {:>8.1f} {:>9.1f}   {:>8} {:>8} {:>8}   {:>8} {:>8}   {:>7.3f} {:>7.3f}\n",
        row.name, row.triangles, row.samples, row.buildMilliseconds, row.meshMilliseconds, row.sliceMilliseconds,
        percent(row.edges.strictRatio()), percent(row.interior.strictRatio()), percent(row.reference.strictRatio()),
        percent(row.edges.thickRatio()), percent(row.interior.thickRatio()), row.strictRatioToDi, row.thickRatioToDi);
  }
  return text;
}

}  // namespace ocelli
