# `cpack -G DEB --config build/release/CPackConfig.cmake`: the packages morphkit and libmorphkit-dev.
set(CPACK_PACKAGE_NAME morphkit)
set(CPACK_PACKAGE_CONTACT "The morphkit authors" CACHE STRING "Maintainer of the packages")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_DESCRIPTION}")
set(CPACK_RESOURCE_FILE_LICENSE "${PROJECT_SOURCE_DIR}/LICENSE")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_COMPONENTS_ALL program development)

set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)

set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME morphkit)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_DEPENDS "ffmpeg, fonts-dejavu-core")
set(CPACK_COMPONENT_PROGRAM_DESCRIPTION
"2D image morphing and warping
 morphkit bends pictures and turns one picture into another. Lines, points,
 curves or a mesh say what corresponds; the program warps both pictures onto
 the shapes in between and dissolves one into the other. It renders frames,
 videos and maps, and has an editor.")

set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libmorphkit-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS
  "libopencv-dev, libopenimageio-dev, libtbb-dev, libhwy-dev, libfmt-dev, libwebp-dev, liblcms2-dev, zlib1g-dev")
set(CPACK_COMPONENT_DEVELOPMENT_DESCRIPTION
"2D image morphing and warping, for C++ programs
 Headers, static libraries and a CMake package: morphkit::warp for images in
 memory, morphkit::morph for projects, files and whole morphs.")

# Debian keeps the terms of every package in a file of this name.
foreach(component program development)
  string(TOUPPER ${component} upper)
  install(FILES cmake/copyright DESTINATION "share/doc/${CPACK_DEBIAN_${upper}_PACKAGE_NAME}" COMPONENT ${component})
endforeach()
include(CPack)
