# SPDX-License-Identifier: LGPL-2.1-or-later
# Installs the manual page and the completions, which the program itself prints, into the folders where man and the
# shells look for them. For zsh there are two folders: Debian's zsh looks in another one than a zsh installed from
# its sources.
set(pages ${CMAKE_BINARY_DIR}/pages)
file(MAKE_DIRECTORY ${pages})
set(page_files)
foreach(page "swept.1 manual" "swept completion bash" "_swept completion zsh" "swept.fish completion fish")
  separate_arguments(words UNIX_COMMAND ${page})
  list(POP_FRONT words name)
  add_custom_command(OUTPUT ${pages}/${name} COMMAND swept ${words} >${pages}/${name} DEPENDS swept)
  list(APPEND page_files ${pages}/${name})
endforeach()
add_custom_target(swept_pages ALL DEPENDS ${page_files})
install(FILES ${pages}/swept.1 DESTINATION share/man/man1 COMPONENT program)
install(FILES ${pages}/swept DESTINATION share/bash-completion/completions COMPONENT program)
install(FILES ${pages}/_swept DESTINATION share/zsh/site-functions COMPONENT program)
install(FILES ${pages}/_swept DESTINATION share/zsh/vendor-completions COMPONENT program)
install(FILES ${pages}/swept.fish DESTINATION share/fish/vendor_completions.d COMPONENT program)
