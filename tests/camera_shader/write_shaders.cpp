// Writes the shaders of shader_cases.h into a folder: NAME.osl and NAME_rays.exr as users get them, and shaders.inc,
// which run_shaders.cpp compiles: the very texts, but for the outputs, which C++ cannot take with their values.
#include <exception>
#include <iostream>
#include <regex>

#include "oc_core/base/file_bytes.h"
#include "tests/camera_shader/shader_cases.h"

namespace ocelli::test {
namespace {

/// "output point position = point(0.0)" becomes "point& position".
std::string asCpp(const std::string& osl) {
  return std::regex_replace(osl, std::regex(R"(output (point|vector|color) (\w+) = \1\(0\.0\))"), "$1& $2");
}

std::string shaderName(const std::string& osl) {
  std::smatch found;
  std::regex_search(osl, found, std::regex(R"(\nshader (\w+)\()"));
  return found.str(1);
}

void write(const std::filesystem::path& folder) {
  std::string all;
  std::string table;
  for (const ShaderCase& each : shaderCases(folder)) {
    writeFile(folder / (each.name + ".osl"), each.text);
    if (!each.texture.empty()) {
      writeFile(texturePath(folder, each.name), each.texture);
    }
    all += "namespace case_" + each.name + " {\n" + asCpp(each.text) + "}\n";
    table += "    {\"" + each.name + "\", [](point& p, vector& d, color& t) { case_" + each.name +
             "::" + shaderName(each.text) + "(p, d, t); }},\n";
  }
  writeFile(folder / "shaders.inc", "// NOLINTBEGIN: names are those of the language\n" + all +
                                        "const std::map<std::string, Shader> kShaders{\n" + table +
                                        "};\n// NOLINTEND\n");
}

}  // namespace
}  // namespace ocelli::test

int main(int count, char** arguments) {
  try {
    ocelli::test::write(count > 1 ? arguments[1] : ".");
    return 0;
  } catch (const std::exception& error) {
    std::cerr << error.what() << "\n";
    return 1;
  }
}
