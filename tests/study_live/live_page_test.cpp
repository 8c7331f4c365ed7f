#include "study/live/live_page.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <regex>
#include <set>

namespace ocelli::test {
namespace {

using testing::HasSubstr;
using testing::Not;

TEST(LivePage, takesNothingFromElsewhere) {
  for (const std::string& text : {livePage(), liveScript()}) {
    EXPECT_THAT(text, Not(HasSubstr("http")));
    EXPECT_THAT(text, Not(HasSubstr("//")));
  }
}

TEST(LivePage, hasEveryPlaceThatItsScriptFills) {
  const std::string page = livePage();
  const std::string script = liveScript();
  std::set<std::string> ids;
  const std::regex use(R"re((?:at|say)\("([a-z]+)")re");
  for (std::sregex_iterator it(script.begin(), script.end(), use); it != std::sregex_iterator(); ++it) {
    ids.insert((*it)[1].str());
  }
  EXPECT_GT(ids.size(), 10u);
  for (const std::string& id : ids) {
    EXPECT_THAT(page, HasSubstr("id=\"" + id + "\""));
  }
}

/// What a status says is shown as text: no name of a device becomes markup.
TEST(LivePage, putsNothingInAsMarkup) {
  for (const char* dangerous : {"innerHTML", "outerHTML", "insertAdjacent", "document.write", "eval("}) {
    EXPECT_THAT(liveScript(), Not(HasSubstr(dangerous)));
  }
}

}  // namespace
}  // namespace ocelli::test
