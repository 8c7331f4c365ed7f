#include "oc_core/evaluation/evaluation_work.h"

#include <fmt/format.h>

#include <algorithm>
#include <system_error>

#include "oc_core/base/error.h"
#include "oc_core/base/file_bytes.h"
#include "oc_core/base/json_fields.h"

namespace ocelli {
namespace {

constexpr int kFormat = 3;
constexpr double kMaxCount = 9007199254740992.0;  // 2^53: above it a JSON number need not be a whole one
constexpr double kMaxNumber = 1e300;

/// FNV-1a, 64 bits: it tells scenes apart, and guards against nothing.
class Hash {
 public:
  void add(const void* bytes, size_t count) {
    const auto* byte = static_cast<const unsigned char*>(bytes);
    for (size_t i = 0; i < count; ++i) {
      value_ = (value_ ^ byte[i]) * 1099511628211u;
    }
  }
  void add(const std::string& text) { add(text.data(), text.size()); }
  template <class Element>
  void add(const std::vector<Element>& elements) {
    const size_t count = elements.size();
    add(&count, sizeof(count));
    add(elements.data(), count * sizeof(Element));
  }
  std::string text() const { return fmt::format("{:016x}", value_); }

 private:
  uint64_t value_ = 14695981039346656037u;
};

nlohmann::json jsonOf(const FrameErrors& errors) {
  return {{"truth", errors.truth},     {"strict", errors.strict},
          {"thick", errors.thick},     {"wrong_front", errors.wrongFront},
          {"frame", errors.frame},     {"false_skin", errors.falseSkin},
          {"pictures", errors.images}, {"squared_error", errors.squaredError},
          {"ssim", errors.ssim},       {"flip", errors.flip}};
}

nlohmann::json jsonOf(const RepresentationFigures& figures) {
  nlohmann::json json{{"name", figures.name},
                      {"triangles", figures.triangles},
                      {"samples", figures.samples},
                      {"pixels", figures.pixels},
                      {"bytes_raw", figures.bytes.raw},
                      {"bytes_zstd", figures.bytes.compressed},
                      {"build_ms", figures.buildMilliseconds},
                      {"mesh_ms", figures.meshMilliseconds},
                      {"slice_ms", figures.sliceMilliseconds},
                      {"edges", jsonOf(figures.edges)},
                      {"interior", jsonOf(figures.interior)},
                      {"reference", jsonOf(figures.reference)},
                      {"edge_views", nlohmann::json::array()},
                      {"offsets", nlohmann::json::array()},
                      {"strict_ratio_to_di", figures.strictRatioToDi},
                      {"thick_ratio_to_di", figures.thickRatioToDi}};
  for (const FrameErrors& errors : figures.edgeViews) {
    json["edge_views"].push_back(jsonOf(errors));
  }
  for (const FrameErrors& errors : figures.offsets) {
    json["offsets"].push_back(jsonOf(errors));
  }
  return json;
}

size_t readCount(JsonFields& fields, const std::string& name) {
  return static_cast<size_t>(fields.number(name, 0, kMaxCount));
}

FrameErrors readErrors(const nlohmann::json& json, const std::string& where) {
  JsonFields fields(json, where);
  FrameErrors errors;
  errors.truth = readCount(fields, "truth");
  errors.strict = readCount(fields, "strict");
  errors.thick = readCount(fields, "thick");
  errors.wrongFront = readCount(fields, "wrong_front");
  errors.frame = readCount(fields, "frame");
  errors.falseSkin = readCount(fields, "false_skin");
  errors.images = readCount(fields, "pictures");
  errors.squaredError = fields.number("squared_error", 0, kMaxNumber);
  errors.ssim = fields.number("ssim", -kMaxNumber, kMaxNumber);
  errors.flip = fields.number("flip", 0, kMaxNumber);
  fields.rejectUnknown();
  return errors;
}

std::vector<FrameErrors> readAllErrors(JsonFields& fields, const std::string& name, const std::string& where) {
  const nlohmann::json& array = fields.value(name);
  if (!array.is_array()) {
    fields.fail(name, "must be an array");
  }
  std::vector<FrameErrors> all;
  for (const nlohmann::json& errors : array) {
    all.push_back(readErrors(errors, where));
  }
  return all;
}

RepresentationFigures readFigures(const nlohmann::json& json, const std::string& where) {
  JsonFields fields(json, where);
  RepresentationFigures figures;
  figures.name = fields.text("name");
  figures.triangles = readCount(fields, "triangles");
  figures.samples = readCount(fields, "samples");
  figures.pixels = readCount(fields, "pixels");
  figures.bytes.raw = readCount(fields, "bytes_raw");
  figures.bytes.compressed = readCount(fields, "bytes_zstd");
  figures.buildMilliseconds = fields.number("build_ms", 0, kMaxNumber);
  figures.meshMilliseconds = fields.number("mesh_ms", 0, kMaxNumber);
  figures.sliceMilliseconds = fields.number("slice_ms", 0, kMaxNumber);
  figures.edges = readErrors(fields.value("edges"), where);
  figures.interior = readErrors(fields.value("interior"), where);
  figures.reference = readErrors(fields.value("reference"), where);
  figures.edgeViews = readAllErrors(fields, "edge_views", where);
  figures.offsets = readAllErrors(fields, "offsets", where);
  figures.strictRatioToDi = fields.number("strict_ratio_to_di", 0, kMaxNumber);
  figures.thickRatioToDi = fields.number("thick_ratio_to_di", 0, kMaxNumber);
  fields.rejectUnknown();
  return figures;
}

/// Of a hash of the scene.
std::string keyOf(Hash& hash, const EvaluationOptions& options, const std::string& more) {
  const glm::vec3& direction = options.cell.segmentDirection;
  hash.add(fmt::format("{} {}x{} {} {} {},{},{} {} {} {} {} {} {} {} ", jsonText(options.view), options.width,
                       options.height, options.cell.sideRadii, cellShapeName(options.cell.shape), direction.x,
                       direction.y, direction.z, options.edgeViews, options.interiorViews, options.seed,
                       options.compareImages, options.offsetDirections, options.runs,
                       static_cast<bool>(options.slice)));
  hash.add(options.offsets);
  hash.add(more);
  return hash.text();
}

}  // namespace

std::string textHash(const std::string& text) {
  Hash hash;
  hash.add(text);
  return hash.text();
}

std::string evaluationKey(const Mesh& scene, const EvaluationOptions& options, const std::string& more) {
  Hash hash;
  hash.add(scene.positions);
  hash.add(scene.colors);
  hash.add(scene.triangles);
  return keyOf(hash, options, more);
}

std::string evaluationKey(const std::string& scene, const EvaluationOptions& options, const std::string& more) {
  Hash hash;
  hash.add(scene);
  return keyOf(hash, options, more);
}

EvaluationWork::EvaluationWork(std::filesystem::path path, std::string key)
    : path_(std::move(path)), key_(std::move(key)) {}

void EvaluationWork::load() {
  finished_.clear();
  const std::string where = path_.string();
  const nlohmann::json json = readJsonFile(path_);
  JsonFields fields(json, where);
  fields.integer("format", kFormat, kFormat);
  if (fields.text("key") != key_) {
    throw InputError("this work file is of another scene, other options or another version", where,
                     "run without --resume, which starts again");
  }
  const nlohmann::json& rows = fields.value("representations");
  fields.rejectUnknown();
  if (!rows.is_array()) {
    fields.fail("representations", "must be an array");
  }
  std::vector<std::pair<std::string, RepresentationFigures>> finished;
  for (const nlohmann::json& row : rows) {
    JsonFields entry(row, where);
    const std::string camera = entry.text("camera");
    finished.emplace_back(camera, readFigures(entry.value("figures"), where + ", \"" + camera + "\""));
    entry.rejectUnknown();
  }
  finished_ = std::move(finished);
}

std::optional<RepresentationFigures> EvaluationWork::find(const std::string& camera) const {
  const auto found =
      std::find_if(finished_.begin(), finished_.end(), [&](const auto& entry) { return entry.first == camera; });
  return found == finished_.end() ? std::nullopt : std::optional(found->second);
}

void EvaluationWork::add(const std::string& camera, const RepresentationFigures& figures) {
  std::erase_if(finished_, [&](const auto& entry) { return entry.first == camera; });
  finished_.emplace_back(camera, figures);
  nlohmann::json rows = nlohmann::json::array();
  for (const auto& [name, row] : finished_) {
    rows.push_back({{"camera", name}, {"figures", jsonOf(row)}});
  }
  const nlohmann::json json{{"format", kFormat}, {"key", key_}, {"representations", rows}};
  writeFile(path_, textOfJson(json, 1) + "\n");
}

void EvaluationWork::remove() {
  std::error_code ignored;
  std::filesystem::remove(path_, ignored);
}

}  // namespace ocelli
