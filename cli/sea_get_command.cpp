// `ocelli sea get`: one image of a sea, or a view from between its images.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <glm/geometric.hpp>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "cli/output_option.h"
#include "cli/sea_command.h"
#include "cli/values.h"
#include "oc_core/base/conventions.h"
#include "oc_core/base/error.h"
#include "oc_core/base/json_document.h"
#include "oc_core/base/output_file.h"
#include "oc_core/sea/sea_between.h"
#include "oc_core/sea/sea_file.h"

namespace ocelli {
namespace {

using Json = nlohmann::ordered_json;

struct SeaGetChoice {
  std::string file;
  std::optional<int64_t> image;
  std::string name;
  std::string at;
  std::string near;
  double yaw = 0;
  std::string output;
  std::string json;
};

uint32_t imageCalled(const SeaFile& sea, const std::string& name, const std::string& file) {
  const std::vector<std::string> names = sea.names();
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) {
    throw InputError("no image of this sea is called \"" + name + "\"", file,
                     names.empty() ? "its images have numbers alone: give --image" : "see the names of its source");
  }
  return static_cast<uint32_t>(found - names.begin());
}

uint32_t nearestImage(const SeaFile& sea, const std::string& place) {
  const glm::dvec3 point(pointFromText(place, "--near"));
  return nearestNeighbors(sea.positions(), point).front().image;
}

uint32_t chosenImage(const SeaFile& sea, const SeaGetChoice& choice) {
  if (!choice.name.empty()) {
    return imageCalled(sea, choice.name, choice.file);
  }
  if (!choice.near.empty()) {
    return nearestImage(sea, choice.near);
  }
  const int64_t image = *choice.image;
  if (image < 0 || image >= int64_t{sea.count()}) {
    throw InputError(fmt::format("this sea has the images 0 to {}", sea.count() - 1), fmt::format("--image {}", image),
                     "choose one of these");
  }
  return static_cast<uint32_t>(image);
}

void runGet(const SeaGetChoice& choice, const CommandContext& context) {
  const int ways = (choice.image ? 1 : 0) + (choice.name.empty() ? 0 : 1) + (choice.at.empty() ? 0 : 1) +
                   (choice.near.empty() ? 0 : 1);
  if (ways != 1) {
    throw InputError("one image is asked for by its number, its name or a place", "sea get",
                     "give one of --image, --name, --near and --at");
  }
  checkWritable(choice.output);
  checkFiguresOutput(choice.json, choice.output);
  const SeaFile sea(choice.file);
  const auto start = std::chrono::steady_clock::now();
  Image<Rgb8> image;
  Json figures;
  if (choice.at.empty()) {
    const uint32_t number = chosenImage(sea, choice);
    image = sea.image(number);
    const SeaFile::Stored stored = sea.stored(number);
    const glm::dvec3 position = sea.pose(number).position;
    figures = {{"image", number},
               {"position", {position.x, position.y, position.z}},
               {"additions", stored.additions},
               {"bytes_read", sea.bytesToRead(number)},
               {"bytes_to_open", sea.bytesToOpen()}};
  } else {
    const SeaPose pose{glm::dvec3(pointFromText(choice.at, "--at")),
                       glm::angleAxis(radiansFromDegrees(choice.yaw), glm::dvec3(0, 1, 0))};
    image = sea.view(pose);
    Json from = Json::array();
    for (const SeaNeighbor& neighbor : nearestNeighbors(sea.positions(), pose.position)) {
      from.push_back({{"image", neighbor.image}, {"weight", neighbor.weight}});
    }
    figures = {{"from", from}};
  }
  const std::chrono::duration<double, std::milli> time = std::chrono::steady_clock::now() - start;
  figures["milliseconds"] = time.count();
  writePng(choice.output, image);
  context.note(fmt::format("wrote {}: {:.0f} ms to decode", choice.output, time.count()));
  giveFigures(choice.json, textOfJson(figures, 2) + "\n", "", context);
}

}  // namespace

void addSeaGetCommand(CLI::App& sea, const CommandContext& context) {
  CLI::App& command = *sea.add_subcommand("get", "Write one image of a sea, or a view from between its images");
  const auto choice = std::make_shared<SeaGetChoice>();
  command.add_option("SEA", choice->file, "The sea")->required()->type_name("FILE.sea");
  command.add_option("--image", choice->image, "An image by its number, from 0")->type_name("N");
  command.add_option("--name", choice->name, "An image by the name of its file")->type_name("TEXT");
  command.add_option("--near", choice->near, "The image that was taken nearest to a place")->type_name("X,Y,Z");
  command.add_option("--at", choice->at, "A view from any place: the nearest three images, warped there and blended")
      ->type_name("X,Y,Z");
  command.add_option("--yaw", choice->yaw, "Of that view: how far it is turned to the left")
      ->capture_default_str()
      ->type_name("DEGREES");
  addFiguresOption(command, choice->json);
  addOutputOption(command, choice->output, "Where the image goes", {".png"});
  context.finish(command,
                 "  ocelli sea get museum.sea --image 1200 -o image.png\n"
                 "  ocelli sea get museum.sea --at 1.25,1.6,-0.4 -o between.png",
                 [choice, context] { runGet(*choice, context); });
}

}  // namespace ocelli
