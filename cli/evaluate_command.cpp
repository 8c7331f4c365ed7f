#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <optional>
#include <system_error>

#include "cli/command.h"
#include "cli/depth_views_option.h"
#include "cli/interrupt.h"
#include "cli/output_option.h"
#include "cli/scene_options.h"
#include "cli/values.h"
#include "cli/volume_options.h"
#include "display_sim/frames/display_profile.h"
#include "display_sim/slicing/slicer.h"
#include "oc_core/base/error.h"
#include "oc_core/base/file_bytes.h"
#include "oc_core/base/output_file.h"
#include "oc_core/depth_views/views_scene.h"
#include "oc_core/evaluation/evaluation_csv.h"
#include "oc_core/evaluation/evaluation_json.h"
#include "oc_core/evaluation/evaluation_page.h"
#include "oc_core/evaluation/evaluation_table.h"
#include "oc_core/evaluation/evaluation_work.h"
#include "oc_core/ray_map/ray_map_file.h"
#include "oc_core/volume_ocri/volume_first_hits.h"

namespace ocelli {
namespace {

namespace fs = std::filesystem;

struct EvaluateChoice {
  SceneChoice scene;
  VolumeChoice volume;
  std::optional<double> opacity;
  std::vector<std::string> cameras{"di", "ddoc"};
  std::string cell = "8in";
  std::string cellShape = "cube";
  std::string segmentDirection = "1,0,0";
  std::string view;
  std::string from;
  std::string size = "720x480";
  std::string profile = "perspecta";
  int interiorViews = 12;
  int edgeViews = 1;
  unsigned seed = 1;
  int offsetDirections = 4;
  int runs = 3;
  std::string json;
  std::string csv;
  std::string offsetsCsv;
  std::string sequencesCsv;
  std::string page;
  std::optional<bool> resume;
};

/// A camera that was asked for, and a text that no other camera has.
struct AskedCamera {
  CameraChoice choice;
  std::string identity;
};

std::vector<AskedCamera> askedCameras(const std::vector<std::string>& names, const ViewCell& cell) {
  std::vector<AskedCamera> cameras;
  for (const std::string& name : names) {
    // What a file says may change between two runs.
    const std::string identity =
        name.ends_with(".json") || namesRayMap(name) ? name + " " + textHash(readFile(name)) : name;
    cameras.push_back({cameraChoice(name, cell), identity});
  }
  return cameras;
}

EvaluationOptions evaluationOptions(const EvaluateChoice& choice) {
  EvaluationOptions options;
  options.view = readViewOption(choice.view);
  const ImageSize size = imageSizeFromText(choice.size, "--size");
  options.width = size.width;
  options.height = size.height;
  options.cell.sideRadii = cellSideFromText(choice.cell, "--cell");
  options.cell.shape = cellShapeFromName(choice.cellShape, "--cell-shape");
  options.cell.segmentDirection = pointFromText(choice.segmentDirection, "--segment-direction");
  if (options.cell.segmentDirection == glm::vec3(0)) {
    throw InputError("a segment needs a direction, and 0,0,0 has none", "--segment-direction",
                     "--segment-direction 1,0,0");
  }
  options.interiorViews = choice.interiorViews;
  options.edgeViews = choice.edgeViews;
  if (options.cell.shape != ViewCell::Shape::kCube && (choice.edgeViews != 1 || !choice.sequencesCsv.empty())) {
    throw InputError("only a cube has edges to move along", "--cell-shape " + choice.cellShape,
                     "leave out --edge-views and --csv-sequences, or use --cell-shape cube");
  }
  options.seed = choice.seed;
  options.compareImages = true;
  options.offsets = choice.offsetDirections > 0 ? defaultOffsets() : std::vector<float>{};
  options.offsetDirections = choice.offsetDirections;
  options.runs = choice.runs;
  return options;
}

/// What is measured against.
struct EvaluateTruth {
  Mesh mesh;
  Mesh surface;  ///< of views with depth that representations are made from; empty: from the scene
  std::unique_ptr<const VolumeFirstHits> volume;
  std::unique_ptr<const EvaluatedScene> scene;
  std::string parts;  ///< of a volume
  std::string key;    ///< tells it from any other scene, with options and `more`
};

/// `truth` stays where it is: what is measured refers to it.
void findTruth(EvaluateTruth& truth, const EvaluateChoice& choice, const EvaluationOptions& options,
               const std::string& more, const Progress& progress, const CommandContext& context) {
  if (!choice.from.empty() && takesVolume(choice.scene)) {
    throw InputError("views with depth are measured against scenes of triangles", "--from " + choice.from,
                     "leave --from out, or take a surface of the volume with --iso VALUE");
  }
  if (takesVolume(choice.scene)) {
    truth.volume = std::make_unique<const VolumeFirstHits>(
        loadVolume(choice.scene, choice.volume, context),
        VolumeRenderOptions{.depthOpacity = choice.opacity.value_or(VolumeRenderOptions{}.depthOpacity)});
    truth.scene = std::make_unique<const TargetScene>(truth.volume->evaluated());
    truth.parts = truth.volume->description();
    truth.key = evaluationKey(truth.volume->identity(), options, more);
    return;
  }
  refuseVolumeOptions(choice.volume);
  refuseVolumeOption(choice.opacity.has_value(), "--opacity");
  truth.mesh = loadScene(choice.scene.source, choice.scene.options, progress);
  if (choice.from.empty()) {
    truth.key = evaluationKey(truth.mesh, options, more);
    return;
  }
  truth.surface = surfaceFrom(choice.from, context);
  truth.scene = std::make_unique<const ViewsScene>(truth.mesh, truth.surface);
  truth.key = evaluationKey(truth.mesh, options, more + " " + evaluationKey(truth.surface, options, "views"));
}

/// Where the results of `ocelli evaluate` go. Each place is checked before the work begins, where this `writes`.
class Outputs {
 public:
  Outputs(const EvaluateChoice& choice, bool writes) : choice_(choice) {
    if (!writes) {
      return;
    }
    for (const std::string& path : files()) {
      checkWritable(path);
    }
    if (!choice.page.empty()) {
      std::error_code error;
      fs::create_directories(choice.page, error);
      if (error) {
        throw WorkError("cannot make this folder (" + error.message() + ")", choice.page,
                        "choose another one with --page");
      }
      checkWritable(pageFile());
    }
  }

