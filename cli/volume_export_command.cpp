// The forms that volumes are exported in, a row each: a new one needs nothing else.
#include "cli/volume_export_command.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <filesystem>
#include <optional>

#include "cli/interrupt.h"
#include "cli/values.h"
#include "display_sim/exports/export_kv6.h"
#include "display_sim/exports/export_nrrd.h"
#include "display_sim/exports/export_png.h"
#include "display_sim/exports/export_preview.h"
#include "display_sim/exports/export_vti.h"
#include "display_sim/frames/svol_file.h"
#include "display_sim/frames/svol_player.h"
#include "display_sim/observing/image_folder.h"
#include "oc_core/base/error.h"
#include "oc_core/base/output_file.h"

namespace ocelli {
namespace {

namespace fs = std::filesystem;

struct VolumeExportChoice {
  std::string volume;
  std::optional<int64_t> frame;
  std::string output;
  std::optional<int> cells;
  std::optional<int> pixels;
  std::string eachFrame;  ///< the name of a form; empty: one file
};

using WriteVolume = void (*)(const fs::path& path, const Volume& volume, const VolumeExportChoice& choice,
                             const Progress& progress);
using WriteRecording = void (*)(const fs::path& path, SvolReader& reader, const VolumeExportChoice& choice,
                                const Progress& progress);

struct VolumeForm {
  std::string_view name;
  std::string_view ending;                  ///< ".vti"; empty for folders
  bool hasCells = false;                    ///< --cells applies
  bool hasPixels = false;                   ///< --pixels applies
  WriteVolume writeVolume = nullptr;        ///< one frame
  WriteRecording writeRecording = nullptr;  ///< all frames, for forms that show them together

