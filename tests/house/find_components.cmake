# find_package(Ocelli COMPONENTS ...) against the package in PREFIX, as projects call it that build nothing: each finds
# what it asks for and looks for nothing that only others need, and what is not there is said. WORK_DIR, GENERATOR: as
# in build_project.cmake. WITH_OPENGL, WITH_MPI, WITH_LIVE_PAGE, WITH_REMOTE, WITH_VOLUME_IMPORT, WITH_FEEDS:
# whether there is a component "opengl", "mpi", "live" and "local_pages", "serving", "volumes", "video". DOCUMENTATION: docs/install.md.

# Configures a new project with these lines, with options of CMake; leaves what was printed in `said` and the status in
# `failed`.
function(configure lines)
  file(REMOVE_RECURSE "${WORK_DIR}")
  file(WRITE "${WORK_DIR}/CMakeLists.txt"
    "cmake_minimum_required(VERSION 3.25)\nproject(Components LANGUAGES CXX)\n${lines}\n")
  execute_process(COMMAND "${CMAKE_COMMAND}" -S "${WORK_DIR}" -B "${WORK_DIR}/build" -G "${GENERATOR}"
    "-DCMAKE_PREFIX_PATH=${PREFIX}" ${ARGN}
    RESULT_VARIABLE failed OUTPUT_VARIABLE said ERROR_VARIABLE said)
  string(REGEX REPLACE "\n.*" "" first "${lines}")
  message(STATUS "${first} ${ARGN}: ${failed}")
  set(failed "${failed}" PARENT_SCOPE)
  set(said "${said}" PARENT_SCOPE)
endfunction()

function(must_configure lines)
  configure("${lines}" ${ARGN})
  if(failed)
    message(FATAL_ERROR "${said}")
  endif()
endfunction()

# `text` stands in what it says; spaces and line breaks count the same.
function(must_fail_saying text lines)
  configure("${lines}" ${ARGN})
  string(REGEX REPLACE "[ \n]+" " " said "${said}")
  string(FIND "${said}" "${text}" at)
  if(NOT failed OR at EQUAL -1)
    message(FATAL_ERROR "not \"${text}\", but: ${said}")
  endif()
endfunction()

# find_needs(COMPONENT PACKAGES ... TARGETS ... LACKS ...): found where these packages cannot be. Has these targets and
# lacks those.
function(find_needs component)
  cmake_parse_arguments(NEEDS "" "" "PACKAGES;TARGETS;LACKS" ${ARGN})
  set(lines "find_package(Ocelli REQUIRED COMPONENTS ${component})\n")
  foreach(target IN LISTS NEEDS_TARGETS ITEMS Ocelli::Ocelli Ocelli::${component})
    string(APPEND lines "if(NOT TARGET ${target})\n  message(FATAL_ERROR \"no ${target}\")\nendif()\n")
  endforeach()
  foreach(target IN LISTS NEEDS_LACKS)
    string(APPEND lines "if(TARGET ${target})\n  message(FATAL_ERROR \"${target} was looked for\")\nendif()\n")
  endforeach()
  set(hidden "")
  foreach(package IN LISTS NEEDS_PACKAGES)
    list(APPEND hidden -DCMAKE_DISABLE_FIND_PACKAGE_${package}=ON)
  endforeach()
  must_configure("${lines}" ${hidden})
endfunction()

# The table of docs/install.md names each component with its packages.
file(STRINGS "${PREFIX}/lib/cmake/Ocelli/OcelliConfig.cmake" rows REGEX "^set\\(OCELLI_")
foreach(row IN LISTS rows)
  string(REGEX MATCH "^set\\(([A-Za-z_]+) ?(.*)\\)$" row "${row}")
  set(${CMAKE_MATCH_1} ${CMAKE_MATCH_2})
endforeach()
include("${PREFIX}/lib/cmake/Ocelli/OcelliPackages.cmake")
foreach(component IN LISTS OCELLI_COMPONENTS)
  file(STRINGS "${DOCUMENTATION}" row REGEX "^. `${component}` .")
  foreach(target IN LISTS OCELLI_${component}_PACKAGES)
    set(package ${OCELLI_PACKAGE_${target}})
    list(REMOVE_ITEM package PKG_CONFIG LIBRARY)
    list(GET package 0 package)
    string(REGEX REPLACE ">=.*" "" package "${package}")
    string(FIND "${row}" "${package}" at)
    if(at EQUAL -1)
      message(FATAL_ERROR "${DOCUMENTATION}: the table of components does not say that \"${component}\" needs ${package}")
    endif()
  endforeach()
