# Debian packages, made by scripts/make_packages.sh: what is installed, divided by its COMPONENT.
#
#   program        ocelli            the program, its readers, manual pages, completion
#   feeds          ocelli-feeds      the program that `ocelli feeds` becomes, with OpenCV and FFmpeg's libraries
#   development    libocelli-dev     headers, libraries, what find_package(Ocelli) needs
#   python         python3-ocelli    the package `ocelli` for Python
#   documentation  ocelli-doc        the reference of the API, the guide with its pictures, and the examples

# Packages for others need an address that works: this option, or what Debian's own tools read when it is first set.
if(DEFINED ENV{DEBEMAIL})
  set(package_maintainer "The Ocelli authors <$ENV{DEBEMAIL}>")
  if(DEFINED ENV{DEBFULLNAME})
    set(package_maintainer "$ENV{DEBFULLNAME} <$ENV{DEBEMAIL}>")
  endif()
else()
  set(package_maintainer "The Ocelli authors <ocelli@localhost.localdomain>")
endif()
set(OCELLI_PACKAGE_MAINTAINER "${package_maintainer}" CACHE STRING "Whom packages name")

# What Debian asks of each of its packages.
string(TIMESTAMP package_date "%a, %d %b %Y %H:%M:%S +0000" UTC)
file(READ LICENSE license)
string(REGEX REPLACE "\n\n" "\n.\n" license "${license}")
string(REGEX REPLACE "\n" "\n " license "${license}")
set(package_files ${PROJECT_BINARY_DIR}/package)
file(WRITE ${package_files}/copyright
  "Format: https://www.debian.org/doc/packaging-manuals/copyright-format/1.0/\nUpstream-Name: Ocelli\n\n"
  "Files: *\nCopyright: 2026 The Ocelli authors\nLicense: BSD-3-Clause\n ${license}\n")
file(WRITE ${package_files}/changelog.Debian
  "ocelli (${PROJECT_VERSION}-1) unstable; urgency=medium\n\n  * See changelog of ocelli-doc.\n\n"
  " -- ${OCELLI_PACKAGE_MAINTAINER}  ${package_date}\n")
execute_process(COMMAND gzip -9nf ${package_files}/changelog.Debian)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/CHANGELOG.md)
execute_process(COMMAND gzip -9nc ${PROJECT_SOURCE_DIR}/CHANGELOG.md OUTPUT_FILE ${package_files}/changelog.gz)

set(CPACK_COMPONENTS_ALL "")
# ocelli_package(COMPONENT NAME SECTION SUMMARY DESCRIPTION): the package of a component.
macro(ocelli_package component name section summary description)
  list(APPEND CPACK_COMPONENTS_ALL ${component})
  string(TOUPPER ${component} key)
  set(CPACK_DEBIAN_${key}_PACKAGE_NAME ${name})
  set(CPACK_DEBIAN_${key}_PACKAGE_SECTION ${section})
  set(CPACK_DEBIAN_${key}_DESCRIPTION "${summary}\n${description}")
  install(FILES ${package_files}/copyright ${package_files}/changelog.Debian.gz
    DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${name} COMPONENT ${component})
  # What Debian's checker lintian is told of it.
  file(WRITE ${package_files}/${name}.overrides
    "# Debian has no such package, so none of its bugs asks for it.\n${name}: initial-upload-closes-no-bugs *\n")
  install(FILES ${package_files}/${name}.overrides
    DESTINATION ${CMAKE_INSTALL_DATADIR}/lintian/overrides COMPONENT ${component} RENAME ${name})
endmacro()

