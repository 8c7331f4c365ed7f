#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string_view>
#include <system_error>

#include "cli/command.h"
#include "cli/effect_options.h"
#include "cli/gl_drawing.h"
#include "cli/output_option.h"
#include "cli/scene_options.h"
#include "cli/values.h"
#include "oc_core/base/error.h"
#include "oc_core/base/file_bytes.h"
#include "oc_core/base/output_file.h"
#include "oc_core/shade/prepared_effect.h"
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
  std::string imageSize;
  std::string cell;
  int environmentHeight = 1024;
  std::map<std::string, std::string> options;  ///< of effects, by name; empty where not given
  int runs = 1;
  bool compares = false;
  std::string json;
  std::string csv;
  std::string page;
  std::string output;
  std::string gl;  ///< empty: the CPU casts all rays

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

EffectRequest requestOf(const ShadeChoice& choice) {
  EffectRequest request{.source = choice.scene.source,
                        .effect = choice.effect,
                        .ways = choice.by,
                        .roles = choice.roles,
                        .environmentHeight = choice.environmentHeight,
                        .options = choice.options,
                        .scene = choice.scene.options};
  const ImageSize size = imageSizeFromText(choice.size, "--size");
  request.size = {size.width, size.height};
  if (!choice.imageSize.empty()) {
    const ImageSize given = imageSizeFromText(choice.imageSize, "--image-size");
    request.referenceSize = glm::ivec2(given.width, given.height);
  }
  if (!choice.cell.empty()) {
    request.cellSide = cellSideFromText(choice.cell, "--cell");
  }
  if (!choice.view.empty()) {
    request.view = readViewOption(choice.view);
  }
  return request;
}

class ShadeRun {
 public:
  ShadeRun(const ShadeChoice& choice, const CommandContext& context)
      : choice_(choice),
        context_(context),
        effect_(shadeEffect(choice.effect)),
        prepared_(prepareEffect(requestOf(choice), openCaster(), context.progress())) {}

  void run() {
    if (!choice_.comparesAnything()) {
      write(prepared_.stage->build(choice_.by.front())->draw(prepared_.camera));
      return;
    }
    ShadeReport report{.scene = choice_.scene.source,
                       .effect = effect_,
                       .version = OCELLI_VERSION,
                       .view = prepared_.camera.view(),
                       .size = {prepared_.camera.width(), prepared_.camera.height()},
                       .runs = choice_.runs};
    std::vector<std::string> ways{kTraced};
    for (const std::string& way : choice_.by) {
      if (way != kTraced) {
        ways.push_back(way);
      }
    }
    for (const std::string& way : ways) {
      report.ways.push_back(prepared_.stage->measure(way, prepared_.camera, choice_.runs));
      if (!choice_.output.empty() && way == choice_.by.front()) {
        write(report.ways.back().picture);
      }
    }
    report.facts = prepared_.stage->facts(prepared_.camera);
    write(report);
  }

 private:
  /// Before the scene is loaded, so that a machine without OpenGL says so at once.
  std::shared_ptr<const DepthRayCaster> openCaster() const {
    if (choice_.gl.empty()) {
      return nullptr;
    }
    if (effect_.castsOnDevice == nullptr || std::none_of(choice_.by.begin(), choice_.by.end(), effect_.castsOnDevice)) {
      throw InputError("no ray is cast with OpenGL here", "--gl " + choice_.gl,
                       "give a camera with --by, and an effect whose rays are cast at its images, or leave --gl out");
    }
    std::shared_ptr<const DepthRayCaster> caster = openRayCaster(choice_.gl);
    context_.note("casting rays at depth images with " + caster->description());
    return caster;
  }

  void write(const Image<glm::vec3>& picture) const {
    writePng(choice_.output, srgbFromLinear(picture));
    context_.note("wrote " + choice_.output);
  }