endforeach()

set(windows glfw PkgConfig::imgui PkgConfig::fontconfig PkgConfig::fribidi)
set(usb PkgConfig::libusb PkgConfig::umockdev)
set(checksums PkgConfig::isal)
set(statistics PkgConfig::nlopt Eigen3::Eigen Boost::headers)

find_needs(foundation TARGETS Ocelli::base
  PACKAGES glm PNG SQLiteCpp Eigen3 Boost assimp hwy glfw3
  LACKS glm::glm PNG::PNG SQLiteCpp assimp::assimp hwy::hwy ${windows} ${usb} ${checksums} ${statistics} Ocelli::page Ocelli::maze)
find_needs(mazes TARGETS Ocelli::foundation Ocelli::maze
  PACKAGES glm PNG SQLiteCpp Eigen3 Boost assimp hwy glfw3
  LACKS glm::glm PNG::PNG SQLiteCpp assimp::assimp hwy::hwy ${windows} ${usb} ${checksums} ${statistics} Ocelli::page Ocelli::scene)
find_needs(pages TARGETS Ocelli::drawing Ocelli::page
  PACKAGES glm PNG SQLiteCpp Eigen3 Boost assimp hwy glfw3
  LACKS glm::glm PNG::PNG SQLiteCpp assimp::assimp hwy::hwy ${windows} ${usb} ${checksums} ${statistics} Ocelli::maze
    Ocelli::analysis_base)
find_needs(core TARGETS Ocelli::pages Ocelli::mazes Ocelli::ocri Ocelli::evaluation
  PACKAGES SQLiteCpp Eigen3 Boost assimp glfw3 MPI
  LACKS MPI::MPI_CXX SQLiteCpp assimp::assimp ${windows} ${usb} ${statistics} Ocelli::frames Ocelli::analysis_base Ocelli::gl)
find_needs(display TARGETS Ocelli::core Ocelli::solidity
  PACKAGES SQLiteCpp Eigen3 Boost assimp glfw3
  LACKS SQLiteCpp assimp::assimp ${windows} ${usb} ${statistics} Ocelli::device Ocelli::viewer)
find_needs(driver TARGETS Ocelli::core Ocelli::display Ocelli::devices
  PACKAGES SQLiteCpp Eigen3 Boost assimp glfw3
  LACKS SQLiteCpp assimp::assimp ${windows} ${statistics} Ocelli::study_task)
# What a condition of a study can show includes the simulated display.
find_needs(study TARGETS Ocelli::core Ocelli::display Ocelli::study_store
  PACKAGES Eigen3 Boost assimp glfw3
  LACKS assimp::assimp ${windows} ${usb} ${statistics} Ocelli::device Ocelli::study_screen)
find_needs(analysis TARGETS Ocelli::pages Ocelli::mazes Ocelli::analysis_report
  PACKAGES glm PNG assimp embree hwy meshoptimizer zstd glfw3
  LACKS glm::glm PNG::PNG assimp::assimp embree hwy::hwy ${windows} ${usb} ${checksums} Ocelli::core Ocelli::scene)
find_needs(power TARGETS Ocelli::study Ocelli::analysis Ocelli::analysis_power
  PACKAGES assimp glfw3
  LACKS assimp::assimp ${windows} ${usb})
find_needs(import TARGETS Ocelli::core Ocelli::scene_import
  PACKAGES SQLiteCpp Eigen3 Boost glfw3
  LACKS SQLiteCpp ${windows} ${usb} ${statistics})

