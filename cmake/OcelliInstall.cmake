# Installs the program, one library a room and their headers, and what find_package(Ocelli) needs.
include(CMakePackageConfigHelpers)

get_property(rooms GLOBAL PROPERTY OCELLI_ROOMS)
add_library(ocelli_all INTERFACE)
add_library(Ocelli::Ocelli ALIAS ocelli_all)
set_target_properties(ocelli_all PROPERTIES EXPORT_NAME Ocelli)
target_link_libraries(ocelli_all INTERFACE ${rooms})

install(TARGETS ocelli)
install(TARGETS ocelli_read_scene DESTINATION ${CMAKE_INSTALL_LIBEXECDIR}/ocelli)
install(TARGETS ${rooms} ocelli_all ocelli_settings EXPORT OcelliTargets)
foreach(room IN LISTS rooms)
  get_target_property(folder ${room} SOURCE_DIR)
  file(RELATIVE_PATH folder ${PROJECT_SOURCE_DIR} ${folder})
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/${folder}/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/ocelli/${folder}
    FILES_MATCHING PATTERN "*.h" PATTERN gl_api.h EXCLUDE)
endforeach()

set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/Ocelli)
set(scene_reader ${CMAKE_INSTALL_LIBEXECDIR}/ocelli/ocelli-read-scene)
configure_package_config_file(cmake/OcelliConfig.cmake.in OcelliConfig.cmake INSTALL_DESTINATION ${package_folder}
  PATH_VARS scene_reader)
write_basic_package_version_file(OcelliConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(EXPORT OcelliTargets NAMESPACE Ocelli:: DESTINATION ${package_folder})
install(FILES
  ${CMAKE_CURRENT_BINARY_DIR}/OcelliConfig.cmake
  ${CMAKE_CURRENT_BINARY_DIR}/OcelliConfigVersion.cmake
  cmake/OcelliDependencies.cmake
  DESTINATION ${package_folder})
# What error messages and docs/files.md call by their paths here.
foreach(schema IN ITEMS
    display_sim/frames/profiles/display_profile.schema.json
    display_sim/viewer/viewer_script.schema.json
    oc_core/camera/view.schema.json
    oc_core/constructor/constructor.schema.json
    oc_core/constructor/curved_ray_camera.schema.json
    oc_core/constructor/graph_camera.schema.json
    oc_core/ocri/camera.schema.json
    oc_core/scene/maze.schema.json
    protocols/analysis_plan.schema.json
    protocols/protocol.schema.json)
  get_filename_component(folder ${schema} DIRECTORY)
  install(FILES ${schema} DESTINATION ${CMAKE_INSTALL_DATADIR}/ocelli/${folder})
endforeach()
install(FILES LICENSE README.md CHANGELOG.md DESTINATION ${CMAKE_INSTALL_DOCDIR})