ocelli_package(program ocelli graphics "non-pinhole cameras, from scenes to volumetric displays"
  "Ocelli samples scenes with cameras that see more than a pinhole does:
occlusion cameras, graph cameras, curved ray cameras. It makes bounded
meshes of their images, slices them for volumetric displays, shows what
an eye sees of these, and runs perception studies.")
ocelli_package(development libocelli-dev libdevel "non-pinhole cameras - libraries for C++"
  "Static libraries and headers of Ocelli, a toolkit for non-pinhole cameras
and volumetric displays, with what find_package(Ocelli) of CMake needs.")
ocelli_package(documentation ocelli-doc doc "non-pinhole cameras - documentation and examples"
  "The guide of Ocelli, a toolkit for non-pinhole cameras and volumetric
displays, with pictures, measurements, the reference of its API, and
examples in C++ and Python.")
if(OCELLI_WITH_FEEDS)
  ocelli_package(feeds ocelli-feeds graphics "non-pinhole cameras - graph cameras from video"
    "One continuous image of the feeds of several cameras, around the corners
of a place: what `ocelli feeds` runs. It needs OpenCV and the libraries of
FFmpeg, which nothing else of Ocelli does.")
  set(CPACK_DEBIAN_FEEDS_PACKAGE_DEPENDS "ocelli (= ${PROJECT_VERSION}-1)")
endif()
if(OCELLI_WITH_PYTHON)
  ocelli_package(python python3-ocelli python "non-pinhole cameras - package for Python"
    "Ocelli for Python: scenes, every camera, reference images, meshes,
evaluation and displays as NumPy arrays.")
endif()

install(FILES cmake/package/ocelli.desktop DESTINATION ${CMAKE_INSTALL_DATADIR}/applications COMPONENT program)
install(FILES cmake/package/ocelli.svg DESTINATION ${CMAKE_INSTALL_DATADIR}/icons/hicolor/scalable/apps COMPONENT program)
# Where it was made: target `api_reference`.
install(DIRECTORY ${OCELLI_REFERENCE_DIR}/html DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/ocelli-doc COMPONENT documentation
  OPTIONAL)
install(DIRECTORY docs/ DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/ocelli-doc/docs COMPONENT documentation)
install(DIRECTORY examples/ DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/ocelli-doc/examples COMPONENT documentation
  PATTERN __pycache__ EXCLUDE)
install(FILES README.md DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/ocelli-doc COMPONENT documentation)
install(FILES ${package_files}/changelog.gz DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/ocelli-doc COMPONENT documentation)

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME ocelli)
set(CPACK_PACKAGE_CONTACT "${OCELLI_PACKAGE_MAINTAINER}")
# Each package has a summary of its own, before which CPack would put one of the whole project.
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_COMPONENTS_GROUPING ONE_PER_GROUP)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_DOCUMENTATION_PACKAGE_ARCHITECTURE all)
# What the program starts by itself, and what libraries of others need.
# Windows draw with OpenGL, which a driver brings.
set(CPACK_DEBIAN_PROGRAM_PACKAGE_RECOMMENDS "ffmpeg, libegl1, libgl1, libgl1-mesa-dri, fonts-dejavu-core")
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SUGGESTS "ocelli-doc, ocelli-feeds, python3-ocelli, libosmesa6, openmpi-bin, umockdev")
set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS "python3, python3-numpy, ocelli (= ${PROJECT_VERSION}-1)")
set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_EXTRA
  ${PROJECT_SOURCE_DIR}/cmake/package/python/postinst ${PROJECT_SOURCE_DIR}/cmake/package/python/prerm)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SUGGESTS "python3-pandas, python3-matplotlib")
# Those that programs built with the libraries need: what this one is built with, but for its tests and its Python.
file(READ scripts/install_dependencies.sh needed)
string(REGEX MATCHALL "[a-z][a-z0-9.+-]*-dev" needed "${needed}")
list(REMOVE_DUPLICATES needed)
list(FILTER needed EXCLUDE REGEX "^(libgtest|libgmock|libbenchmark|pybind11|python3|libvtk9|libclang).*")
list(JOIN needed ", " needed)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "ocelli (= ${PROJECT_VERSION}-1), ${needed}")
include(CPack)
