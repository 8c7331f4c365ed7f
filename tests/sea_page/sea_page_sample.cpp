// sea_page_sample FOLDER: writes the page that page_test.py looks at.
#include <cstdio>

#include "oc_core/base/error.h"
#include "tests/sea_page/sample_room.h"

int main(int argc, char** argv) {
  using namespace ocelli;
  if (argc != 2) {
    std::fputs("usage: sea_page_sample FOLDER\n", stderr);
    return 2;
  }
  try {
    const SeaPage page = test::roomSea();
    writeSeaPage(
        page, [&](size_t k) { return test::roomImage(page.places[k], 512, 256); }, argv[1]);
  } catch (const Error& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
  return 0;
}