  void write(const ShadeReport& report) const {
    giveFigures(choice_.json, shadeJson(report), shadeTable(report), context_);
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
  PreparedEffect prepared_;
};

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

/// Each option of the effects once, however many have it.
void addEffectOptions(CLI::App& command, ShadeChoice& choice) {
  for (const Effect& effect : shadeEffects()) {
    for (const EffectOption& option : effect.options) {
      if (choice.options.contains(option.name)) {
        continue;
      }
      std::string of;
      for (const Effect& other : shadeEffects()) {
        const bool has = std::any_of(other.options.begin(), other.options.end(), [&](const EffectOption& each) {
          return std::string_view(each.name) == option.name;
        });
        of += has ? (of.empty() ? "" : ", ") + std::string(other.name) : "";
      }
      command
          .add_option("--" + std::string(option.name), choice.options[option.name],
                      fmt::format("{} ({} by default). For {}", option.meaning, option.initial, of))
          ->type_name(option.values);
    }
  }
}

}  // namespace

void addShadeCommand(CLI::App& program, const CommandContext& context) {
  CLI::App& command = *program.add_subcommand(
      "shade", "Draw reflections, shadows and other effects by reference images, and compare them with traced ones");
  const auto choice = std::make_shared<ShadeChoice>();
  addSceneOptions(command, choice->scene, context);
  addRolesOption(command, choice->roles);
  command.add_option("--effect", choice->effect, effectHelp())->type_name("NAME");
  command.add_option("--by", choice->by, waysHelp())->required()->delimiter(',')->type_name("NAME,...");
  command
      .add_option("--view", choice->view,
                  "View of the picture; by default from (0, 0, 10) to what sends the rays, and as wide as that")
      ->type_name("FILE.json");
  addSizeOption(command, choice->size);
  command
      .add_option(
          "--image-size", choice->imageSize,
          "Size of the reference images in pixels; 720x480 by default, and for relief 512x512, which says how many "
          "pixels an image has, in the proportions of its object")
      ->type_name("WIDTHxHEIGHT");
  command
      .add_option(
          "--cell", choice->cell,
          "Size of the cell of viewpoints that the reference images are made for, as for evaluate; by default as "
          "wide as the rays are at the reference view, or as large as what sends them")
      ->type_name("SIDE");
  command
      .add_option("--environment-height", choice->environmentHeight,
                  "Rows of environment maps, which have twice as many columns")
      ->check(CLI::Range(2, 16384))
      ->type_name("N");
  addEffectOptions(command, *choice);
  command.add_flag("--compare", choice->compares, "Compare with the traced picture and print a table");
  command.add_option("--runs", choice->runs, "How often the rays are timed; the best counts")
      ->check(CLI::Range(1, 1000))
      ->type_name("N");
  addFiguresOption(command, choice->json);
  command.add_option("--csv", choice->csv, "Also write the figures here, a line a way")->type_name("FILE");
  command.add_option("--page", choice->page, "Also make a page with pictures and error maps in this folder")
      ->type_name("DIR");
  addGlSwitch(command, choice->gl,
              "Cast rays at depth images with OpenGL, and compare what they hit with what they hit on the CPU");
  addSecondOutputOption(command, "-o,--output", choice->output, "Where the picture goes", {".png"});
  context.finish(command,
                 "  ocelli shade builtin:mirror --by ddoc -o reflection.png\n"
                 "  ocelli shade builtin:mirror,mesh=bunny.obj --by environment,di,ddoc,cell --compare --page mirror\n"
                 "  ocelli shade builtin:lens --effect refraction --by di,cell --json lens.json\n"
                 "  ocelli shade dragon.obj --effect ambient --by horizon,graph,corners-8 --radius 0.4 --page ambient\n"
                 "  ocelli shade builtin:lamp --effect shadow --by outlines,eoc-hv,backprojection --page lamp\n"
                 "  ocelli shade builtin:parking --effect relief --by height-field,spoc,cell --page parking\n"
                 "  ocelli shade bunny.obj --roles around.roles.json --by spoc -o bunny.png",
                 [choice, context] {
                   checkOutputs(*choice);
                   ShadeRun(*choice, context).run();
                 });
}

}  // namespace ocelli
