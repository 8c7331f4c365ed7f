// `ocelli remote serve`: a scene for browsers, which draw from images of general pinholes.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "cli/command.h"
#include "cli/remote_command.h"
#include "oc_core/base/error.h"

#ifdef OCELLI_WITH_REMOTE
#include <nlohmann/json.hpp>
#include <optional>
#include <thread>

#include "cli/interrupt.h"
#include "cli/number_check.h"
#include "cli/scene_options.h"
#include "oc_core/base/json_document.h"
#include "oc_core/base/steady_time.h"
#include "oc_core/remote/page/remote_page.h"
#include "oc_core/remote/server/listening_socket.h"
#include "oc_core/remote/server/remote_server.h"
#include "oc_core/remote/server/scene_draw.h"
#endif

namespace ocelli {

#ifdef OCELLI_WITH_REMOTE
namespace {

using ServeJson = nlohmann::ordered_json;

struct ServeChoice {
  SceneChoice scene;
  std::string view;
  RemoteSettings settings;
  RemoteServerSetup setup;
  std::string tokenFile;
  std::optional<double> seconds;
  bool json = false;
};

void addServerOptions(CLI::App& command, ServeChoice& choice) {
  constexpr int kDefaultPort = 8080;
  constexpr int kMaxPort = 65535;
  constexpr int kMaxDraws = 64;
  RemoteServerSetup& setup = choice.setup;
  setup.port = kDefaultPort;
  setup.drawThreads = 2;
  command.add_option("--port", setup.port, "Listen at this port; 0 takes any that is free")
      ->check(CLI::Range(0, kMaxPort))
      ->type_name("NUMBER");
  command
      .add_option(
          "--bind", setup.address,
          "Listen at this address, in digits; what is not loopback lets other computers in, and asks for a token")
      ->type_name("ADDRESS");
  command
      .add_option("--token-file", choice.tokenFile,
                  "Ask for the token in the first line of this file, at 127.0.0.1 too; otherwise a new one is printed")
      ->type_name("FILE");
  command
      .add_option("--host-name", setup.access.names,
                  "A name of this computer by which browsers may ask for it; may be given several times")
      ->type_name("NAME");
  command.add_option("--for", choice.seconds, "End after this time; otherwise at Ctrl-C")
      ->check(numberCheck(0, 1e9))
      ->type_name("SECONDS");
  command.add_option("--draws", setup.drawThreads, "Draw so many images at the same time, of different clients")
      ->check(CLI::Range(1, kMaxDraws))
      ->type_name("N");
  command
      .add_option("--rate", setup.link.bytesPerSecond, "Send each client no more than this; 0 is as fast as it goes")
      ->check(numberCheck(0, 1e12))
      ->type_name("BYTES_PER_SECOND");
  command.add_option("--delay", setup.link.delayMilliseconds, "Send everything so much later")
      ->check(numberCheck(0, 60'000))
      ->type_name("MS");
  command.add_flag("--json", choice.json, "Print the address and the summary as JSON, a line each");
  for (const RemoteLimitRow& row : remoteLimitRows()) {
    command.add_option(std::string("--") + row.name, setup.limits.*row.field, row.meaning)
        ->check(CLI::Range(row.min, row.max))
        ->type_name(row.unit)
        ->group("Limits");
  }
}

void chooseAccess(ServeChoice& choice) {
  AccessRules& access = choice.setup.access;
  if (!choice.tokenFile.empty()) {
    access.token = readTokenFile(choice.tokenFile);
  } else if (!isLoopbackAddress(choice.setup.address)) {
    access.token = newToken();
  }
  if (const std::string name = nameOfThisComputer(); !name.empty()) {
    access.names.push_back(name);
  }
}

void printAddress(const CommandContext& context, const ServeChoice& choice, const RemoteServer& server) {
  if (choice.json) {
    context.print(textOfJson({{"address", server.pageAddress()}, {"port", server.port()}}) + "\n");
  } else {
    context.print(fmt::format("{} is at {}\n", choice.scene.source, server.pageAddress()));
  }
  flushStandardOutput();
  context.note(choice.seconds ? fmt::format("Ctrl-C ends it, or {} seconds.", *choice.seconds) : "Ctrl-C ends it.");
}

void printSummary(const CommandContext& context, bool isJson, const RemoteServerCounts& counts) {
  if (isJson) {
    context.print(textOfJson({{"clients", counts.clients},
                              {"looks", counts.looks},
                              {"images", counts.images},
                              {"bytes_sent", counts.bytesSent},
                              {"refused", counts.refused}}) +
                  "\n");
  } else {
    context.print(fmt::format("{} clients, {} looks, {} images, {:.1f} MB sent, {} requests refused\n", counts.clients,
                              counts.looks, counts.images, static_cast<double>(counts.bytesSent) * 1e-6,
                              counts.refused));
  }
}

void serve(const CommandContext& context, ServeChoice& choice) {
  validate(choice.settings, "command line");
  chooseAccess(choice);
  const View view = readViewOption(choice.view);
  const RemoteScene scene(loadScene(choice.scene.source, choice.scene.options, context.progress()), choice.scene.source,
                          view);
  RemoteServerSetup setup = choice.setup;
  setup.hello = helloText(scene, choice.settings, setup.limits);
  setup.draw = sceneDraw(scene, choice.settings);
  for (const RemotePageFile& file : remotePageFiles()) {
    setup.assets.push_back({file.path, file.mediaType, file.bytes});
  }
  setup.note = [context](const std::string& line) { context.note(line); };
  const InterruptGuard guard;
  const RemoteServer server(std::move(setup));
  printAddress(context, choice, server);
  const int64_t begin = steadyNanoseconds();
  const double seconds = choice.seconds.value_or(1e18);
  while (!InterruptGuard::interrupted() && static_cast<double>(steadyNanoseconds() - begin) * 1e-9 < seconds) {
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
  printSummary(context, choice.json, server.counts());
}

}  // namespace

void addRemoteServe(CLI::App& remote, const CommandContext& context) {
  const auto choice = std::make_shared<ServeChoice>();
  CLI::App& command =
      *remote.add_subcommand("serve", "Serve a scene to browsers: a page, and the images that it asks for");
  addSceneOptions(command, choice->scene, context);
  addViewOption(command, choice->view);
  addServerOptions(command, *choice);
  addRemoteSettingsOptions(command, choice->settings);
  context.finish(command,
                 "  ocelli remote serve builtin:statues\n"
                 "  ocelli remote serve town.glb --bind 0.0.0.0 --port 9000 --token-file token.txt\n"
                 "  ocelli remote serve builtin:statues --port 0 --json --rate 300000 --delay 200 --for 60",
                 [choice, context] { serve(context, *choice); });
}

#else

void addRemoteServe(CLI::App& remote, const CommandContext& context) {
  CLI::App& command = *remote.add_subcommand("serve", "Serve a scene to browsers (this program was built without it)");
  command.allow_extras();
  context.finish(command, "  ocelli remote serve builtin:statues", [] {
    throw InputError("this program was built without libwebsockets", "ocelli remote serve",
                     "install libwebsockets-dev and build it with -DOCELLI_WITH_REMOTE=ON (docs/install.md)");
  });
}

#endif

}  // namespace ocelli
