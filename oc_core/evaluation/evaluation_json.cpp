#include "oc_core/evaluation/evaluation_json.h"

#include <cmath>

#include "oc_core/base/json_fields.h"

namespace ocelli {
namespace {

using Json = nlohmann::ordered_json;

/// Infinity has no JSON form.
Json numberOrNull(double value, bool known) {
  return known && std::isfinite(value) ? Json(value) : Json();
}

/// `value(errors)` at each place.
template <class Value>
Json atPlaces(const RepresentationFigures& row, const Value& value) {
  return {{"edges", value(row.edges)}, {"interior", value(row.interior)}, {"reference", value(row.reference)}};
}

Json cellJson(const EvaluationOptions& options) {
  Json cell;
  cell["side_radii"] = options.cell.sideRadii;
  cell["interior_views"] = options.interiorViews;
  if (options.cell.shape == ViewCell::Shape::kCube) {
    cell["edge_views"] = options.edgeViews;
  }
  cell["shape"] = cellShapeName(options.cell.shape);
  if (options.cell.shape == ViewCell::Shape::kSegment) {
    const glm::vec3& direction = options.cell.segmentDirection;
    cell["segment_direction"] = {direction.x, direction.y, direction.z};
  }
  return cell;
}

/// Each measure along each edge of a cube, corner to corner.
Json alongEdges(const RepresentationFigures& row, const EvaluationOptions& options) {
  Json edges = Json::array();
  if (row.edgeViews.empty()) {
    return edges;
  }
  for (const EdgeSequence& sequence : options.cell.edgeSequences(options.edgeViews)) {
    Json edge{{"from", Json::array()},          {"to", Json::array()},          {"missing_strict", Json::array()},
              {"missing_thick", Json::array()}, {"wrong_front", Json::array()}, {"false_skins", Json::array()}};
    for (int axis = 0; axis < 3; ++axis) {
      edge["from"].push_back(sequence.places.front()[axis]);
      edge["to"].push_back(sequence.places.back()[axis]);
    }
    for (const size_t view : sequence.views) {
      const FrameErrors& errors = row.edgeViews.at(view);
      edge["missing_strict"].push_back(errors.strictRatio());
      edge["missing_thick"].push_back(errors.thickRatio());
      edge["wrong_front"].push_back(errors.wrongFrontRatio());
      edge["false_skins"].push_back(errors.falseSkinRatio());
    }
    edges.push_back(edge);
  }
  return edges;
}

Json rowJson(const RepresentationFigures& row, const EvaluationOptions& options) {
  Json entry;
  entry["name"] = row.name;
  entry["triangles"] = row.triangles;
  entry["samples"] = row.samples;
  entry["build_ms"] = row.buildMilliseconds;
  entry["mesh_ms"] = row.meshMilliseconds;
  entry["slice_ms"] = numberOrNull(row.sliceMilliseconds, static_cast<bool>(options.slice));
  entry["missing_strict"] = atPlaces(row, [](const FrameErrors& errors) { return errors.strictRatio(); });
  entry["missing_thick"] = atPlaces(row, [](const FrameErrors& errors) { return errors.thickRatio(); });
  entry["ratio_to_di"] = {{"strict", row.strictRatioToDi}, {"thick", row.thickRatioToDi}};
  entry["wrong_front"] = atPlaces(row, [](const FrameErrors& errors) { return errors.wrongFrontRatio(); });
  entry["false_skins"] = atPlaces(row, [](const FrameErrors& errors) { return errors.falseSkinRatio(); });
  entry["psnr_db"] = atPlaces(
      row, [](const FrameErrors& errors) { return numberOrNull(errors.meanPsnrDecibels(), errors.images > 0); });
  entry["ssim"] =
      atPlaces(row, [](const FrameErrors& errors) { return numberOrNull(errors.meanSsim(), errors.images > 0); });
  entry["flip"] =
      atPlaces(row, [](const FrameErrors& errors) { return numberOrNull(errors.meanFlip(), errors.images > 0); });
  entry["pixels"] = row.pixels;
  entry["bytes"] = {{"raw", row.bytes.raw}, {"zstd", row.bytes.compressed}};
  entry["along_edges"] = alongEdges(row, options);
  Json curve{{"missing_strict", Json::array()},
             {"missing_thick", Json::array()},
             {"wrong_front", Json::array()},
             {"false_skins", Json::array()}};
  for (const FrameErrors& errors : row.offsets) {
    curve["missing_strict"].push_back(errors.strictRatio());
    curve["missing_thick"].push_back(errors.thickRatio());
    curve["wrong_front"].push_back(errors.wrongFrontRatio());
    curve["false_skins"].push_back(errors.falseSkinRatio());
  }
  entry["at_offsets"] = curve;
  return entry;
}

}  // namespace

std::string evaluationJson(const std::string& scene, const EvaluationOptions& options,
                           const std::vector<RepresentationFigures>& figures, bool complete) {
  Json json;
  json["scene"] = scene;
  json["view"] = Json::parse(jsonText(options.view));
  json["size"] = {options.width, options.height};
  json["cell"] = cellJson(options);
  json["seed"] = options.seed;
  json["representations"] = Json::array();
  for (const RepresentationFigures& row : figures) {
    json["representations"].push_back(rowJson(row, options));
  }
  json["offsets"] = {{"half_sides", options.offsets},
                     {"directions", options.cell.directions(options.offsetDirections, options.seed).size()}};
  json["runs"] = options.runs;
  json["complete"] = complete;
  // A path need not be UTF-8.
  return textOfJson(json, 2) + "\n";
}

}  // namespace ocelli