# Several, and the same one twice.
must_configure("find_package(Ocelli 0.1 REQUIRED COMPONENTS core)
find_package(Ocelli 0.1 REQUIRED COMPONENTS analysis core)
if(NOT TARGET Ocelli::core OR NOT TARGET Ocelli::analysis OR TARGET Ocelli::device)
  message(FATAL_ERROR \"other targets\")
endif()")

set(local_pages "")
if(WITH_LIVE_PAGE)
  set(local_pages "local_pages, ")
endif()
set(video "")
if(WITH_FEEDS)
  set(video "video, ")
  must_configure("find_package(Ocelli REQUIRED COMPONENTS video)
if(NOT TARGET Ocelli::feeds_live OR NOT TARGET Ocelli::feeds_calibration)
  message(FATAL_ERROR \"no feeds\")
endif()")
endif()

# All.
set(all "find_package(Ocelli REQUIRED)
foreach(target IN ITEMS foundation mazes pages core streaming seas import display driver trials study analysis power)
  if(NOT TARGET Ocelli::\${target})
    message(FATAL_ERROR \"no Ocelli::\${target}\")
  endif()
endforeach()")
must_configure("${all}")

must_fail_saying("There is no component \"graphics\" here. Those of this installation: foundation, mazes, pages, core, ${local_pages}streaming, seas, ${video}import, display, driver, trials, study, analysis, power"
  "find_package(Ocelli REQUIRED COMPONENTS core graphics)")
must_fail_saying("SQLiteCpp, which \"study\" needs" "find_package(Ocelli REQUIRED COMPONENTS study)"
  -DCMAKE_DISABLE_FIND_PACKAGE_SQLiteCpp=ON)
# Of a component that is needed by what was asked for.
must_fail_saying("glm, which \"core\" needs" "find_package(Ocelli REQUIRED COMPONENTS driver)"
  -DCMAKE_DISABLE_FIND_PACKAGE_glm=ON)
must_fail_saying("SQLiteCpp, which \"study\" needs" "find_package(Ocelli REQUIRED)"
  -DCMAKE_DISABLE_FIND_PACKAGE_SQLiteCpp=ON)

# What is optional may be missing: its packages, or itself.
must_configure("find_package(Ocelli REQUIRED COMPONENTS core OPTIONAL_COMPONENTS study graphics)
if(NOT Ocelli_core_FOUND OR Ocelli_study_FOUND OR Ocelli_graphics_FOUND OR TARGET Ocelli::study)
  message(FATAL_ERROR \"found what is not there\")
endif()" -DCMAKE_DISABLE_FIND_PACKAGE_SQLiteCpp=ON)
must_configure("find_package(Ocelli QUIET COMPONENTS graphics)
if(Ocelli_FOUND)
  message(FATAL_ERROR \"found what is not there\")
endif()")

if(WITH_MPI)
  find_needs(mpi TARGETS Ocelli::core Ocelli::mpi_ranks PACKAGES SQLiteCpp Eigen3 Boost assimp glfw3
    LACKS SQLiteCpp assimp::assimp ${windows} ${usb} ${statistics})
  must_fail_saying("MPI COMPONENTS CXX, which \"mpi\" needs" "${all}" -DCMAKE_DISABLE_FIND_PACKAGE_MPI=ON)
else()
  must_fail_saying("There is no component \"mpi\"" "find_package(Ocelli REQUIRED COMPONENTS mpi)")
endif()
if(WITH_LIVE_PAGE)
  find_needs(local_pages TARGETS Ocelli::foundation Ocelli::local_server PACKAGES glm PNG SQLiteCpp Eigen3 Boost assimp glfw3
    LACKS glm::glm PNG::PNG assimp::assimp ${windows} ${usb} ${statistics})
  find_needs(live TARGETS Ocelli::local_pages Ocelli::study_live Ocelli::study_live_server PACKAGES Eigen3 Boost assimp glfw3
    LACKS assimp::assimp ${windows} ${usb} ${statistics})
else()
  must_fail_saying("There is no component \"live\"" "find_package(Ocelli REQUIRED COMPONENTS live)")
endif()
if(WITH_REMOTE)
  find_needs(serving TARGETS Ocelli::remote Ocelli::remote_server PACKAGES Eigen3 Boost assimp glfw3 SQLiteCpp
    LACKS assimp::assimp SQLiteCpp ${windows} ${usb} ${statistics})
else()
  must_fail_saying("There is no component \"serving\"" "find_package(Ocelli REQUIRED COMPONENTS serving)")
endif()
if(WITH_VOLUME_IMPORT)
  find_needs(volumes TARGETS Ocelli::core Ocelli::volume_import PACKAGES Eigen3 Boost assimp glfw3 SQLiteCpp
    LACKS assimp::assimp SQLiteCpp ${windows} ${usb} ${statistics})
else()
  must_fail_saying("There is no component \"volumes\"" "find_package(Ocelli REQUIRED COMPONENTS volumes)")
endif()
if(WITH_OPENGL)
  find_needs(opengl TARGETS Ocelli::viewer Ocelli::study_screen Ocelli::gl PACKAGES Eigen3 Boost assimp
    LACKS assimp::assimp ${usb} ${statistics})
  must_fail_saying("glfw3, which \"opengl\" needs" "${all}" -DCMAKE_DISABLE_FIND_PACKAGE_glfw3=ON)
else()
  must_fail_saying("There is no component \"opengl\"" "find_package(Ocelli REQUIRED COMPONENTS opengl)")
endif()
