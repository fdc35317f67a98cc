# What `cmake --install` adds to programs and headers: the libraries and the CMake package morphkit.
include(CMakePackageConfigHelpers)

# Inside the tree Highway comes from pkg-config, whose target consumers would not have.
foreach(library base image field sample mesh)
  target_link_libraries(morphkit_${library} PRIVATE $<INSTALL_INTERFACE:hwy::hwy>)
endforeach()

set(package_dir "${CMAKE_INSTALL_LIBDIR}/cmake/morphkit")
get_property(libraries GLOBAL PROPERTY MORPHKIT_LIBRARIES)
install(TARGETS ${libraries} EXPORT morphkitTargets
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development)
install(EXPORT morphkitTargets NAMESPACE morphkit:: DESTINATION ${package_dir} COMPONENT development)

configure_package_config_file(cmake/morphkitConfig.cmake.in morphkitConfig.cmake INSTALL_DESTINATION ${package_dir})
write_basic_package_version_file(morphkitConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES "${PROJECT_BINARY_DIR}/morphkitConfig.cmake" "${PROJECT_BINARY_DIR}/morphkitConfigVersion.cmake"
  DESTINATION ${package_dir} COMPONENT development)
