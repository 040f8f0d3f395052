# What `cmake --install` lays down: libraries, headers, pkg-config files, CMake package.
include(CMakePackageConfigHelpers)

set(targets vesica vesica_methods vesica_core)
if(NOT BUILD_SHARED_LIBS)
  list(APPEND targets vesica_interface vesica_methods_interface)
endif()
install(TARGETS ${targets} EXPORT vesica-targets
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
  LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}
  RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR}
  INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(FILES
    ${PROJECT_SOURCE_DIR}/capi/include/vesica.h
    ${PROJECT_SOURCE_DIR}/capi/include/vesica_generic.h
    ${PROJECT_SOURCE_DIR}/capi/include/vesica_boxes.h
    ${PROJECT_SOURCE_DIR}/capi/include/vesica_detection.h
    ${PROJECT_SOURCE_DIR}/capi/include/vesica_index.h
    ${PROJECT_SOURCE_DIR}/capi/include/vesica_index.hpp
    ${PROJECT_SOURCE_DIR}/capi/include/vesica_measures.h
    ${PROJECT_SOURCE_DIR}/capi/include/vesica_motion.h
    ${PROJECT_SOURCE_DIR}/capi/include/vesica_topology.h
    ${PROJECT_SOURCE_DIR}/capi/include/vesica_methods.h
  DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(DIRECTORY ${PROJECT_SOURCE_DIR}/include/vesica DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})

# In /usr the paths are absolute, so that pkg-config knows them for the system's and prints no flags for them;
# anywhere else they follow the file, so that the tree may be moved. From a folder for libraries that is told as an
# absolute path nothing leads to the prefix.
if(CMAKE_INSTALL_PREFIX STREQUAL "/usr" OR IS_ABSOLUTE "${CMAKE_INSTALL_LIBDIR}")
  set(VESICA_PC_PREFIX ${CMAKE_INSTALL_PREFIX})
else()
  file(RELATIVE_PATH up_to_prefix /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)
  string(REGEX REPLACE "/$" "" up_to_prefix ${up_to_prefix})
  set(VESICA_PC_PREFIX "\${pcfiledir}/${up_to_prefix}")
endif()
foreach(folder LIBDIR INCLUDEDIR)
  if(IS_ABSOLUTE "${CMAKE_INSTALL_${folder}}")
    set(VESICA_PC_${folder} ${CMAKE_INSTALL_${folder}})
  else()
    set(VESICA_PC_${folder} "\${prefix}/${CMAKE_INSTALL_${folder}}")
  endif()
endforeach()
# Beside an archive alone, libm is needed by everyone and not only with pkg-config --static.
if(BUILD_SHARED_LIBS)
  set(VESICA_PC_LIBS_PRIVATE -lm)
else()
  set(VESICA_PC_LIBS " -lm")
endif()
configure_file(${CMAKE_CURRENT_LIST_DIR}/vesica.pc.in vesica.pc @ONLY)
configure_file(${CMAKE_CURRENT_LIST_DIR}/vesica-methods.pc.in vesica-methods.pc @ONLY)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/vesica.pc ${CMAKE_CURRENT_BINARY_DIR}/vesica-methods.pc
  DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)

# What the library is made of, as SPDX. The date is the release's, so that the same tree gives the same bytes.
file(STRINGS ${PROJECT_SOURCE_DIR}/CITATION.cff VESICA_DATE REGEX "^date-released: ")
string(REPLACE "date-released: " "" VESICA_DATE "${VESICA_DATE}")
configure_file(${CMAKE_CURRENT_LIST_DIR}/vesica.spdx.json.in vesica.spdx.json @ONLY)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/vesica.spdx.json DESTINATION ${CMAKE_INSTALL_DATADIR}/vesica)

set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/vesica)
configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/vesica-config.cmake.in vesica-config.cmake
  INSTALL_DESTINATION ${package_dir})
# The header-only core may change in a minor release (capi/ABI.md).
write_basic_package_version_file(vesica-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/vesica-config.cmake ${CMAKE_CURRENT_BINARY_DIR}/vesica-config-version.cmake
  DESTINATION ${package_dir})
# The file of the build type is installed only if the installation is of that type, by name. The parent of a subproject
# may have none, where this project has chosen Release for itself.
if(NOT CMAKE_CONFIGURATION_TYPES)
  install(CODE "set(vesica_installation \"\${CMAKE_INSTALL_CONFIG_NAME}\")
set(CMAKE_INSTALL_CONFIG_NAME \"${CMAKE_BUILD_TYPE}\")")
endif()
install(EXPORT vesica-targets NAMESPACE vesica:: DESTINATION ${package_dir})
if(NOT CMAKE_CONFIGURATION_TYPES)
  install(CODE "set(CMAKE_INSTALL_CONFIG_NAME \"\${vesica_installation}\")")
endif()
