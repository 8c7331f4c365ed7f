# The reference of the API: target `api_reference`, from the comments of the headers that are installed, by Doxygen. Part of
# ocelli-doc where it was built; nothing else needs it.
find_package(Python3 QUIET COMPONENTS Interpreter)
find_program(OCELLI_DOXYGEN doxygen)

set(OCELLI_REFERENCE_DIR ${PROJECT_BINARY_DIR}/api_reference)
set(rows "")
foreach(room IN LISTS rooms)
  get_target_property(name ${room} EXPORT_NAME)
  get_target_property(folder ${room} OCELLI_FOLDER)
  get_target_property(component ${room} OCELLI_COMPONENT)
  string(APPEND rows "${name},${folder},${component}\n")
endforeach()
file(WRITE ${OCELLI_REFERENCE_DIR}/rooms.csv "${rows}")

if(OCELLI_DOXYGEN AND Python3_EXECUTABLE)
  add_custom_target(api_reference
    COMMAND ${Python3_EXECUTABLE} -B ${PROJECT_SOURCE_DIR}/cmake/api_reference/make_reference.py
      --rooms ${OCELLI_REFERENCE_DIR}/rooms.csv --version ${PROJECT_VERSION} --doxygen ${OCELLI_DOXYGEN}
      ${PROJECT_SOURCE_DIR} ${OCELLI_REFERENCE_DIR}
    COMMENT "Making the reference of the API" VERBATIM)
else()
  add_custom_target(api_reference VERBATIM
    COMMAND ${CMAKE_COMMAND} -E echo
      "The reference of the API needs Doxygen (package doxygen) and Python 3: install them and configure again"
    COMMAND ${CMAKE_COMMAND} -E false)
endif()
