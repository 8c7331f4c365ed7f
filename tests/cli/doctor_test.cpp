// `ocelli doctor`: what it says where OpenGL works, where a part of it does not, and where nothing does.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/base/temporary_folder.h"
#include "tests/cli/run_program.h"

namespace ocelli::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

nlohmann::json findings(const std::string& environment) {
  const ProgramResult result = runShell(environment + " \"$OCELLI\" doctor --json");
  EXPECT_EQ(result.exitCode, 0) << result.error;
  return nlohmann::json::parse(result.output);
}

TEST(Doctor, tellsOfTheMachine) {
  const nlohmann::json json = findings("");
  EXPECT_EQ(json.at("version"), OCELLI_VERSION);
  EXPECT_GE(json.at("processor").at("threads"), 1);
  EXPECT_GT(json.at("memory").at("bytes"), json.at("memory").at("available_bytes"));
  const ProgramResult text = runProgram("doctor");
  EXPECT_EQ(text.exitCode, 0);
  EXPECT_THAT(text.output, AllOf(HasSubstr("Ocelli " OCELLI_VERSION), HasSubstr(" threads"), HasSubstr(" GiB"),
                                 HasSubstr("OpenGL: ")));
}

TEST(Doctor, tellsOfSurfacesOfVolumes) {
  const bool isBuilt = findings("").at("isosurfaces").at("built");
  EXPECT_THAT(runProgram("doctor").output,
              HasSubstr(isBuilt ? "of volumes: work (--iso)" : "apt-get install libopenvdb-dev"));
}

TEST(Doctor, tellsOfFeeds) {
  const nlohmann::json feeds = findings("OCELLI_FEEDS_PROGRAM=/bin/true").at("feeds");
  EXPECT_EQ(feeds.at("works"), true) << feeds;
  EXPECT_EQ(feeds.at("program"), "/bin/true");
  EXPECT_EQ(findings("OCELLI_FEEDS_PROGRAM=/bin/false").at("feeds").at("works"), false);
  EXPECT_THAT(runShell("OCELLI_FEEDS_PROGRAM=/nowhere/it \"$OCELLI\" doctor").output,
              AllOf(HasSubstr("\n  feeds       do not work\n"), HasSubstr("/nowhere/it")));
}

TEST(Doctor, tellsOfUsb) {
  const nlohmann::json usb = findings("").at("usb");
  EXPECT_GE(usb.at("displays"), 0);
  EXPECT_THAT(runProgram("doctor").output, HasSubstr("\n  usb  "));
}

#ifdef OCELLI_WITH_EMULATOR

TEST(Doctor, tellsOfTheEmulator) {
  const nlohmann::json emulator = findings("").at("usb_emulator");
  EXPECT_EQ(emulator.at("built"), true);
  EXPECT_EQ(emulator.at("works"), true) << emulator;
  EXPECT_THAT(runProgram("doctor").output, HasSubstr("\n  emulator    works"));
}

TEST(Doctor, namesThePackageOfTheEmulator) {
  const TemporaryFolder folder;
  folder.write("libumockdev-preload.so.0", "no library");
  const std::string environment = "LD_LIBRARY_PATH=" + folder.path().string();
  const nlohmann::json emulator = findings(environment).at("usb_emulator");
  EXPECT_EQ(emulator.at("works"), false);
  EXPECT_THAT(emulator.at("problem").get<std::string>(), HasSubstr("apt-get install umockdev)"));
  EXPECT_THAT(runShell(environment + " \"$OCELLI\" doctor").output,
              AllOf(HasSubstr("\n  emulator    does not work\n"), HasSubstr("apt-get install umockdev)")));
  const ProgramResult emulate = runShell(environment + " \"$OCELLI\" device emulate -- true");
  EXPECT_EQ(emulate.exitCode, 1);
  EXPECT_THAT(emulate.error, AllOf(HasSubstr("libumockdev-preload.so.0"), HasSubstr("apt-get install umockdev)")));
}

#endif

TEST(Doctor, findsProgramsOnThePath) {
  const TemporaryFolder folder;
  EXPECT_TRUE(findings("PATH=" + folder.path().string()).at("ffmpeg").is_null());
  std::filesystem::permissions(folder.write("ffmpeg", "#!/bin/sh\n"), std::filesystem::perms::owner_all);
  EXPECT_EQ(findings("PATH=" + folder.path().string()).at("ffmpeg"), (folder / "ffmpeg").string());
}

