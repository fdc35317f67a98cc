# The Debian package as a user meets it: made, unpacked into an empty root, run there.
# Arguments: build, work (a directory of our own).
function(run)
  execute_process(COMMAND ${ARGN} COMMAND_ECHO STDOUT COMMAND_ERROR_IS_FATAL ANY)
endfunction()

# Runs a checker, if there is one: it must succeed and have nothing to say.
function(check tool)
  find_program(found_${tool} ${tool})
  if(NOT found_${tool})
    message(STATUS "Not checked, there is no ${tool}: ${ARGN}")
    return()
  endif()
  execute_process(COMMAND "${found_${tool}}" ${ARGN} OUTPUT_QUIET ERROR_VARIABLE errors COMMAND_ERROR_IS_FATAL ANY)
  if(errors)
    message(FATAL_ERROR "${tool} ${ARGN}: ${errors}")
  endif()
endfunction()

function(expect_file file)
  if(NOT EXISTS "${file}")
    message(FATAL_ERROR "there is no ${file}")
  endif()
endfunction()

# Programs stay unstripped: to strip them takes seconds and tests nothing of ours.
file(REMOVE_RECURSE "${work}")
run("${CMAKE_CPACK_COMMAND}" -G DEB --config "${build}/CPackConfig.cmake" -B "${work}" -D CPACK_STRIP_FILES=OFF
  -D CPACK_DEBIAN_COMPRESSION_TYPE=gzip)
file(GLOB package "${work}/morphkit_*.deb")
file(GLOB development "${work}/libmorphkit-dev_*.deb")
expect_file("${development}")

execute_process(COMMAND dpkg-deb --field "${package}" Depends OUTPUT_VARIABLE depends COMMAND_ERROR_IS_FATAL ANY)
foreach(needed ffmpeg fonts-dejavu-core libopencv-core)
  if(NOT depends MATCHES "${needed}")
    message(FATAL_ERROR "the package does not depend on ${needed}: ${depends}")
  endif()
endforeach()

# There is no address to write to: the package invents none.
foreach(file "${package}" "${development}")
  execute_process(COMMAND dpkg-deb --field "${file}" Maintainer OUTPUT_VARIABLE maintainer
    OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
  if(NOT maintainer STREQUAL "The morphkit authors")
    message(FATAL_ERROR "the maintainer of ${file} is ${maintainer}")
  endif()
endforeach()

set(root "${work}/root")
run(dpkg-deb --extract "${package}" "${root}")
set(program "${root}/usr/bin/morphkit")
run("${program}" --version)
run("${program}" demo objects --frame-count 3 --output "${work}/demo")
expect_file("${work}/demo/objects.mp4")

set(share "${root}/usr/share")
expect_file("${share}/doc/morphkit/copyright")
expect_file("${share}/icons/hicolor/scalable/apps/morphkit.svg")
check(desktop-file-validate "${share}/applications/morphkit.desktop")
check(bash -n "${share}/bash-completion/completions/morphkit")
check(zsh -n "${share}/zsh/vendor-completions/_morphkit")
check(fish --no-execute "${share}/fish/vendor_completions.d/morphkit.fish")

execute_process(COMMAND "${program}" help --man OUTPUT_VARIABLE overview COMMAND_ERROR_IS_FATAL ANY)
set(commands edit morph warp map import export check info compare bench demo schema completion help)
foreach(command IN LISTS commands)
  if(NOT overview MATCHES "morphkit.-${command} ")
    message(FATAL_ERROR "the page of the program does not name ${command}")
  endif()
  expect_file("${share}/man/man1/morphkit-${command}.1.gz")
endforeach()
set(ENV{LC_ALL} C.UTF-8)
file(GLOB pages "${share}/man/man1/*.1.gz")
foreach(page IN LISTS pages)
  check(man --warnings --local-file "${page}")
endforeach()
file(REMOVE_RECURSE "${work}")
