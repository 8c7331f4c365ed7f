#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <system_error>

#include "cli/command.h"
#include "cli/output_option.h"
#include "cli/scene_options.h"
#include "cli/values.h"
#include "oc_core/base/error.h"
#include "oc_core/base/file_bytes.h"
#include "oc_core/base/output_file.h"
#include "oc_core/shade/effects.h"
#include "oc_core/shade/shade_page.h"

namespace ocelli {
namespace {

namespace fs = std::filesystem;

struct ShadeChoice {
  SceneChoice scene;
  std::string roles;
  std::string effect = "reflection";
  std::vector<std::string> by;
  std::string view;
  std::string size = "720x480";
  std::string imageSize = "720x480";
  std::string cell;
  int environmentHeight = 1024;
  int lightSamples = 1024;
  int runs = 1;
  bool compares = false;
  std::string json;
  std::string csv;
  std::string page;
  std::string output;

  bool jsonToStandardOutput() const { return json == "-"; }
  bool comparesAnything() const { return compares || !json.empty() || !csv.empty() || !page.empty(); }
};

void checkOutputs(const ShadeChoice& choice) {
  if (!choice.output.empty() && choice.by.size() != 1) {
    throw InputError("one picture is by one camera", "-o " + choice.output,
                     "give one name with --by, or use --page DIR");
  }
  if (choice.output.empty() && !choice.comparesAnything()) {
    throw InputError("nothing says what is wanted", "ocelli shade", "give -o IMAGE.png, --compare or --page DIR");
  }
  for (const std::string& path : {choice.output, choice.json, choice.csv}) {
    if (!path.empty() && path != "-") {
      checkWritable(path);
    }
  }
  if (!choice.page.empty()) {
    std::error_code error;
    fs::create_directories(choice.page, error);
    if (error) {
      throw WorkError("cannot make this folder (" + error.message() + ")", choice.page,
                      "choose another one with --page");
    }
    checkWritable(fs::path(choice.page) / "index.html");
  }
}

/// The rows of a square of so many samples.
int lightSideFrom(int samples) {
  int side = 8;
  while (side * side < samples) {
    side += 8;
  }
  return side;
}

class ShadeRun {
 public:
  ShadeRun(const ShadeChoice& choice, const CommandContext& context)
      : choice_(choice), context_(context), effect_(shadeEffect(choice.effect)) {
    const ImageSize size = imageSizeFromText(choice.size, "--size");
    const ImageSize referenceSize = imageSizeFromText(choice.imageSize, "--image-size");
    for (const std::string& way : choice.by) {
      effect_.checkWay(way);
    }
    SceneOptions options = choice.scene.options;
    options.shading = effect_.lightsScene ? Shading::kNone : options.shading;
    const auto scene = std::make_shared<const ShadedScene>(
        loadShadedScene(choice.scene.source, rolesFor(choice.scene.source, choice.roles), options, context.progress()));
    effect_.requireObjects(*scene);
    camera_.emplace(choice.view.empty() ? effect_.defaultView(*scene) : readViewOption(choice.view), size.width,
                    size.height);
    StageInputs inputs{.scene = scene, .referenceSize = {referenceSize.width, referenceSize.height}};
    if (!choice.cell.empty()) {
      inputs.cellSide = cellSideFromText(choice.cell, "--cell");
    }
    inputs.environmentHeight = choice.environmentHeight;
    inputs.lightSide = lightSideFrom(choice.lightSamples);
    inputs.progress = context.progress();
    stage_ = effect_.stage(inputs);
    stage_->checkView(*camera_);
  }

  void run() {
    if (!choice_.comparesAnything()) {
      write(stage_->build(choice_.by.front())->draw(*camera_));
      return;
    }
    ShadeReport report{.scene = choice_.scene.source,
                       .effect = effect_,
                       .version = OCELLI_VERSION,
                       .view = camera_->view(),
                       .size = {camera_->width(), camera_->height()},
                       .runs = choice_.runs};
    std::vector<std::string> ways{kTraced};
    for (const std::string& way : choice_.by) {
      if (way != kTraced) {
        ways.push_back(way);
      }
    }
    for (const std::string& way : ways) {
      report.ways.push_back(stage_->measure(way, *camera_, choice_.runs));
      if (!choice_.output.empty() && way == choice_.by.front()) {
        write(report.ways.back().picture);
      }
    }
    report.facts = stage_->facts(*camera_);
    write(report);
  }

 private:
  void write(const Image<glm::vec3>& picture) const {
    writePng(choice_.output, srgbFromLinear(picture));
    context_.note("wrote " + choice_.output);
  }

