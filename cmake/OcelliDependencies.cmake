# What the libraries need, for this project and, installed beside OcelliConfig.cmake, for those who link to them.
# The includer defines ocelli_find(): find_package() here, find_dependency() there.
# Everything comes from Debian packages; scripts/install_dependencies.sh lists them.
ocelli_find(glm)
ocelli_find(TBB)
ocelli_find(PNG)
ocelli_find(ZLIB)
ocelli_find(nlohmann_json)
ocelli_find(assimp)
ocelli_find(embree 3)
ocelli_find(zstd)
ocelli_find(meshoptimizer)
ocelli_find(fmt)
# OpenEXR through pkg-config: Debian's CMake files of Imath name a Python library that another package holds.
ocelli_find(PkgConfig)
pkg_check_modules(OpenEXR REQUIRED IMPORTED_TARGET GLOBAL OpenEXR)
pkg_check_modules(cairo REQUIRED IMPORTED_TARGET GLOBAL cairo cairo-svg)
pkg_check_modules(stb REQUIRED IMPORTED_TARGET GLOBAL stb)
if(OCELLI_WITH_OPENGL)
  ocelli_find(glfw3)
  pkg_check_modules(imgui REQUIRED IMPORTED_TARGET GLOBAL imgui)
  pkg_check_modules(fontconfig REQUIRED IMPORTED_TARGET GLOBAL fontconfig)
endif()
