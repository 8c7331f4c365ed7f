# Configures, builds and runs a project of its own against the package in PREFIX. SOURCE_DIR: the project. WORK_DIR: what
# is made there. GENERATOR: CMake's. PROGRAM: what is run, in the build folder. ARGUMENTS: what it is told. MAKES: files
# that must be there afterwards.
set(build "${WORK_DIR}/build")
file(REMOVE_RECURSE "${WORK_DIR}")

function(run)
  execute_process(COMMAND ${ARGV} COMMAND_ECHO STDOUT COMMAND_ERROR_IS_FATAL ANY WORKING_DIRECTORY "${build}")
endfunction()

file(MAKE_DIRECTORY "${build}")
run("${CMAKE_COMMAND}" -S "${SOURCE_DIR}" -B "${build}" -G "${GENERATOR}" "-DCMAKE_PREFIX_PATH=${PREFIX}"
  -DCMAKE_BUILD_TYPE=Release)
run("${CMAKE_COMMAND}" --build "${build}")
# The library was configured for another prefix, so programs are told where its own is; ocelli finds it by itself.
run("${CMAKE_COMMAND}" -E env "OCELLI_SCENE_READER=${PREFIX}/libexec/ocelli/ocelli-read-scene"
  "${build}/${PROGRAM}" ${ARGUMENTS})
foreach(file IN LISTS MAKES)
  if(NOT EXISTS "${build}/${file}")
    message(FATAL_ERROR "${PROGRAM} did not write ${file}")
  endif()
endforeach()