  /// In the folder of the page, whose images belong to it; else beside the first file; none where nothing is written.
  std::optional<fs::path> workFile() const {
    if (hasPage()) {
      return inPage("evaluation.work");
    }
    // Nothing can stand beside a pipe.
    for (const std::string& path : files()) {
      if (!isStream(path)) {
        return fs::path(path + ".work");
      }
    }
    return std::nullopt;
  }
  bool hasPage() const { return !choice_.page.empty(); }
  fs::path pageFile() const { return fs::path(choice_.page) / "index.html"; }
  fs::path inPage(const std::string& name) const { return fs::path(choice_.page) / name; }

  bool haveImages(const EvaluateImages& images) const {
    std::error_code ignored;
    return !hasPage() || (fs::exists(inPage(images.frame), ignored) && fs::exists(inPage(images.errors), ignored));
  }

 private:
  std::vector<std::string> files() const {
    std::vector<std::string> paths;
    for (const std::string& path : {choice_.json, choice_.csv, choice_.offsetsCsv, choice_.sequencesCsv}) {
      if (!path.empty() && path != "-") {
        paths.push_back(path);
      }
    }
    return paths;
  }

  const EvaluateChoice& choice_;
};

/// Takes over what an earlier run has finished, as --resume says.
void resume(EvaluationWork& work, const fs::path& file, std::optional<bool> wanted, const CommandContext& context) {
  std::error_code ignored;
  if (wanted != false && (wanted == true || fs::exists(file, ignored))) {
    try {
      work.load();
      context.note(fmt::format("going on with {}: {} finished", file.string(), work.count()));
      return;
    } catch (const InputError& error) {
      if (wanted == true) {
        throw;
      }
      context.note(fmt::format("starting again: {}", error.what()));
    }
  }
  // What the images of a page are of must not be in doubt.
  work.remove();
}

/// Two builds of one version may measure differently.
std::string programStamp() {
  const fs::path program = "/proc/self/exe";
  std::error_code ignored;
  return fmt::format("{} {} {}", OCELLI_VERSION, fs::file_size(program, ignored),
                     fs::last_write_time(program, ignored).time_since_epoch().count());
}

std::string truthImageName() {
  return "truth.png";
}

void writeOutputs(const EvaluateChoice& choice, const Outputs& outputs, const EvaluationOptions& options,
                  const std::vector<RepresentationFigures>& rows, const std::vector<EvaluateImages>& images,
                  const EvaluatePage& scene, const CommandContext& context) {
  const bool complete = rows.size() == choice.cameras.size();
  giveFigures(choice.json, evaluationJson(choice.scene.source, options, rows, complete), evaluationTable(rows),
              context);
  if (!choice.csv.empty()) {
    writeFile(choice.csv, evaluationCsv(options, rows));
  }
  if (!choice.offsetsCsv.empty()) {
    writeFile(choice.offsetsCsv, offsetsCsv(options, rows));
  }
  if (!choice.sequencesCsv.empty()) {
    writeFile(choice.sequencesCsv, sequencesCsv(options, rows));
  }
  if (outputs.hasPage()) {
    const EvaluatePage page{choice.scene.source, OCELLI_VERSION, scene.sceneTriangles,
                            truthImageName(),    images,         complete,
                            scene.sceneParts};
    writeFile(outputs.pageFile(), evaluatePage(page, options, rows));
    context.note("wrote " + outputs.pageFile().string());
  }
}

void runEvaluate(const EvaluateChoice& choice, const CommandContext& context) {
  EvaluationOptions options = evaluationOptions(choice);
  const std::vector<AskedCamera> cameras = askedCameras(choice.cameras, options.cell);
  const DisplayProfile profile = loadProfile(choice.profile);
  options.slice = [&profile](const Mesh& mesh) { slice(mesh, profile); };
  Ranks& ranks = context.ranks();
  options.ranks = &ranks;
  const Outputs outputs(choice, ranks.isFirst());

  const InterruptGuard guard;
  std::string position;  // "2/16 " before the name of what is measured
  const Progress progress = [&, bar = context.progress()](std::string_view stage, double fraction) {
    InterruptGuard::check();
    report(bar, position + std::string(stage), fraction);
  };
  std::vector<RepresentationFigures> rows;
  std::vector<EvaluateImages> images;
  EvaluatePage page;  // what it says of the scene
  std::optional<EvaluationWork> work;
  try {
    EvaluateTruth truth;
    findTruth(truth, choice, options, fmt::format("{} {} {}", choice.scene.source, profile.name, programStamp()),
              progress, context);
    page.sceneTriangles = truth.mesh.triangles.size();
    page.sceneParts = truth.parts;
    if (const auto file = outputs.workFile(); file && ranks.isFirst()) {
      work.emplace(*file, truth.key);
      resume(*work, *file, choice.resume, context);
    }
    const auto made = truth.scene != nullptr ? std::make_unique<Evaluator>(*truth.scene, options)
                                             : std::make_unique<Evaluator>(truth.mesh, options);
    Evaluator& evaluator = *made;
    if (outputs.hasPage() && ranks.isFirst()) {
      writePng(outputs.inPage(truthImageName()), evaluator.exampleImage());
    }
    for (const AskedCamera& camera : cameras) {
      const EvaluateImages names = imageNames(camera.choice.name, camera.identity);
      position = fmt::format("{}/{} ", rows.size() + 1, cameras.size());
      std::optional<RepresentationFigures> row;
      if (work && outputs.haveImages(names)) {
        row = work->find(camera.identity);
      }
      // The first rank alone knows what is finished: all go on with the same.
      const bool isFinished = ranks.largest(row ? 1 : 0) != 0;
      if (isFinished && !ranks.isFirst()) {
        continue;
      }
      if (!row) {
        row = evaluator.measure(camera.choice, progress, [&](const Mesh& representation) {
          if (outputs.hasPage() && ranks.isFirst()) {
            const Evaluator::Example example = evaluator.example(representation);
            writePng(outputs.inPage(names.frame), example.image);
            writePng(outputs.inPage(names.errors), example.errors);
          }
        });
        if (work) {
          work->add(camera.identity, *row);
        }
      }
      rows.push_back(*row);
      images.push_back(names);
    }
  } catch (const Interrupted&) {
    if (!rows.empty() && ranks.isFirst()) {
      writeOutputs(choice, outputs, options, rows, images, page, context);
    }
    throw WorkError(fmt::format("interrupted with {} of {} representations done", rows.size(), cameras.size()),
                    work ? outputs.workFile()->string() : choice.scene.source,
                    work ? "the same command again goes on from there"
                         : "give --json FILE, --csv FILE or --page DIR, so that an interrupted run can go on");
  }
  if (!ranks.isFirst()) {
    return;
  }
  writeOutputs(choice, outputs, options, rows, images, page, context);
  if (work) {
    work->remove();
  }
}

}  // namespace

void addEvaluateCommand(CLI::App& program, const CommandContext& context) {
  CLI::App& command = *program.add_subcommand(
      "evaluate", "Measure what reference images lack over a cell of viewpoints, and their cost");
  const auto choice = std::make_shared<EvaluateChoice>();
  addSceneOptions(command, choice->scene, context);
  addVolumeOptions(command, choice->volume);
  addOpacityOption(command, choice->opacity);
  command.add_option("--cameras", choice->cameras, "Cameras to compare: names or JSON files")
      ->delimiter(',')
      ->type_name("NAME,...");
  command.add_option("--cell", choice->cell, "Size of the cell of viewpoints, in inches at the reference display")
      ->type_name("SIDE");
  command.add_option("--cell-shape", choice->cellShape, "Shape of the cell")
      ->check(CLI::IsMember({"cube", "sphere", "segment"}))
      ->type_name("NAME");
  command
      .add_option("--segment-direction", choice->segmentDirection,
                  "Direction of a segment: right, up and backward in the view")
      ->type_name("X,Y,Z");
  addViewOption(command, choice->view);
  addFromOption(
      command, choice->from,
      "Make the representations of the views with depth in this folder, and measure them against SCENE, which "
      "these are views of (ocelli ocri views)");
  addSizeOption(command, choice->size);
  command.add_option("--profile", choice->profile, "Display whose slicing is timed")->type_name("NAME|FILE.json");
  command
      .add_option("--edge-views", choice->edgeViews, "How many viewpoints between the corners of each edge of a cube")
      ->check(CLI::Range(0, 1000))
      ->type_name("N");
  command.add_option("--interior", choice->interiorViews, "How many viewpoints inside of the cell")
      ->check(CLI::Range(0, 10000))
      ->type_name("N");
  command
      .add_option("--directions", choice->offsetDirections,
                  "Along how many directions the error is measured against the offset; 0 for none")
      ->check(CLI::Range(0, 1000))
      ->type_name("N");
  command.add_option("--seed", choice->seed, "Of the viewpoints inside, and the directions")->type_name("S");
  command.add_option("--runs", choice->runs, "How often each step is timed; the best counts")
      ->check(CLI::Range(1, 1000))
      ->type_name("N");
  addFiguresOption(command, choice->json);
  command.add_option("--csv", choice->csv, "Also write the figures here, a line a representation")->type_name("FILE");
  command.add_option("--csv-offsets", choice->offsetsCsv, "Also write the errors against the offset here")
      ->type_name("FILE");
  command.add_option("--csv-sequences", choice->sequencesCsv, "Also write the errors along each edge of a cube here")
      ->type_name("FILE");
  command.add_option("--page", choice->page, "Also make a page with plots and images in this folder")->type_name("DIR");
  CLI::Option* resume = command.add_flag_callback(
      "--resume", [choice] { choice->resume = true; },
      "Go on with an interrupted run, which is what is done anyway where its work file fits; an error where it does "
      "not");
  command
      .add_flag_callback(
          "--no-resume", [choice] { choice->resume = false; }, "Start again")
      ->excludes(resume);
  context.finishShared(command,
                       "  ocelli evaluate builtin:statues\n"
                       "  ocelli evaluate bunny.obj --cameras di,ddoc,ddoc-constant --cell 4in --json bunny.json\n"
                       "  ocelli evaluate builtin:volume,name=skull --opacity 0.5 --cameras di,ddoc,ldi-3\n"
                       "  ocelli evaluate builtin:room --from views --cameras ddoc,ldi-2 --cell 4in\n"
                       "  ocelli evaluate builtin:fence --cell-shape segment --page fence",
                       [choice, context] { runEvaluate(*choice, context); });
}

}  // namespace ocelli
