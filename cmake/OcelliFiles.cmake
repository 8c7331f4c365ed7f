# ocelli_embed_files(RESULT FUNCTION HEADER FILE ...): text files of this folder as a source of the build tree, whose name goes
# into RESULT. It defines `std::span<const ocelli::EmbeddedFile> ocelli::FUNCTION()`, a row for each FILE, with its name
# and its bytes; HEADER declares both. The source is made anew where a file changes.
set(OCELLI_EMBED_SCRIPT ${CMAKE_CURRENT_LIST_DIR}/embed_files.cmake)
function(ocelli_embed_files result function header)
  set(source ${CMAKE_CURRENT_BINARY_DIR}/${function}.cpp)
  add_custom_command(OUTPUT ${source}
    COMMAND ${CMAKE_COMMAND} "-DFILES=${ARGN}" -D FOLDER=${CMAKE_CURRENT_SOURCE_DIR} -D OUTPUT=${source}
      -D FUNCTION=${function} -D HEADER=${header} -P ${OCELLI_EMBED_SCRIPT}
    DEPENDS ${ARGN} ${OCELLI_EMBED_SCRIPT}
    WORKING_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR}
    COMMENT "Embedding the files of ${function}()" VERBATIM)
  set(${result} ${source} PARENT_SCOPE)
endfunction()
