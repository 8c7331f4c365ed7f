#include "oc_core/remote/remote_request.h"

#include <gtest/gtest.h>

#include "oc_core/base/error.h"

namespace ocelli {
namespace {

constexpr const char* kLook =
    R"({"type":"look","sequence":7,"view":{"eye":[0,1,5],"target":[0,0,0],"fov_vertical_degrees":40},)"
    R"("screen":[1280,720],"lenses":[{"center":[0.3,0.4],"extent":[0.2,0.3],"zoom":3,"transition_width":0.5}]})";

std::string replaced(const std::string& from, const std::string& to) {
  std::string text = kLook;
  const size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

TEST(RemoteRequest, IsReadAndWritten) {
  const RemoteRequest request = remoteRequestFromJson(kLook);
  EXPECT_EQ(request.sequence, 7u);
  EXPECT_EQ(request.view.eye, glm::vec3(0, 1, 5));
  EXPECT_EQ(request.screen, glm::ivec2(1280, 720));
  ASSERT_EQ(request.lenses.size(), 1u);
  EXPECT_EQ(request.lenses[0], (GpcRegion{{0.3f, 0.4f}, {0.2f, 0.3f}, 3, 0.5f}));
  EXPECT_EQ(remoteRequestFromJson(jsonText(request)), request);
  EXPECT_TRUE(remoteRequestFromJson(replaced(R"(,"lenses":[{"center":[0.3,0.4],"extent":[0.2,0.3],"zoom":3,)"
                                             R"("transition_width":0.5}])",
                                             ""))
                  .lenses.empty());
}

TEST(RemoteRequest, WhatIsWrongIsRefused) {
  const std::pair<const char*, const char*> changes[] = {
      {R"("look")", R"("image")"},
      {R"("sequence":7)", R"("sequence":-1)"},
      {R"("sequence":7)", R"("sequence":7.5)"},
      {R"("sequence":7)", R"("sequence":4294967296)"},
      {R"("sequence":7,)", ""},
      {R"([1280,720])", R"([1280,8])"},
      {R"([1280,720])", R"([1280.5,720])"},
      {R"([1280,720])", R"([1280,1e9])"},
      {R"([1280,720])", R"([1280])"},
      {R"("fov_vertical_degrees":40)", R"("fov_vertical_degrees":1e-9)"},
      {R"("fov_vertical_degrees":40)", R"("fov_vertical_degrees":180)"},
      {R"("eye":[0,1,5])", R"("eye":[0,0,0])"},
      {R"("eye":[0,1,5])", R"("eye":[0,1,1e300])"},
      {R"("eye")", R"("eyes")"},
      {R"("zoom":3)", R"("zoom":65)"},
      {R"("zoom":3,)", ""},
      {R"("extent":[0.2,0.3])", R"("extent":[0.2,0])"},
      {R"("center":[0.3,0.4])", R"("center":[0.3,1.4])"},
      {R"("lenses":[)", R"("more":1,"lenses":[)"},
      {R"("lenses":[)", R"("lenses":[{},)"},
      {"}]}", "}]"},
  };
  for (const auto& [from, to] : changes) {
    EXPECT_THROW(remoteRequestFromJson(replaced(from, to)), InputError) << from << " -> " << to;
  }
  EXPECT_THROW(remoteRequestFromJson(""), InputError);
  EXPECT_THROW(remoteRequestFromJson("[]"), InputError);
  EXPECT_THROW(remoteRequestFromJson(std::string(300, '[')), InputError);
  EXPECT_THROW(remoteRequestFromJson(kLook + std::string(RemoteRequest::kMaxTextBytes, ' ')), InputError);
}

TEST(RemoteRequest, HasAtMostEightLenses) {
  const std::string lens = R"({"center":[0.3,0.4],"extent":[0.2,0.3],"zoom":3})";
  std::string eight = lens;
  for (int i = 1; i < 8; ++i) {
    eight += "," + lens;
  }
  const std::string own = R"({"center":[0.3,0.4],"extent":[0.2,0.3],"zoom":3,"transition_width":0.5})";
  EXPECT_EQ(remoteRequestFromJson(replaced(own, eight)).lenses.size(), 8u);
  EXPECT_THROW(remoteRequestFromJson(replaced(own, eight + "," + lens)), InputError);
}

}  // namespace
}  // namespace ocelli
