# ocelli_room(NAME [OPTIMIZE light|hot] SOURCES ... PUBLIC ... PRIVATE ...): one library a room, with the settings they all
# share.
add_library(ocelli_settings INTERFACE)
target_compile_features(ocelli_settings INTERFACE cxx_std_20)
target_include_directories(ocelli_settings INTERFACE
  $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/ocelli>)

# Private to our own targets: warnings, sanitizers, and no fused multiply-add, so that every compiler gives the same bytes.
add_library(ocelli_strict INTERFACE)
target_compile_options(ocelli_strict INTERFACE
  -Wall -Wextra -Wpedantic -Wconversion -Wno-sign-conversion -Wnon-virtual-dtor -Woverloaded-virtual
  # clang takes fields of an outer class for shadowed ones.
  $<$<CXX_COMPILER_ID:GNU>:-Wshadow>
  -ffp-contract=off $<$<BOOL:${OCELLI_WERROR}>:-Werror>)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # No collection of garbage below this many KiB: it saves a fifth of the memory and costs an eighth of the compile time.
  target_compile_options(ocelli_strict INTERFACE --param=ggc-min-heapsize=524288)
  # GCC 12 leaves out the rounding where it makes vectors of (double)(float)x from neighbouring statements: points that are
  # worked out twice then differ (tests/render/single_precision_test.cpp).
  target_compile_options(ocelli_strict INTERFACE -fno-tree-slp-vectorize)
endif()
if(CMAKE_UNITY_BUILD)
  # A .cpp file may have types with members of its own anonymous namespace: GCC takes it for a header here.
  target_compile_options(ocelli_strict INTERFACE $<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage>)
endif()
if(OCELLI_SANITIZE)
  target_compile_options(ocelli_strict INTERFACE -fsanitize=${OCELLI_SANITIZE} -fno-sanitize-recover=all
    # A question at every access: 40 % of the compile time, and AddressSanitizer sees what is wrong of it but alignment.
    -fno-sanitize=null,alignment,object-size -fno-omit-frame-pointer
    # GCC 12 warns about the inside of std::regex when it instruments it (GCC bug 105562).
    $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
  target_link_options(ocelli_strict INTERFACE -fsanitize=${OCELLI_SANITIZE})
endif()

# What Release builds optimise, from the commands' -O3 down: a higher level takes longer to build, and gains nothing in code
# that reads, calls and prints (light), and little in most other code. Only loops over pixels, triangles and voxels are hot.
set(OCELLI_OPTIONS_light $<$<CONFIG:Release>:-O1>)
set(OCELLI_OPTIONS_ $<$<CONFIG:Release>:-O2>)
set(OCELLI_OPTIONS_hot $<$<CONFIG:Release>:-O3>)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # GCC 12 at -O1 is wrong about strings and Eigen here. The sanitizers look for what these warnings mean.
  list(APPEND OCELLI_OPTIONS_light -Wno-array-bounds -Wno-maybe-uninitialized -Wno-stringop-overflow)
endif()

function(ocelli_room name)
  cmake_parse_arguments(ROOM "" "OPTIMIZE" "SOURCES;PUBLIC;PRIVATE" ${ARGN})
  add_library(ocelli_${name} STATIC ${ROOM_SOURCES})
  add_library(Ocelli::${name} ALIAS ocelli_${name})
  set_target_properties(ocelli_${name} PROPERTIES EXPORT_NAME ${name} POSITION_INDEPENDENT_CODE ON)
  target_link_libraries(ocelli_${name} PUBLIC ocelli_settings ${ROOM_PUBLIC}
    PRIVATE $<BUILD_INTERFACE:ocelli_strict> ${ROOM_PRIVATE})
  target_compile_options(ocelli_${name} PRIVATE ${OCELLI_OPTIONS_${ROOM_OPTIMIZE}})
  set_property(GLOBAL APPEND PROPERTY OCELLI_ROOMS ocelli_${name})
endfunction()
