# Arguments: build, source (of morphkit), work (a directory of our own), compiler, launcher, sanitize.
function(run)
  execute_process(COMMAND ${ARGN} COMMAND_ECHO STDOUT COMMAND_ERROR_IS_FATAL ANY)
endfunction()

file(REMOVE_RECURSE "${work}")
run("${CMAKE_COMMAND}" --install "${build}" --prefix "${work}/prefix")
run("${work}/prefix/bin/morphkit" --version)
run("${work}/prefix/bin/morphkit" demo --list)

# A package that names the tree it was built in works here and nowhere else.
file(GLOB_RECURSE package_files "${work}/prefix/*.cmake")
foreach(file IN LISTS package_files)
  file(STRINGS "${file}" leaks REGEX "${source}/(warp|morph|samples|cmake)|${build}/(warp|morph|samples)")
  if(leaks)
    message(FATAL_ERROR "${file} names the source or build tree: ${leaks}")
  endif()
endforeach()

set(flags "")
if(sanitize)
  set(flags "-fsanitize=${sanitize}")
endif()
run("${CMAKE_COMMAND}" -G Ninja -S "${CMAKE_CURRENT_LIST_DIR}/outside" -B "${work}/outside"
  -D "CMAKE_PREFIX_PATH=${work}/prefix" -D "CMAKE_CXX_COMPILER=${compiler}" -D CMAKE_BUILD_TYPE=Release
  -D "CMAKE_CXX_COMPILER_LAUNCHER=${launcher}" -D "CMAKE_CXX_FLAGS=${flags}")
run("${CMAKE_COMMAND}" --build "${work}/outside")
run("${work}/outside/bend")
run("${work}/outside/dissolve")

# The examples, as people copy them.
run("${work}/prefix/bin/morphkit" demo objects --frame-count 3 --output "${work}/demo" --quiet)
foreach(example link_warp link_morph)
  run("${CMAKE_COMMAND}" -G Ninja -S "${source}/examples/${example}" -B "${work}/${example}"
    -D "CMAKE_PREFIX_PATH=${work}/prefix" -D "CMAKE_CXX_COMPILER=${compiler}" -D CMAKE_BUILD_TYPE=Release
    -D "CMAKE_CXX_COMPILER_LAUNCHER=${launcher}" -D "CMAKE_CXX_FLAGS=${flags}")
  run("${CMAKE_COMMAND}" --build "${work}/${example}")
endforeach()
run("${work}/link_warp/link_warp" "${work}/bent.ppm")
run("${work}/prefix/bin/morphkit" info "${work}/bent.ppm")
file(WRITE "${work}/demo/small.json" [[{"morphkit": 1, "source": {"image": "pear.png"}, "destination": {"image": "bulb.png"},
  "output": {"size": [160, 160], "frames": 3}}]])
run("${work}/link_morph/link_morph" "${work}/demo/small.json" "${work}/frame.%04d.png")
run("${work}/prefix/bin/morphkit" info "${work}/frame.0001.png" "${work}/frame.0002.png" "${work}/frame.0003.png")
file(REMOVE_RECURSE "${work}")
