# Installs the built project into an empty prefix, then configures, builds and runs consumer/ against it.
set(prefix "${WORK_DIR}/prefix")
set(build "${WORK_DIR}/build")
file(REMOVE_RECURSE "${WORK_DIR}")

function(run)
  execute_process(COMMAND ${ARGV} COMMAND_ECHO STDOUT COMMAND_ERROR_IS_FATAL ANY)
endfunction()

run("${CMAKE_COMMAND}" --install "${OCELLI_BINARY_DIR}" --prefix "${prefix}")
run("${CMAKE_COMMAND}" -S "${CONSUMER_SOURCE_DIR}" -B "${build}" -G "${GENERATOR}" "-DCMAKE_PREFIX_PATH=${prefix}"
  -DCMAKE_BUILD_TYPE=Release)
run("${CMAKE_COMMAND}" --build "${build}")
# The library was configured for another prefix, so the consumer is told where its program is; ocelli finds it by itself.
run("${CMAKE_COMMAND}" -E env "OCELLI_SCENE_READER=${prefix}/libexec/ocelli/ocelli-read-scene"
  "${build}/consumer" "${build}/consumer.obj")
run("${prefix}/bin/ocelli" --version)
run("${prefix}/bin/ocelli" scene info "${build}/consumer.obj")
