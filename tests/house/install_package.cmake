# Installs the built project of BINARY_DIR into PREFIX, which was empty before, and runs what is installed.
file(REMOVE_RECURSE "${PREFIX}")

function(run)
  execute_process(COMMAND ${ARGV} COMMAND_ECHO STDOUT COMMAND_ERROR_IS_FATAL ANY)
endfunction()

run("${CMAKE_COMMAND}" --install "${BINARY_DIR}" --prefix "${PREFIX}")
run("${PREFIX}/bin/ocelli" --version)
file(WRITE "${PREFIX}/triangle.obj" "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
run("${PREFIX}/bin/ocelli" scene info "${PREFIX}/triangle.obj")
