# ocelli_embed_shaders(TARGET FILE ...): compiles GLSL sources into a target. some_file.glsl becomes
# `ocelli::shaders::kSomeFile`, some_file.comp `kSomeFileComp`, a std::string_view, in "<folder of the target>/shaders.h"
# of the build tree, for .cpp files.
function(ocelli_embed_shaders target)
  file(RELATIVE_PATH folder ${PROJECT_SOURCE_DIR} ${CMAKE_CURRENT_SOURCE_DIR})
  set(declarations "")
  foreach(shader IN LISTS ARGN)
    set(file ${CMAKE_CURRENT_SOURCE_DIR}/${shader})
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${file})
    file(READ ${file} source)
    get_filename_component(name ${shader} NAME)
    string(REGEX REPLACE "\\.glsl$" "" name ${name})
    string(REGEX REPLACE "[_.]" ";" words ${name})
    set(constant "k")
    foreach(word IN LISTS words)
      string(SUBSTRING ${word} 0 1 first)
      string(SUBSTRING ${word} 1 -1 rest)
      string(TOUPPER ${first} first)
      string(APPEND constant "${first}${rest}")
    endforeach()
    string(APPEND declarations "inline constexpr std::string_view ${constant} = R\"glsl(${source})glsl\";\n")
  endforeach()
  set(header ${CMAKE_BINARY_DIR}/generated/${folder}/shaders.h)
  file(CONFIGURE OUTPUT ${header} @ONLY CONTENT "// Made by ocelli_embed_shaders().
#pragma once

#include <string_view>

namespace ocelli::shaders {

@declarations@
}  // namespace ocelli::shaders
")
  target_include_directories(${target} PRIVATE ${CMAKE_BINARY_DIR}/generated)
endfunction()
