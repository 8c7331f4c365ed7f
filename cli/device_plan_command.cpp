// `ocelli device plan`: which rate a scene gets on a link to a display, and why.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <nlohmann/json.hpp>

#include "cli/command.h"
#include "cli/device_command.h"
#include "cli/scene_options.h"
#include "display_driver/wire/bandwidth_plan.h"
#include "display_sim/slicing/slicer.h"
#include "oc_core/base/conventions.h"
#include "oc_core/base/error.h"
#include "oc_core/base/json_fields.h"
#include "oc_core/base/parallel.h"
#include "oc_core/camera/pinhole_camera.h"
#include "oc_core/ocri/camera_choice.h"
#include "oc_core/ocri/union_mesh.h"

namespace ocelli {
namespace {

using Json = nlohmann::ordered_json;
using wire::CodingPlan;
using wire::PlanLimit;
using wire::PlannedLink;

constexpr int kFrames = 4;  // that are planned with

struct PlanChoice {
  SceneChoice scene;
  std::string link;
  std::string profile = "perspecta";
  double rate = 0;
  double turnDegrees = 1;
  bool undithered = false;
  bool json = false;
};

/// A way to show the scene, and what it takes.
struct ScenePlan {
  std::string name;
  double sliceSeconds = 0;  ///< of a frame
  std::vector<CodingPlan> codings;
};

/// The scene as frames, turned about the axis by so much more each time.
ScenePlan planScene(const std::string& name, const Mesh& mesh, const DisplayProfile& profile, const PlanChoice& choice,
                    bool undithered) {
  ScenePlan plan{name, 0, {}};
  wire::BandwidthPlanner planner;
  Slicer slicer(profile, {.colors = undithered ? ColorReduction::kOccupancy : ColorReduction::kDither});
  const Mesh ordered = orderedForSlicing(mesh);
  SliceMesh turned(ordered);
  slicer.slice(turned);  // takes its memory
  for (int i = 0; i < kFrames; ++i) {
    const float radians = static_cast<float>(radiansFromDegrees(i * choice.turnDegrees));
    const glm::mat3 turn(glm::rotate(glm::mat4(1), radians, glm::vec3(0, 1, 0)));
    std::vector<glm::vec3> positions = ordered.positions;
    for (glm::vec3& position : positions) {
      position = turn * position;
    }
    turned.setPositions(positions);
    const auto start = std::chrono::steady_clock::now();
    const Volume& volume = slicer.slice(turned);
    plan.sliceSeconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() / kFrames;
    planner.add(volume);
  }
  plan.codings = planner.plans();
  return plan;
}

std::string codingName(const CodingPlan& plan) {
  return fmt::format("{}, {}", wire::nameOf(plan.coding), plan.changes ? "changes" : "whole frames");
}

std::string codingTable(const ScenePlan& plan, const PlannedLink& link, double rate) {
  std::string text = fmt::format("{:<26} {:>7} {:>12} {:>9} {:>10} {:>9} {:>8}  {}\n", "coding", "slices", "KB a frame",
                                 "overhead", "coding ms", "link Hz", "rate Hz", "limit");
  for (const CodingPlan& coding : plan.codings) {
    text += fmt::format("{:<26} {:>7.0f} {:>12.1f} {:>7.1f} % {:>10.2f} {:>9.1f} {:>8.1f}  {}\n", codingName(coding),
                        coding.slices, coding.bytes() / 1000, 100 * coding.overheadBytes / coding.bytes(),
                        1000 * coding.codingSeconds, coding.linkHertz(link), coding.hertz(link),
                        wire::nameOf(coding.limit(link, rate)));
  }
  return text;
}

std::string verdict(const CodingPlan& best, const PlannedLink& link, double rate) {
  const double use = 100 * rate * best.bytes() / link.bytesPerSecond;
  const std::string few = fmt::format(
      "The link carries {:.3g} of {:.3g} frames a second at best, with {}: ", best.hertz(link), rate, codingName(best));
  switch (best.limit(link, rate)) {
    case PlanLimit::kNone:
      return fmt::format("The link carries all {:.3g} frames a second with {}, and {} of it is in use.\n", rate,
                         codingName(best), use < 1 ? "less than 1 %" : fmt::format("{:.0f} %", use));
    case PlanLimit::kLink:
      return fmt::format("{}it would have to carry {:.3g} MB/s.\n", few, rate * best.bytes() / 1e6);
    case PlanLimit::kOverhead:
      return fmt::format("{}it would carry the slices, but not the headers of their messages as well.\n", few);
    case PlanLimit::kCoding:
      return fmt::format("{}this machine does not code them faster, and the link would carry {:.3g}.\n", few,
                         best.linkHertz(link));
  }
  return "";
}

/// Both take all threads.
std::string processorSentence(const ScenePlan& plan, const CodingPlan& best) {
  return fmt::format(
      "A scene that moves is sliced anew: slicing takes {:.1f} ms and coding {:.1f} ms of a frame on this "
      "machine, so that it makes {:.3g} frames a second.\n",
      1000 * plan.sliceSeconds, 1000 * best.codingSeconds, 1 / (plan.sliceSeconds + best.codingSeconds));
}

/// What may help, as the scene would be then.
std::vector<ScenePlan> alternatives(const Mesh& mesh, const DisplayProfile& profile, const PlanChoice& choice,
                                    const CommandContext& context) {
  std::vector<ScenePlan> plans;
  if (profile.colorBitsPerChannel > 1) {
    DisplayProfile fewer = profile;
    fewer.colorBitsPerChannel = 1;
    plans.push_back(planScene("1 bit a channel", mesh, fewer, choice, choice.undithered));
  }
  if (!choice.undithered) {
    plans.push_back(planScene("--undithered", mesh, profile, choice, true));
  }
  if (profile.width >= 4 && profile.height >= 2) {
    DisplayProfile coarser = profile;
    coarser.width /= 2;
    coarser.height /= 2;
    plans.push_back(planScene("half the columns and rows", mesh, coarser, choice, choice.undithered));
  }
  try {
    const PinholeCamera reference(View(), kDefaultWidth, kDefaultHeight);
    const Mesh ocri = unionMesh(buildReferenceImages(cameraChoice("ddoc"), reference, mesh, context.progress()));
    plans.push_back(planScene("its OCRI (ddoc)", ocri, profile, choice, choice.undithered));
  } catch (const InputError& error) {
    context.note(fmt::format("this scene has no OCRI to plan with: {}", error.what()));
  }
  return plans;
}

Json jsonOf(const ScenePlan& plan, const PlannedLink& link, double rate) {
  Json codings = Json::array();
  for (const CodingPlan& coding : plan.codings) {
    codings.push_back({{"coding", wire::nameOf(coding.coding)},
                       {"changes", coding.changes},
                       {"slices", coding.slices},
                       {"payload_bytes", coding.payloadBytes},
                       {"overhead_bytes", coding.overheadBytes},
                       {"coding_ms", 1000 * coding.codingSeconds},
                       {"link_hertz", coding.linkHertz(link)},
                       {"hertz", coding.hertz(link)},
                       {"limit", wire::nameOf(coding.limit(link, rate))}});
  }
  return {{"name", plan.name}, {"slice_ms", 1000 * plan.sliceSeconds}, {"codings", codings}};
}

void run(const PlanChoice& choice, const CommandContext& context) {
  const PlannedLink link = wire::plannedLink(choice.link);
  const DisplayProfile profile = loadProfile(choice.profile);
  if (!(choice.rate >= 0 && choice.rate <= 1e6)) {
    throw InputError("there must be between 0 and 1000000 frames in a second", "--rate", "--rate 24");
  }
  if (!(std::abs(choice.turnDegrees) <= 360)) {
    throw InputError("a frame turns by 360 degrees at the most", "--turn", "--turn 1");
  }
  const double rate = choice.rate > 0 ? choice.rate : profile.refreshHertz();
  const Mesh mesh = loadScene(choice.scene.source, choice.scene.options, context.progress());
  const ScenePlan plan = planScene(choice.scene.source, mesh, profile, choice, choice.undithered);
  const CodingPlan& best = wire::bestPlan(plan.codings, link, rate);
  const bool reached = best.limit(link, rate) == PlanLimit::kNone;
  const std::vector<ScenePlan> others =
      reached ? std::vector<ScenePlan>() : alternatives(mesh, profile, choice, context);
  if (choice.json) {
    Json json = {{"scene", choice.scene.source},
                 {"profile", profile.name},
                 {"link", link.name},
                 {"link_bytes_per_second", link.bytesPerSecond},
                 {"wanted_hertz", rate},
                 {"turn_degrees", choice.turnDegrees},
                 {"reached", reached},
                 {"threads", threadCount()},
                 {"plan", jsonOf(plan, link, rate)},
                 {"alternatives", Json::array()}};
    for (const ScenePlan& other : others) {
      json["alternatives"].push_back(jsonOf(other, link, rate));
    }
    context.print(textOfJson(json, 2) + "\n");
    return;
  }
  std::string text = fmt::format("{} on {}, turning by {:g} degrees a frame; {}: {:.3g} MB/s\n\n", choice.scene.source,
                                 profile.name, choice.turnDegrees, link.name, link.bytesPerSecond / 1e6);
  text += codingTable(plan, link, rate) + "\n" + verdict(best, link, rate);
  text += choice.turnDegrees == 0 ? "" : processorSentence(plan, best);
  if (!others.empty()) {
    text += fmt::format("\n{:<32} {:>12} {:>8}  {}\n", "what may help", "KB a frame", "rate Hz", "with");
    for (const ScenePlan& other : others) {
      const CodingPlan& coding = wire::bestPlan(other.codings, link, rate);
      text += fmt::format("{:<32} {:>12.1f} {:>8.1f}  {}{}\n", other.name, coding.bytes() / 1000, coding.hertz(link),
                          codingName(coding), coding.hertz(link) >= rate ? ": enough" : "");
    }
  }
  context.print(text);
}

}  // namespace

void addDevicePlan(CLI::App& device, const CommandContext& context) {
  CLI::App& command = *device.add_subcommand("plan", "Tell which rate a scene gets on a link to a display, and why");
  const auto choice = std::make_shared<PlanChoice>();
  addSceneOptions(command, choice->scene, context);
  command.add_option("--link", choice->link, "What it is sent over: 40 MB/s, 400 MB/s, or so many bytes a second")
      ->type_name("usb2|usb3|NUMBER")
      ->required();
  command.add_option("--profile", choice->profile, "The display: a name, or a profile of your own")
      ->type_name("NAME|FILE.json");
  command.add_option("--rate", choice->rate, "Frames a second; 0: as often as the display is refreshed")
      ->type_name("HZ");
  command.add_option("--turn", choice->turnDegrees, "How far the scene turns about the axis from frame to frame")
      ->type_name("DEGREES");
  command.add_flag("--undithered", choice->undithered, "Light a channel wherever it has any light at all");
  command.add_flag("--json", choice->json, "Print the figures as JSON");
  context.finish(command,
                 "  ocelli device plan builtin:teapot --link usb2\n"
                 "  ocelli device plan bunny.obj --link 25e6 --profile vortex --turn 5\n"
                 "  ocelli device plan builtin:statues --link usb3 --rate 12 --json",
                 [choice, context] { run(*choice, context); });
}

}  // namespace ocelli
