# Installs the program, one library a room and their headers, and what find_package(Ocelli) needs.
include(CMakePackageConfigHelpers)

get_property(rooms GLOBAL PROPERTY OCELLI_ROOMS)
add_library(ocelli_all INTERFACE)
add_library(Ocelli::Ocelli ALIAS ocelli_all)
set_target_properties(ocelli_all PROPERTIES EXPORT_NAME Ocelli)
target_link_libraries(ocelli_all INTERFACE ${rooms})

install(TARGETS ocelli)
install(TARGETS ${rooms} ocelli_all ocelli_settings EXPORT OcelliTargets)
foreach(room IN LISTS rooms)
  get_target_property(folder ${room} SOURCE_DIR)
  file(RELATIVE_PATH folder ${PROJECT_SOURCE_DIR} ${folder})
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/${folder}/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/ocelli/${folder}
    FILES_MATCHING PATTERN "*.h" PATTERN gl_api.h EXCLUDE)
endforeach()

set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/Ocelli)
configure_package_config_file(cmake/OcelliConfig.cmake.in OcelliConfig.cmake INSTALL_DESTINATION ${package_folder})
write_basic_package_version_file(OcelliConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(EXPORT OcelliTargets NAMESPACE Ocelli:: DESTINATION ${package_folder})
install(FILES
  ${CMAKE_CURRENT_BINARY_DIR}/OcelliConfig.cmake
  ${CMAKE_CURRENT_BINARY_DIR}/OcelliConfigVersion.cmake
  cmake/OcelliDependencies.cmake
  DESTINATION ${package_folder})
install(FILES LICENSE README.md CHANGELOG.md DESTINATION ${CMAKE_INSTALL_DOCDIR})