  void write(const ShadeReport& report) const {
    context_.print(choice_.jsonToStandardOutput() ? shadeJson(report) : shadeTable(report));
    if (!choice_.json.empty() && !choice_.jsonToStandardOutput()) {
      writeFile(choice_.json, shadeJson(report));
    }
    if (!choice_.csv.empty()) {
      writeFile(choice_.csv, shadeCsv(report));
    }
    if (choice_.page.empty()) {
      return;
    }
    const fs::path folder = choice_.page;
    for (size_t i = 0; i < report.ways.size(); ++i) {
      const ShadeImages names = shadeImageNames(report.ways[i], i);
      writePng(folder / names.picture, srgbFromLinear(report.ways[i].picture));
      for (size_t map = 0; map < names.maps.size(); ++map) {
        writePng(folder / names.maps[map], report.ways[i].maps[map].image);
      }
    }
    writeFile(folder / "index.html", shadePage(report));
    context_.note("wrote " + (folder / "index.html").string());
  }

  const ShadeChoice& choice_;
  const CommandContext& context_;
  const Effect& effect_;
  std::optional<PinholeCamera> camera_;
  std::unique_ptr<EffectStage> stage_;
};

std::string effectHelp() {
  std::string text;
  for (const Effect& effect : shadeEffects()) {
    text += fmt::format("{}{}: {}", text.empty() ? "" : "; ", effect.name, effect.description);
  }
  return text;
}

/// What `--by` takes, said once for effects that take the same.
std::string waysHelp() {
  std::string text = "What stands for the scene where rays go on. Several with --compare or --page.";
  std::vector<std::string> said;
  for (const Effect& effect : shadeEffects()) {
    if (std::find(said.begin(), said.end(), effect.ways) != said.end()) {
      continue;
    }
    said.push_back(effect.ways);
    std::string names;
    for (const Effect& other : shadeEffects()) {
      if (other.ways == said.back()) {
        names += (names.empty() ? "" : ", ") + std::string(other.name);
      }
    }
    text += fmt::format(" For {}: {}.", names, effect.ways);
  }
  return text;
}

}  // namespace

void addShadeCommand(CLI::App& program, const CommandContext& context) {
  CLI::App& command = *program.add_subcommand(
      "shade", "Draw reflections and refractions whose rays hit reference images, and compare them with traced ones");
  const auto choice = std::make_shared<ShadeChoice>();
  addSceneOptions(command, choice->scene, context);
  command
      .add_option(
          "--roles", choice->roles,
          "Which objects mirror, refract or cast; by default SCENE.roles.json beside the scene, and for built-in "
          "scenes their own")
      ->type_name("FILE.json");
  command.add_option("--effect", choice->effect, effectHelp())->type_name("NAME");
  command.add_option("--by", choice->by, waysHelp())->required()->delimiter(',')->type_name("NAME,...");
  command
      .add_option("--view", choice->view,
                  "View of the picture; by default from (0, 0, 10) to what sends the rays, and as wide as that")
      ->type_name("FILE.json");
  addSizeOption(command, choice->size);
  command.add_option("--image-size", choice->imageSize, "Size of the reference images in pixels")
      ->type_name("WIDTHxHEIGHT");
  command
      .add_option(
          "--cell", choice->cell,
          "Size of the cell of viewpoints that the reference images are made for, as for evaluate; by default as "
          "large as what sends the rays")
      ->type_name("SIDE");
  command
      .add_option("--environment-height", choice->environmentHeight,
                  "Rows of environment maps, which have twice as many columns")
      ->check(CLI::Range(2, 16384))
      ->type_name("N");
  command
      .add_option("--light-samples", choice->lightSamples,
                  "Samples of an area light that decide how much of it is seen: 64, 256, 576 or 1024")
      ->check(CLI::IsMember({64, 256, 576, 1024}))
      ->type_name("N");
  command.add_flag("--compare", choice->compares, "Compare with the traced picture and print a table");
  command.add_option("--runs", choice->runs, "How often the rays are timed; the best counts")
      ->check(CLI::Range(1, 1000))
      ->type_name("N");
  addFiguresOption(command, choice->json);
  command.add_option("--csv", choice->csv, "Also write the figures here, a line a way")->type_name("FILE");
  command.add_option("--page", choice->page, "Also make a page with pictures and error maps in this folder")
      ->type_name("DIR");
  addSecondOutputOption(command, "-o,--output", choice->output, "Where the picture goes", {".png"});
  context.finish(command,
                 "  ocelli shade builtin:mirror --by ddoc -o reflection.png\n"
                 "  ocelli shade builtin:mirror,mesh=bunny.obj --by environment,di,ddoc,cell --compare --page mirror\n"
                 "  ocelli shade builtin:lens --effect refraction --by di,cell --json lens.json\n"
                 "  ocelli shade bunny.obj --roles around.roles.json --by spoc -o bunny.png",
                 [choice, context] {
                   checkOutputs(*choice);
                   ShadeRun(*choice, context).run();
                 });
}

}  // namespace ocelli
