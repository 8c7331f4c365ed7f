# Everything comes from Debian packages; scripts/install_dependencies.sh lists them.
find_package(glm REQUIRED)
find_package(TBB REQUIRED)
find_package(PNG REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(assimp REQUIRED)
find_package(embree 3 REQUIRED)
# OpenEXR through pkg-config: Debian's CMake files of Imath name a Python library that another package holds.
find_package(PkgConfig REQUIRED)
pkg_check_modules(OpenEXR REQUIRED IMPORTED_TARGET GLOBAL OpenEXR)
find_package(zstd REQUIRED)
find_package(meshoptimizer REQUIRED)
find_package(CLI11 REQUIRED)
find_package(fmt REQUIRED)
