# Installs the program, one library a room and their headers, and what find_package(Ocelli) needs.
include(CMakePackageConfigHelpers)

install(TARGETS ocelli COMPONENT program)
install(TARGETS ocelli_read_scene DESTINATION ${CMAKE_INSTALL_LIBEXECDIR}/ocelli COMPONENT program)
if(OCELLI_WITH_VOLUME_IMPORT)
  install(TARGETS ocelli_read_volume DESTINATION ${CMAKE_INSTALL_LIBEXECDIR}/ocelli COMPONENT program)
endif()
if(OCELLI_WITH_FEEDS)
  install(TARGETS ocelli_feeds_program DESTINATION ${CMAKE_INSTALL_LIBEXECDIR}/ocelli COMPONENT feeds)
endif()
foreach(room IN LISTS rooms)
  get_target_property(folder ${room} OCELLI_FOLDER)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/${folder}/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/ocelli/${folder}
    COMPONENT development
    FILES_MATCHING PATTERN "*.h" PATTERN gl_api.h EXCLUDE)
endforeach()

set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/Ocelli)
# What all components share, then a file of targets for each.
install(TARGETS ocelli_settings EXPORT OcelliTargets-settings COMPONENT development)
install(EXPORT OcelliTargets-settings NAMESPACE Ocelli:: DESTINATION ${package_folder} COMPONENT development)
set(component_rows "")
foreach(component IN LISTS OCELLI_COMPONENTS)
  install(TARGETS ${OCELLI_${component}_ROOMS} ocelli_component_${component} EXPORT OcelliTargets-${component}
    COMPONENT development)
  install(EXPORT OcelliTargets-${component} NAMESPACE Ocelli:: DESTINATION ${package_folder} COMPONENT development)
  string(APPEND component_rows "set(OCELLI_${component}_NEEDS ${OCELLI_${component}_NEEDS})\n")
  string(APPEND component_rows "set(OCELLI_${component}_PACKAGES ${OCELLI_${component}_PACKAGES})\n")
endforeach()

set(scene_reader ${CMAKE_INSTALL_LIBEXECDIR}/ocelli/ocelli-read-scene)
set(volume_reader ${CMAKE_INSTALL_LIBEXECDIR}/ocelli/ocelli-read-volume)
configure_package_config_file(cmake/OcelliConfig.cmake.in OcelliConfig.cmake INSTALL_DESTINATION ${package_folder}
  PATH_VARS scene_reader volume_reader)
write_basic_package_version_file(OcelliConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES
  ${CMAKE_CURRENT_BINARY_DIR}/OcelliConfig.cmake
  ${CMAKE_CURRENT_BINARY_DIR}/OcelliConfigVersion.cmake
  cmake/OcelliPackages.cmake
  DESTINATION ${package_folder} COMPONENT development)
# What error messages and docs/files.md call by their paths here.
foreach(schema IN ITEMS
    analysis/dataset/column_maps/column_map.schema.json
    display_sim/frames/profiles/display_profile.schema.json
    display_sim/viewer/viewer_script.schema.json
    oc_core/antialiasing/antialias_regions.schema.json
    oc_core/camera/view.schema.json
    oc_core/constructor/constructor.schema.json
    oc_core/constructor/curved_ray_camera.schema.json
    oc_core/constructor/graph_camera.schema.json
    oc_core/depth_views/views.schema.json
    oc_core/explore/explore_script.schema.json
    oc_core/feeds/feeds_setup.schema.json
    oc_core/feeds/known_places.schema.json
    oc_core/frustum_editor/editor_script.schema.json
    oc_core/ocri/camera.schema.json
    oc_core/volume/transfer_function.schema.json
    oc_core/worlds/maze.schema.json
    oc_core/worlds/object_roles.schema.json)
  get_filename_component(folder ${schema} DIRECTORY)
  install(FILES ${schema} DESTINATION ${CMAKE_INSTALL_DATADIR}/ocelli/${folder} COMPONENT program)
endforeach()
# Studies to run, and to begin from.
install(DIRECTORY protocols DESTINATION ${CMAKE_INSTALL_DATADIR}/ocelli COMPONENT program)
# Maps of columns to copy, with a table each.
install(DIRECTORY analysis/dataset/column_maps DESTINATION ${CMAKE_INSTALL_DATADIR}/ocelli/analysis/dataset
  COMPONENT program FILES_MATCHING PATTERN "*.json" PATTERN "*.csv" PATTERN column_map.schema.json EXCLUDE)

# Manual pages, and what shells complete: by the program, of its own options. Sanitized programs are slow, and no package.
if(NOT OCELLI_SANITIZE)
  set(manual ${PROJECT_BINARY_DIR}/manual)
  add_custom_command(OUTPUT ${manual}/ocelli.bash
    COMMAND ${CMAKE_COMMAND} -E rm -rf ${manual}/man1
    COMMAND ocelli man --quiet -o ${manual}/man1
    COMMAND gzip -9nr ${manual}/man1
    COMMAND ocelli completion zsh > ${manual}/_ocelli
    COMMAND ocelli completion bash > ${manual}/ocelli.bash
    DEPENDS ocelli)
  add_custom_target(ocelli_manual ALL DEPENDS ${manual}/ocelli.bash)
  install(DIRECTORY ${manual}/man1/ DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT program)
  install(FILES ${manual}/ocelli.bash DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions RENAME ocelli
    COMPONENT program)
  install(FILES ${manual}/_ocelli DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/vendor-completions COMPONENT program)
endif()
