# Run by ocelli_embed_files() of OcelliFiles.cmake: writes OUTPUT, with FILES of FOLDER as raw strings.
set(end ")ocelli-file\"")
file(WRITE ${OUTPUT}.new "// Made by cmake/embed_files.cmake.\n#include \"${HEADER}\"\n\nnamespace ocelli {\nnamespace {\n\n"
  "constexpr EmbeddedFile kFiles[] = {\n")
foreach(name IN LISTS FILES)
  file(READ ${FOLDER}/${name} text)
  string(FIND "${text}" "${end}" at)
  if(NOT at EQUAL -1)
    message(FATAL_ERROR "${FOLDER}/${name} holds ${end}, which ends a raw string here")
  endif()
  file(APPEND ${OUTPUT}.new "    {\"${name}\", R\"ocelli-file(${text})ocelli-file\"},\n")
endforeach()
file(APPEND ${OUTPUT}.new "};\n\n}  // namespace\n\nstd::span<const EmbeddedFile> ${FUNCTION}() {\n  return kFiles;\n}\n\n}  // namespace ocelli\n")
file(RENAME ${OUTPUT}.new ${OUTPUT})
