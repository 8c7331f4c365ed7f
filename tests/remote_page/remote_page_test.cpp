// The files of the page: they are all there, and refer to each other alone.
#include "oc_core/remote/page/remote_page.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <regex>
#include <set>

namespace ocelli {
namespace {

std::map<std::string, RemotePageFile> filesByPath() {
  std::map<std::string, RemotePageFile> files;
  for (const RemotePageFile& file : remotePageFiles()) {
    files[file.path] = file;
  }
  return files;
}

std::set<std::string> matches(const std::string& text, const char* pattern) {
  const std::regex expression(pattern);
  std::set<std::string> found;
  for (std::sregex_iterator each(text.begin(), text.end(), expression), end; each != end; ++each) {
    found.insert((*each)[1].str());
  }
  return found;
}

TEST(RemotePage, BeginsWithThePageItself) {
  ASSERT_FALSE(remotePageFiles().empty());
  EXPECT_EQ(remotePageFiles()[0].path, "/");
  EXPECT_EQ(remotePageFiles()[0].mediaType, "text/html; charset=utf-8");
  EXPECT_THAT(remotePageFiles()[0].bytes, testing::StartsWith("<!DOCTYPE html>"));
}

TEST(RemotePage, HasAllFilesThatItAsksForAndNoOthers) {
  const auto files = filesByPath();
  EXPECT_EQ(files.size(), remotePageFiles().size()) << "two files have one path";
  std::set<std::string> wanted{"/"};
  for (const auto& [path, file] : files) {
    for (const char* pattern :
         {R"re((?:href|src)="([^":]+)")re", R"re(from '\./([^']+)')re", R"re(new URL\('\./([^']+)')re"}) {
      for (const std::string& name : matches(file.bytes, pattern)) {
        wanted.insert("/" + name);
      }
    }
  }
  for (const std::string& path : wanted) {
    EXPECT_TRUE(files.contains(path)) << path << " is asked for, and not embedded: oc_core/remote/page/CMakeLists.txt";
  }
  for (const auto& [path, file] : files) {
    EXPECT_TRUE(wanted.contains(path)) << path << " is embedded, and nothing asks for it";
  }
}

TEST(RemotePage, AsksForNothingFromElsewhere) {
  for (const RemotePageFile& file : remotePageFiles()) {
    EXPECT_THAT(matches(file.bytes, "(https?://[^ '\"]*)"), testing::IsEmpty()) << file.path;
    EXPECT_THAT(file.bytes, testing::Not(testing::HasSubstr("style=\""))) << file.path << ": the server forbids that";
  }
}

TEST(RemotePage, SaysWhatItsFilesAre) {
  for (const RemotePageFile& file : remotePageFiles()) {
    const bool isScript = file.path.ends_with(".js");
    EXPECT_EQ(isScript, file.mediaType == "text/javascript; charset=utf-8") << file.path;
    EXPECT_EQ(file.path.ends_with(".css"), file.mediaType == "text/css; charset=utf-8") << file.path;
  }
}

TEST(RemotePage, HasTheColoursOfAllPages) {
  const auto files = filesByPath();
  const std::string& style = files.at("/remote.css").bytes;
  const std::set<std::string> defined = matches(style, "(--[a-z]+):");
  for (const std::string& name : matches(style, R"re(var\((--[a-z]+))re")) {
    EXPECT_TRUE(defined.contains(name)) << name;
  }
  EXPECT_TRUE(defined.contains("--accent"));
}

TEST(RemotePage, StylesOnlyWhatIsThere) {
  const auto files = filesByPath();
  std::string others;
  for (const auto& [path, file] : files) {
    others += path.ends_with(".css") ? "" : file.bytes;
  }
  for (const std::string& id : matches(files.at("/remote.css").bytes, R"re(#([a-z][a-z-]+)[ .:,{>)])re")) {
    EXPECT_THAT(others, testing::HasSubstr("id=\"" + id + "\""));
  }
}

}  // namespace
}  // namespace ocelli
