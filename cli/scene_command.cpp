// `ocelli scene`: what scenes there are, what is in one, and the mesh that everything downstream takes.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <iterator>
#include <memory>
#include <nlohmann/json.hpp>

#include "cli/command.h"
#include "cli/output_option.h"
#include "cli/scene_options.h"
#include "cli/scene_walk_command.h"
#include "cli/volume_info.h"
#include "cli/volume_options.h"
#include "oc_core/base/error.h"
#include "oc_core/base/json_fields.h"
#include "oc_core/base/output_file.h"
#include "oc_core/base/printable_text.h"
#include "oc_core/pack/pack_summary.h"
#include "oc_core/scene/ply_file.h"
#include "oc_core/volume/builtin_volumes.h"
#include "oc_core/volume/volume_summary.h"
#include "oc_core/volume/volume_summary_json.h"
#include "oc_core/worlds/builtin_scenes.h"
#include "oc_core/worlds/packed_source.h"
#include "oc_core/worlds/scene_motion.h"

namespace ocelli {
namespace {

using Json = nlohmann::ordered_json;

std::string kindName(BuiltinParameter::Kind kind) {
  switch (kind) {
    case BuiltinParameter::Kind::kInteger:
      return "integer";
    case BuiltinParameter::Kind::kNumber:
      return "number";
    case BuiltinParameter::Kind::kFile:
      return "file";
  }
  return "";
}

/// A built-in scene or volume, as `scene list` shows it.
struct ListedSource {
  std::string name;  ///< what stands behind "builtin:"
  std::string summary;
  const std::vector<BuiltinParameter>* parameters;
};

std::vector<ListedSource> listedSources() {
  std::vector<ListedSource> sources;
  for (const BuiltinScene& scene : listBuiltinScenes()) {
    sources.push_back({scene.name, scene.summary, &scene.parameters});
  }
  for (const BuiltinVolumeKind& volume : listBuiltinVolumes()) {
    sources.push_back({"volume,name=" + volume.name, volume.summary, &volume.parameters});
  }
  return sources;
}

std::string listAsText() {
  std::string text;
  for (const ListedSource& source : listedSources()) {
    text += fmt::format("builtin:{:<10} {}\n", source.name, source.summary);
    for (const BuiltinParameter& parameter : *source.parameters) {
      const bool isFile = parameter.kind == BuiltinParameter::Kind::kFile;
      const std::string key = parameter.name + "=" + (isFile ? "FILE" : parameter.otherwise);
      text += fmt::format("    {:<14} {}", key, parameter.summary);
      text += isFile ? "\n" : fmt::format(" ({:.10g} to {:.10g})\n", parameter.least, parameter.most);
    }
  }
  return text;
}

std::string listAsJson() {
  Json sources = Json::array();
  for (const ListedSource& source : listedSources()) {
    Json parameters = Json::array();
    for (const BuiltinParameter& parameter : *source.parameters) {
      Json entry{{"name", parameter.name}, {"kind", kindName(parameter.kind)}, {"summary", parameter.summary}};
      entry["default"] = parameter.otherwise;
      if (parameter.kind != BuiltinParameter::Kind::kFile) {
        entry["least"] = parameter.least;
        entry["most"] = parameter.most;
      }
      parameters.push_back(entry);
    }
    sources.push_back({{"name", source.name}, {"summary", source.summary}, {"parameters", parameters}});
  }
  return textOfJson(sources, 2) + "\n";
}

/// Of the file itself: where it has textures, some are split to bake these to vertices; where it has points or lines,
/// it is not told.
size_t trianglesInFile(const SceneChoice& scene, const GuidedScene& loaded, const Progress& progress) {
  const Mesh& mesh = loaded.mesh;
  if (loaded.points) {
    return 0;
  }
  if (scene.options.iso) {
    return mesh.triangles.size();
  }
  // Neither has textures.
  if (!scene.options.textures || isBuiltinScene(scene.source) || scene.source.ends_with(".ply") ||
      scene.options.motion.seconds) {
    return mesh.triangles.size();
  }
  return loadScene(scene.source,
                   {.fit = false, .shading = Shading::kNone, .textures = false, .labels = scene.options.labels},
                   progress)
      .triangles.size();
}

void appendBox(std::string& text, const Box& box) {
  fmt::format_to(std::back_inserter(text),
                 "  x          {:.6g} to {:.6g}\n  y          {:.6g} to {:.6g}\n  z          {:.6g} to {:.6g}\n",
                 box.lower.x, box.upper.x, box.lower.y, box.upper.y, box.lower.z, box.upper.z);
}

void putBox(Json& info, const Box& box) {
  const auto list = [](const glm::vec3& p) { return Json::array({p.x, p.y, p.z}); };
  info["lower"] = list(box.lower);
  info["upper"] = list(box.upper);
}

void appendMotion(std::string& text, const SceneMotion& motion) {
  const MotionFacts facts = motion.facts();
  text += fmt::format("  moves      for {:.6g} s", motion.durationSeconds());
  if (facts.meshes > 0) {
    text += fmt::format(": {} meshes, {} of them with triangles of their own", facts.meshes, facts.topologies);
  }
  text += "\n";
  for (size_t i = 0; i < facts.animations.size(); ++i) {
    text += fmt::format("  animation  {} \"{}\", {:.6g} s{}\n", i + 1, printableText(facts.animations[i].name),
                        facts.animations[i].seconds, i == facts.played ? ", the one that plays" : "");
  }
}

void putMotion(Json& info, const SceneMotion& motion) {
  const MotionFacts facts = motion.facts();
  Json animations = Json::array();
  for (const MotionFacts::Animation& animation : facts.animations) {
    animations.push_back({{"name", animation.name}, {"seconds", animation.seconds}});
  }
  info["motion"] = {{"seconds", motion.durationSeconds()},
                    {"meshes", facts.meshes},
                    {"topologies", facts.topologies},
                    {"animations", animations}};
}

/// Of a scene that moves: its motion is told, too.
std::unique_ptr<SceneMotion> motionToTell(const SceneChoice& scene, const Progress& progress) {
  return !scene.options.iso && mayMove(scene.source) ? loadMotion(scene.source, scene.options, progress) : nullptr;
}

/// At the time that is asked for; otherwise at rest, and a folder of meshes at its begin.
GuidedScene sceneToTell(const SceneChoice& scene, const Progress& progress) {
  SceneOptions options = scene.options;
  if (options.iso) {
    return loadGuidedScene(scene.source, options, progress);  // of a volume, which has no meshes in a folder
  }
  if (std::filesystem::is_directory(scene.source)) {
    options.motion.seconds = options.motion.seconds.value_or(0);
  } else if (!options.motion.seconds) {
    options.motion = {};
  }
  return loadGuidedScene(scene.source, options, progress);
}

void appendPoints(std::string& text, const PointFacts& points) {
  const std::string repeated =
      points.repeated > 0 ? fmt::format(", {} of them where another one is", points.repeated) : "";
  if (points.lines > 0) {
    text += fmt::format("  lines      {} segments, as tubes\n", points.lines);
  }
  if (points.points == 0) {
    return;
  }
  text += fmt::format("  points     {}{}: {} flat panels, {} octahedra\n", points.points, repeated, points.panels,
                      points.solids);
  text += points.areWidthsChosen ? fmt::format("  width      {:.6g} to {:.6g}, median {:.6g}, from the neighbours\n",
                                               points.narrowest, points.widest, points.medianWidth)
                                 : fmt::format("  width      {:.6g}\n", points.medianWidth);
}

void putPoints(Json& info, const PointFacts& points) {
  info["points"] = {{"in_file", points.points},      {"repeated", points.repeated},
                    {"panels", points.panels},       {"octahedra", points.solids},
                    {"line_segments", points.lines}, {"widths_from_neighbors", points.areWidthsChosen},
                    {"narrowest", points.narrowest}, {"median_width", points.medianWidth},
                    {"widest", points.widest}};
}

std::string infoAsText(const std::string& source, const GuidedScene& loaded, size_t inFile, const SceneMotion* motion) {
  const Mesh& mesh = loaded.mesh;
  const size_t triangles = mesh.triangles.size();
  const std::string count =
      triangles == inFile || loaded.points
          ? std::to_string(triangles)
          : fmt::format("{} in the file, {} after its textures were baked to vertices", inFile, triangles);
  std::string text = fmt::format("{}\n  triangles  {}\n  vertices   {}\n", source, count, mesh.positions.size());
  if (loaded.points) {
    appendPoints(text, *loaded.points);
  }
  appendBox(text, boundsOf(mesh));
  if (motion != nullptr) {
    appendMotion(text, *motion);
  }
  return text;
}

std::string infoAsJson(const std::string& source, const GuidedScene& loaded, size_t inFile, const SceneMotion* motion) {
  const Mesh& mesh = loaded.mesh;
  Json info{{"scene", source},
            {"triangles", mesh.triangles.size()},
            {"triangles_in_file", inFile},
            {"vertices", mesh.positions.size()}};
  if (loaded.points) {
    putPoints(info, *loaded.points);
  }
  putBox(info, boundsOf(mesh));
  if (motion != nullptr) {
    putMotion(info, *motion);
  }
  return textOfJson(info, 2) + "\n";
}

std::string packInfoAsText(const PackedScene& scene, const PackSummary& holds) {
  const PackedOrigin origin = originOf(scene);
  std::string text = fmt::format(
      "{}\n  source     {}, {}, shading {}\n  triangles  {} at the finest level, {} at the coarsest, {} with all "
      "levels\n"
      "  clusters   {} at the finest level, {} at the coarsest, {} with all levels, in {} groups\n  levels     {}\n"
      "  bytes      {}\n",
      scene.path().string(), origin.scene.empty() ? "unknown" : printableText(origin.scene),
      origin.fit ? "fitted" : "not fitted", printableText(origin.shading), holds.finestTriangles,
      holds.coarsestTriangles, scene.storedTriangles(), holds.finestClusters, holds.coarsestClusters,
      scene.clusterCount(), scene.groupCount(), holds.levels, scene.fileBytes());
  appendBox(text, scene.bounds());
  return text;
}

std::string packInfoAsJson(const PackedScene& scene, const PackSummary& holds) {
  const PackedOrigin origin = originOf(scene);
  Json info{{"scene", scene.path().string()},
            {"source", origin.scene},
            {"fit", origin.fit},
            {"shading", origin.shading},
            {"triangles", holds.finestTriangles},
            {"triangles_in_file", scene.triangleCount()},
            {"coarsest_triangles", holds.coarsestTriangles},
            {"stored_triangles", scene.storedTriangles()},
            {"finest_clusters", holds.finestClusters},
            {"coarsest_clusters", holds.coarsestClusters},
            {"clusters", scene.clusterCount()},
            {"groups", scene.groupCount()},
            {"levels", holds.levels},
            {"bytes", scene.fileBytes()}};
  putBox(info, scene.bounds());
  return textOfJson(info, 2) + "\n";
}

/// What a volume is, voxels that are no numbers and all.
void printVolumeInfo(const SceneChoice& scene, bool asJson, const CommandContext& context) {
  const VolumeSceneOptions options = volumeSceneOptionsOf(scene, {});
  if (!options.transfer.empty() || scene.shadingGiven) {
    throw InputError("what a volume is does not depend on how it is shown",
                     options.transfer.empty() ? "--shading" : "--transfer", "leave it out, or use ocelli render");
  }
  const VolumeSeries series = loadVolumeSeries(scene.source, options.series, context.progress());
  for (const std::string& warning : series.warnings) {
    options.warn(warning);
  }
  const size_t index = options.seconds ? series.indexAt(*options.seconds) : 0;
  const VolumeSummary summary = summaryOf(series, index, options.level, context.progress());
  context.print(asJson ? volumeSummaryJson(scene.source, summary) : volumeInfoAsText(scene.source, summary));
}

void addSceneList(CLI::App& parent, const CommandContext& context) {
  CLI::App& command = *parent.add_subcommand("list", "Show the built-in scenes and volumes, and their parameters");
  const auto asJson = std::make_shared<bool>(false);
  command.add_flag("--json", *asJson, "Print them as JSON");
  context.finish(command, "  ocelli scene list",
                 [asJson, context] { context.print(*asJson ? listAsJson() : listAsText()); });
}

void addSceneInfo(CLI::App& parent, const CommandContext& context) {
  CLI::App& command = *parent.add_subcommand("info",
                                             "Count what is in a scene, as everything downstream sees it, and tell how "
                                             "it moves; of a packed scene, check all of it; of a volume, tell its "
                                             "grid and its values");
  const auto scene = std::make_shared<SceneChoice>();
  const auto asJson = std::make_shared<bool>(false);
  addSceneOptions(command, *scene, context);
  addMotionOptions(command, *scene);
  command.add_flag("--json", *asJson, "Print the figures as JSON");
  context.finish(command, "  ocelli scene info bunny.obj\n  ocelli scene info bunny.obj --no-fit --shading none",
                 [scene, asJson, context] {
                   if (takesVolume(*scene)) {
                     printVolumeInfo(*scene, *asJson, context);
                     return;
                   }
                   if (isPackedScene(scene->source) && !scene->options.motion.seconds) {
                     const PackedScene packed = openPacked(scene->source, scene->options);
                     const PackSummary holds = summaryOf(packed, context.progress());
                     context.print(*asJson ? packInfoAsJson(packed, holds) : packInfoAsText(packed, holds));
                     return;
                   }
                   const std::unique_ptr<SceneMotion> motion = motionToTell(*scene, context.progress());
                   const GuidedScene loaded = sceneToTell(*scene, context.progress());
                   const size_t inFile = trianglesInFile(*scene, loaded, context.progress());
                   context.print(*asJson ? infoAsJson(scene->source, loaded, inFile, motion.get())
                                         : infoAsText(scene->source, loaded, inFile, motion.get()));
                 });
}

void addSceneExport(CLI::App& parent, const CommandContext& context) {
  CLI::App& command = *parent.add_subcommand("export", "Write the mesh that everything downstream takes");
  const auto scene = std::make_shared<SceneChoice>();
  const auto path = std::make_shared<std::string>();
  addSceneOptions(command, *scene, context);
  addMotionOptions(command, *scene);
  addOutputOption(command, *path, "The mesh, as binary PLY with vertex colours", {".ply"});
  context.finish(command, "  ocelli scene export builtin:statues,triangles=4600000 -o statues.ply",
                 [scene, path, context] {
                   checkWritable(*path);
                   const Mesh mesh = loadScene(scene->source, scene->options, context.progress());
                   writePly(*path, mesh);
                   context.note(fmt::format("wrote {} ({} triangles)", *path, mesh.triangles.size()));
                 });
}

std::string packText(const std::string& path, const PackReport& report) {
  return fmt::format(
      "{}\n  triangles  {} of the scene, {} with all levels\n  clusters   {} in {} groups\n  bytes      {}\n", path,
      report.triangles, report.storedTriangles, report.clusters, report.groups, report.bytes);
}

std::string packJson(const std::string& path, const PackReport& report) {
  return textOfJson(Json{{"file", path},
                         {"triangles", report.triangles},
                         {"stored_triangles", report.storedTriangles},
                         {"clusters", report.clusters},
                         {"groups", report.groups},
                         {"bytes", report.bytes},
                         {"parts", report.parts},
                         {"parts_at_hand", report.partsAtHand}},
                    2) +
         "\n";
}

void addScenePack(CLI::App& parent, const CommandContext& context) {
  CLI::App& command = *parent.add_subcommand("pack", "Prepare a scene once, so that large ones are drawn in a moment");
  const auto scene = std::make_shared<SceneChoice>();
  const auto path = std::make_shared<std::string>();
  const auto asJson = std::make_shared<bool>(false);
  addSceneOptions(command, *scene, context);
  addOutputOption(command, *path, "The packed scene; every command takes it as a SCENE", {".opack"});
  command.add_flag("--json", *asJson, "Print the figures as JSON");
  context.finish(command,
                 "  ocelli scene pack statue.ply -o statue.opack\n"
                 "  ocelli scene pack builtin:crowd,copies=1000,triangles=200000000 -o crowd.opack",
                 [scene, path, asJson, context] {
                   const PackReport made = packSource(scene->source, scene->options, *path, context.progress());
                   if (made.partsAtHand > 0) {
                     context.note(fmt::format("{} of {} parts were at hand from a job that was ended", made.partsAtHand,
                                              made.parts));
                   }
                   context.print(*asJson ? packJson(*path, made) : packText(*path, made));
                 });
}

}  // namespace

void addSceneCommand(CLI::App& program, const CommandContext& context) {
  CLI::App& command =
      *program.add_subcommand("scene", "List built-in scenes, look into a scene, export it, pack it, find ways");
  command.require_subcommand(1);
  addSceneList(command, context);
  addSceneInfo(command, context);
  addSceneExport(command, context);
  addScenePack(command, context);
  addSceneWalk(command, context);
}

}  // namespace ocelli
