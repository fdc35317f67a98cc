# Writes the manual pages and the completions of the program.
# Arguments: program, share (the folder to write into), gzip (the program that packs manual pages).
function(ask file)
  execute_process(COMMAND "${program}" ${ARGN} OUTPUT_FILE "${file}" COMMAND_ERROR_IS_FATAL ANY)
endfunction()

set(man "${share}/man/man1")
file(REMOVE_RECURSE "${share}/man" "${share}/completions")
file(MAKE_DIRECTORY "${man}" "${share}/completions")

# The page of the program names those of its commands.
ask("${man}/morphkit.1" help --man)
file(STRINGS "${man}/morphkit.1" mentions REGEX "^\\.BR morphkit\\\\-[a-z]+ ")
foreach(mention IN LISTS mentions)
  string(REGEX REPLACE "^\\.BR morphkit\\\\-([a-z]+) .*" "\\1" command "${mention}")
  ask("${man}/morphkit-${command}.1" help --man ${command})
endforeach()
file(GLOB pages "${man}/*.1")
execute_process(COMMAND "${gzip}" -9n ${pages} COMMAND_ERROR_IS_FATAL ANY)

foreach(shell bash zsh fish)
  ask("${share}/completions/morphkit.${shell}" completion ${shell})
endforeach()
