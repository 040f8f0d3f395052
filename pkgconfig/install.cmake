# What `cmake --install` lays down: libraries, headers, pkg-config files, CMake package.
include(CMakePackageConfigHelpers)

install(TARGETS vesica vesica_methods vesica_core EXPORT vesica-targets
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
  LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}
  RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR}
  INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(FILES
    ${PROJECT_SOURCE_DIR}/capi/vesica.h
    ${PROJECT_SOURCE_DIR}/capi/vesica_generic.h
    ${PROJECT_SOURCE_DIR}/capi/vesica_boxes.h
    ${PROJECT_SOURCE_DIR}/capi/vesica_index.h
    ${PROJECT_SOURCE_DIR}/capi/vesica_index.hpp
    ${PROJECT_SOURCE_DIR}/capi/vesica_measures.h
    ${PROJECT_SOURCE_DIR}/capi/vesica_motion.h
    ${PROJECT_SOURCE_DIR}/capi/vesica_topology.h
    ${PROJECT_SOURCE_DIR}/capi/vesica_methods.h
  DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(DIRECTORY ${PROJECT_SOURCE_DIR}/include/vesica DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})

# In /usr the paths are absolute, so that pkg-config knows them for the system's and prints no flags for them;
# anywhere else they follow the file, so that the tree may be moved.
if(CMAKE_INSTALL_PREFIX STREQUAL "/usr")
  set(VESICA_PC_PREFIX ${CMAKE_INSTALL_PREFIX})
else()
  file(RELATIVE_PATH up_to_prefix /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)
  string(REGEX REPLACE "/$" "" up_to_prefix ${up_to_prefix})
  set(VESICA_PC_PREFIX "\${pcfiledir}/${up_to_prefix}")
endif()
set(VESICA_PC_LIBDIR "\${prefix}/${CMAKE_INSTALL_LIBDIR}")
set(VESICA_PC_INCLUDEDIR "\${prefix}/${CMAKE_INSTALL_INCLUDEDIR}")
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

set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/vesica)
configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/vesica-config.cmake.in vesica-config.cmake
  INSTALL_DESTINATION ${package_dir})
write_basic_package_version_file(vesica-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/vesica-config.cmake ${CMAKE_CURRENT_BINARY_DIR}/vesica-config-version.cmake
  DESTINATION ${package_dir})
install(EXPORT vesica-targets NAMESPACE vesica:: DESTINATION ${package_dir})
