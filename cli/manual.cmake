# SPDX-License-Identifier: Apache-2.0
# What the command makes of its own definitions: manual pages and completion scripts; and what is installed with it.

# The day of the last change of the pages, so that two builds give the same bytes; SOURCE_DATE_EPOCH counts before it.
set(date 2026-11-26)
if(DEFINED ENV{SOURCE_DATE_EPOCH})
  string(TIMESTAMP date "%Y-%m-%d" UTC)
endif()
set(made ${PROJECT_BINARY_DIR}/manual)
set(scripts ${PROJECT_BINARY_DIR}/completion)
add_custom_command(
  OUTPUT ${made}/stamp
  COMMAND ${CMAKE_COMMAND} -E rm -rf ${made} ${scripts}
  COMMAND ${CMAKE_COMMAND} -E make_directory ${made} ${scripts}
  COMMAND toolcomp manual --date ${date} ${made}
  COMMAND toolcomp completion bash > ${scripts}/toolcomp
  COMMAND toolcomp completion zsh > ${scripts}/_toolcomp
  COMMAND toolcomp completion fish > ${scripts}/toolcomp.fish
  COMMAND ${CMAKE_COMMAND} -E touch ${made}/stamp
  DEPENDS toolcomp
  VERBATIM
  COMMENT "Writing manual pages and completion scripts")
add_custom_target(toolcomp_manual ALL DEPENDS ${made}/stamp)

# Where shells look; Debian's zsh looks in share/zsh/vendor-completions.
set(TOOLCOMP_ZSH_COMPLETIONS ${CMAKE_INSTALL_DATADIR}/zsh/site-functions CACHE STRING "Folder of zsh's completion")
install(DIRECTORY ${made}/ DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT tool FILES_MATCHING PATTERN "*.1")
install(FILES ${scripts}/toolcomp DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions COMPONENT tool)
install(FILES ${scripts}/_toolcomp DESTINATION ${TOOLCOMP_ZSH_COMPLETIONS} COMPONENT tool)
install(FILES ${scripts}/toolcomp.fish DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d COMPONENT tool)

# For editors: the schemas, and files of VS Code and Vim (docs/editors.md).
file(GLOB schemas CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/corpus/schema/*.json)
install(FILES ${schemas} DESTINATION ${CMAKE_INSTALL_DATADIR}/toolcomp COMPONENT tool)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/share/editors DESTINATION ${CMAKE_INSTALL_DATADIR}/toolcomp COMPONENT tool)
