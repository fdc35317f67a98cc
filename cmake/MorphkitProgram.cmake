# What a desktop and a shell expect beside the program: manual pages, completions, a desktop entry and its icon. The
# program itself writes the first two, after each build, so that they never lag behind it.
find_program(GZIP gzip REQUIRED)
mark_as_advanced(GZIP)

set(share "${PROJECT_BINARY_DIR}/share")
add_custom_command(
  OUTPUT "${share}/pages.stamp"
  COMMAND ${CMAKE_COMMAND} -D "program=$<TARGET_FILE:morphkit_cli>" -D "share=${share}" -D "gzip=${GZIP}"
    -P "${PROJECT_SOURCE_DIR}/cmake/write_pages.cmake"
  COMMAND ${CMAKE_COMMAND} -E touch "${share}/pages.stamp"
  DEPENDS morphkit_cli "${PROJECT_SOURCE_DIR}/cmake/write_pages.cmake"
  COMMENT "Manual pages and completions"
  VERBATIM)
add_custom_target(morphkit_pages ALL DEPENDS "${share}/pages.stamp")

# Debian's zsh looks for the completions of packages in a folder of its own.
set(zsh_folder site-functions)
if(EXISTS /etc/debian_version)
  set(zsh_folder vendor-completions)
endif()
set(data "${CMAKE_INSTALL_DATADIR}")
install(DIRECTORY "${share}/man/" DESTINATION "${CMAKE_INSTALL_MANDIR}")
install(FILES "${share}/completions/morphkit.bash" RENAME morphkit
  DESTINATION "${data}/bash-completion/completions")
install(FILES "${share}/completions/morphkit.zsh" RENAME _morphkit
  DESTINATION "${data}/zsh/${zsh_folder}")
install(FILES "${share}/completions/morphkit.fish" DESTINATION "${data}/fish/vendor_completions.d")

install(FILES cli/desktop/morphkit.desktop DESTINATION "${data}/applications")
install(FILES cli/desktop/morphkit.svg DESTINATION "${data}/icons/hicolor/scalable/apps")