  bool canBeNumbered() const { return writeVolume != nullptr && !ending.empty(); }
};

void writeKv6(const fs::path& path, const Volume& volume, const VolumeExportChoice& choice, const Progress& progress) {
  const Kv6Options defaults;
  exportKv6(path, volume, {.cellsAcross = choice.cells.value_or(defaults.cellsAcross)}, progress);
}

void writeVti(const fs::path& path, const Volume& volume, const VolumeExportChoice& choice, const Progress& progress) {
  const VtiOptions defaults;
  exportVti(path, volume, {.cellsAcross = choice.cells.value_or(defaults.cellsAcross)}, progress);
}

void writeNrrd(const fs::path& path, const Volume& volume, const VolumeExportChoice&, const Progress& progress) {
  exportNrrd(path, volume, progress);
}

void writeSlices(const fs::path& path, const Volume& volume, const VolumeExportChoice&, const Progress& progress) {
  exportPngStack(path, volume, progress);
}

void writePreview(const fs::path& path, SvolReader& reader, const VolumeExportChoice& choice,
                  const Progress& progress) {
  const PreviewOptions defaults;
  exportPreview(path, reader, {.pixels = choice.pixels.value_or(defaults.pixels)}, progress);
}

constexpr std::array kForms{
    VolumeForm{.name = "vti", .ending = ".vti", .hasCells = true, .writeVolume = writeVti},
    VolumeForm{.name = "nrrd", .ending = ".nrrd", .writeVolume = writeNrrd},
    VolumeForm{.name = "kv6", .ending = ".kv6", .hasCells = true, .writeVolume = writeKv6},
    VolumeForm{.name = "png", .ending = ".png", .hasPixels = true, .writeRecording = writePreview},
    VolumeForm{.name = "slices", .ending = "", .writeVolume = writeSlices},
};
constexpr std::string_view kFormOfPipes = ".nrrd";

/// "vti, nrrd or kv6": `word` of the forms for which `holds`.
template <class Holds>
std::string listOfForms(std::string_view VolumeForm::*word, Holds&& holds) {
  std::vector<std::string_view> words;
  for (const VolumeForm& form : kForms) {
    if (holds(form)) {
      words.push_back(form.*word);
    }
  }
  std::string text;
  for (size_t i = 0; i < words.size(); ++i) {
    text += fmt::format("{}{}", i == 0 ? "" : i + 1 == words.size() ? " or " : ", ", words[i]);
  }
  return text;
}

std::string numberedForms() {
  return listOfForms(&VolumeForm::name, [](const VolumeForm& form) { return form.canBeNumbered(); });
}

const VolumeForm& formWith(std::string_view ending, const std::string& output) {
  const auto* const found = std::ranges::find(kForms, ending, &VolumeForm::ending);
  if (found == kForms.end()) {
    const std::string endings =
        listOfForms(&VolumeForm::ending, [](const VolumeForm& form) { return !form.ending.empty(); });
    throw InputError("volumes have no form with this ending", output,
                     fmt::format("a name that ends in {}, or a folder for PNG files", endings));
  }
  return *found;
}

const VolumeForm& formOf(const std::string& output) {
  const std::string extension = fs::path(output).extension();
  if (extension.empty() && isStream(output)) {
    return formWith(kFormOfPipes, output);
  }
  return formWith(fs::is_directory(output) ? "" : extension, output);
}

const VolumeForm& numberedForm(const VolumeExportChoice& choice) {
  const auto* const found = std::ranges::find(kForms, choice.eachFrame, &VolumeForm::name);
  if (found == kForms.end() || !found->canBeNumbered()) {
    throw InputError(fmt::format("frames cannot be written as \"{}\"", choice.eachFrame), "--each-frame",
                     numberedForms());
  }
  const fs::path output(choice.output);
  if (isStream(output) || (output.has_extension() && !fs::is_directory(output))) {
    throw InputError("a file for each frame needs a folder", choice.output, "-o FOLDER, without an ending");
  }
  return *found;
}

void refuseWhatDoesNotApply(const VolumeExportChoice& choice, const VolumeForm& form) {
  if (choice.frame && !choice.eachFrame.empty()) {
    throw InputError("either one frame or each of them is written", "--frame", "leave out --frame or --each-frame");
  }
  if (choice.frame && form.writeRecording != nullptr) {
    throw InputError("a preview shows all frames", "--frame", "leave it out, or write another form");
  }
  if (choice.cells && !form.hasCells) {
    const std::string endings =
        listOfForms(&VolumeForm::ending, [](const VolumeForm& other) { return other.hasCells; });
    throw InputError(fmt::format("only files that end in {} have cells to choose", endings), "--cells",
                     "leave it out, or write such a file");
  }
  if (choice.pixels && !form.hasPixels) {
    throw InputError("only a preview has a size to choose", "--pixels", "leave it out, or write a .png file");
  }
}

/// `frame_0000.kv6` and so on, in a folder that appears when all are there.
void exportEachFrame(const VolumeForm& form, const VolumeExportChoice& choice, const Progress& progress) {
  SvolReader reader(choice.volume);
  SvolPlayer player(reader);
  ImageFolder files(choice.output, "frame", std::string(form.ending));
  const size_t count = reader.frames().size();
  for (size_t k = 0; k < count; ++k) {
    report(progress, "writing frames", static_cast<double>(k) / static_cast<double>(count));
    player.seek(k);
    form.writeVolume(files.path(static_cast<int>(k)), player.volume(), choice, {});
  }
  files.finish();
  report(progress, "writing frames", 1);
}

void exportAs(const VolumeForm& form, const VolumeExportChoice& choice, const Progress& progress) {
  if (!choice.eachFrame.empty()) {
    exportEachFrame(form, choice, progress);
  } else if (form.writeRecording != nullptr) {
    SvolReader reader(choice.volume);
    form.writeRecording(choice.output, reader, choice, progress);
  } else {
    form.writeVolume(choice.output, readSvol(choice.volume, frameNumber(choice.frame.value_or(0), "--frame")), choice,
                     progress);
  }
}

void runVolumeExport(const VolumeExportChoice& choice, const CommandContext& context) {
  const VolumeForm& form = choice.eachFrame.empty() ? formOf(choice.output) : numberedForm(choice);
  refuseWhatDoesNotApply(choice, form);
  runOrLeaveNothing(choice.output, context.progress(),
                    [&](const Progress& progress) { exportAs(form, choice, progress); });
  context.note(fmt::format("wrote {}", choice.output));
}

}  // namespace

void addVolumeExport(CLI::App& parent, const CommandContext& context) {
  CLI::App& command = *parent.add_subcommand(
      "export", "Write a volume for ParaView, as NRRD, as a voxel model, as PNG files, or as an image that moves");
  const auto choice = std::make_shared<VolumeExportChoice>();
  command.add_option("VOLUME", choice->volume, "A volume or a recording (.svol)")->required();
  command.add_option("--frame", choice->frame, "Which frame of a recording, from 0")->type_name("NUMBER");
  command
      .add_option("--each-frame", choice->eachFrame,
                  fmt::format("Write a file for each frame of a recording into the folder of -o: {}", numberedForms()))
      ->type_name("FORM");
  command
      .add_option(
          "-o,--output", choice->output,
          "A file (.png: an animated preview), or a folder that gets a PNG file for each slice; NRRD into pipes")
      ->required()
      ->type_name("OUT.vti|OUT.nrrd|OUT.kv6|OUT.png|DIR");
  command.add_option("--cells", choice->cells, "Cells of a .vti or voxels of a .kv6 across the display")
      ->type_name("COUNT");
  command.add_option("--pixels", choice->pixels, "Sides of a preview")->type_name("COUNT");
  context.finish(command,
                 "  ocelli volume export teapot.svol -o slices\n"
                 "  ocelli volume export teapot.svol -o teapot.png\n"
                 "  ocelli volume export teapot.svol --cells 512 -o teapot.vti\n"
                 "  ocelli volume export film.svol --each-frame kv6 -o models",
                 [choice, context] { runVolumeExport(*choice, context); });
}

}  // namespace ocelli