TEST(Doctor, refusesWhatItDoesNotKnow) {
  EXPECT_EQ(runProgram("doctor --gpu").exitCode, 2);
  EXPECT_EQ(runProgram("doctor bunny.ply").exitCode, 2);
}

#ifdef OCELLI_WITH_OPENGL

TEST(Doctor, tellsOfEveryProvider) {
  const nlohmann::json json = findings("");
  EXPECT_EQ(json.at("built_with_opengl"), true);
  ASSERT_EQ(json.at("providers").size(), 3u);
  for (const nlohmann::json& provider : json.at("providers")) {
    if (provider.at("works")) {
      EXPECT_THAT(provider.at("version").get<std::string>(), Not(IsEmpty()));
      EXPECT_THAT(provider.at("renderer").get<std::string>(), Not(IsEmpty()));
      EXPECT_GE(provider.at("max_texture_size"), 16384);  // what OpenGL 4.5 promises
    } else {
      EXPECT_THAT(provider.at("error").get<std::string>(), HasSubstr("try: "));
    }
  }
}

TEST(Doctor, withoutADisplayEverythingButTheWindowIsAsBefore) {
  const nlohmann::json before = findings("");
  const nlohmann::json json = findings("env -u DISPLAY");
  EXPECT_EQ(json.at("providers").at(0), before.at("providers").at(0));
  EXPECT_EQ(json.at("providers").at(1), before.at("providers").at(1));
  const nlohmann::json& window = json.at("providers").at(2);
  EXPECT_EQ(window.at("provider"), "window");
  EXPECT_EQ(window.at("works"), false);
  EXPECT_THAT(window.at("error").get<std::string>(), HasSubstr("set DISPLAY"));
}

/// Libraries that cannot be opened stand before those of the system.
class DoctorWithoutLibraries : public testing::Test {
 protected:
  DoctorWithoutLibraries() {
    folder_.write("libEGL.so.1", "no library");
    folder_.write("libOSMesa.so.8", "no library");
  }
  std::string environment() const { return "env -u DISPLAY LD_LIBRARY_PATH=" + folder_.path().string(); }

  TemporaryFolder folder_;
};

TEST_F(DoctorWithoutLibraries, saysThatOpenGlIsNotAvailableAndWhatToInstall) {
  const nlohmann::json json = findings(environment());
  EXPECT_EQ(json.at("opengl"), false);
  EXPECT_THAT(json.at("providers").at(0).at("error").get<std::string>(),
              AllOf(HasSubstr("libEGL.so.1"), HasSubstr("install libegl1")));
  EXPECT_THAT(json.at("providers").at(1).at("error").get<std::string>(),
              AllOf(HasSubstr("libOSMesa.so.8"), HasSubstr("install libosmesa6")));
  const ProgramResult text = runShell(environment() + " \"$OCELLI\" doctor");
  EXPECT_EQ(text.exitCode, 0);
  EXPECT_THAT(text.output,
              AllOf(HasSubstr("OpenGL: not available"), HasSubstr("on the CPU"),
                    HasSubstr("apt-get install --no-install-recommends libegl1 libgl1 libgl1-mesa-dri libosmesa6\n")));
}

TEST_F(DoctorWithoutLibraries, theProcessorStillDoesTheWork) {
  const std::string image = (folder_ / "picture.png").string();
  const ProgramResult result = runShell(environment() + " \"$OCELLI\" render builtin:teapot --size 36x24 -o " + image);
  EXPECT_EQ(result.exitCode, 0) << result.error;
  EXPECT_TRUE(std::filesystem::exists(image));
}

#else

TEST(Doctor, saysThatItWasBuiltWithoutOpenGl) {
  EXPECT_EQ(findings("").at("built_with_opengl"), false);
  EXPECT_THAT(findings("").at("providers"), IsEmpty());
  EXPECT_THAT(runProgram("doctor").output, HasSubstr("OpenGL: not available, for this program was built without it"));
}

#endif

}  // namespace
}  // namespace ocelli::test
