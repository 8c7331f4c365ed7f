#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
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

float largestSide(const Box& box) {
  return std::max({box.size().x, box.size().y, box.size().z});
}

class ShadeRun {
 public:
  ShadeRun(const ShadeChoice& choice, const CommandContext& context)
      : choice_(choice),
        context_(context),
        effect_(shadeEffect(choice.effect)),
        size_(imageSizeFromText(choice.size, "--size")),
        referenceSize_(imageSizeFromText(choice.imageSize, "--image-size")) {
    for (const std::string& name : choice.by) {
      checkProxyName(name);
    }
    scene_ = loadShadedScene(choice.scene.source, rolesFor(choice.scene.source, choice.roles), choice.scene.options,
                             context.progress());
    requireSenders(effect_, scene_);
    senders_ = boundsOf(effect_.senders(scene_));
    view_ = choice.view.empty() ? pictureView(senders_) : readViewOption(choice.view);
    rays_ = raysOf(effect_, scene_, PinholeCamera(view_, size_.width, size_.height));
    cell_.shape = ViewCell::Shape::kSphere;
    cell_.sideRadii = choice.cell.empty() ? largestSide(senders_) : cellSideFromText(choice.cell, "--cell");
    reference_.emplace(referenceView(scene_.cast, senders_, referenceSize_.width, referenceSize_.height),
                       referenceSize_.width, referenceSize_.height);
  }

  void run() {
    if (!choice_.comparesAnything()) {
      const BuiltProxy built = build(choice_.by.front());
      write(shade(rays_, *built.proxy));
      return;
    }
    const BuiltProxy truth = build(kTraced);
    const ShadedPicture traced = shade(rays_, *truth.proxy, choice_.runs);
    add(truth, traced, traced);
    for (const std::string& name : choice_.by) {
      if (name == kTraced) {
        if (!choice_.output.empty()) {
          write(traced);
        }
        continue;
      }
      const BuiltProxy built = build(name);
      const ShadedPicture picture = shade(rays_, *built.proxy, choice_.runs);
      add(built, traced, picture);
      if (!choice_.output.empty()) {
        write(picture);
      }
    }
    writeReport();
  }

 private:
  static constexpr uint32_t kBrightestSteps = 48;  ///< the text's mean at fine steps

  BuiltProxy build(const std::string& name) const {
    const Progress progress = context_.progress();
    return buildProxy(name, {scene_, senders_.center(), *reference_, cell_, choice_.environmentHeight, progress});
  }

  void write(const ShadedPicture& picture) const {
    writePng(choice_.output, srgbFromLinear(picture.color));
    context_.note("wrote " + choice_.output);
  }

  void add(const BuiltProxy& built, const ShadedPicture& traced, const ShadedPicture& picture) {
    rows_.push_back(figuresOf(built, rays_, traced, picture, *reference_));
    images_.push_back(shadeImageNames(rows_.back(), rows_.size() - 1));
    if (choice_.page.empty()) {
      return;
    }
    const fs::path folder = choice_.page;
    writePng(folder / images_.back().picture, srgbFromLinear(picture.color));
    if (!images_.back().errors.empty()) {
      writePng(folder / images_.back().errors,
               hitErrorImage(rays_, traced, compareHits(rays_, traced, picture, *reference_)));
    }
    if (!images_.back().steps.empty()) {
      writePng(folder / images_.back().steps, stepImage(rays_, picture, kBrightestSteps));
    }
  }

  void writeReport() const {
    const ShadeReport report{.scene = choice_.scene.source,
                             .effect = effect_.name,
                             .version = OCELLI_VERSION,
                             .view = view_,
                             .size = {size_.width, size_.height},
                             .referenceView = reference_->view(),
                             .referenceSize = {referenceSize_.width, referenceSize_.height},
                             .cellSide = cell_.sideRadii,
                             .environmentHeight = choice_.environmentHeight,
                             .runs = choice_.runs,
                             .rows = rows_};
    context_.print(choice_.jsonToStandardOutput() ? shadeJson(report) : shadeTable(report));
    if (!choice_.json.empty() && !choice_.jsonToStandardOutput()) {
      writeFile(choice_.json, shadeJson(report));
    }
    if (!choice_.csv.empty()) {
      writeFile(choice_.csv, shadeCsv(report));
    }
    if (!choice_.page.empty()) {
      const fs::path page = fs::path(choice_.page) / "index.html";
      writeFile(page, shadePage(report, images_, kBrightestSteps));
      context_.note("wrote " + page.string());
    }
  }

  const ShadeChoice& choice_;
  const CommandContext& context_;
  const Effect& effect_;
  ImageSize size_;
  ImageSize referenceSize_;
  View view_;
  ShadedScene scene_;
  SecondaryRays rays_;
  Box senders_;
  ViewCell cell_;
  std::optional<PinholeCamera> reference_;
  std::vector<ShadeFigures> rows_;
  std::vector<ShadeImages> images_;
};

std::string effectHelp() {
  std::string text;
  for (const Effect& effect : shadeEffects()) {
    text += fmt::format("{}{}: {}", text.empty() ? "" : "; ", effect.name, effect.description);
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
  command
      .add_option(
          "--by", choice->by,
          "What stands for the scene where rays go on: traced (the geometry), environment (an environment map), "
          "or the reference images of a camera: a name or a JSON file. Several with --compare or --page")
      ->required()
      ->delimiter(',')
      ->type_name("NAME,...");
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
