# SPDX-License-Identifier: Apache-2.0
# Installed: the command with the files it needs, the library of C, and the libraries of the specification and both
# engines, found by find_package(toolcomp) and by pkg-config.
include(CMakePackageConfigHelpers)

set(engines toolcomp_options toolcomp_spec toolcomp_exact toolcomp_model toolcomp_fast)
foreach(library ${engines} toolcomp_c)
  string(REPLACE "toolcomp_" "" short ${library})
  set_target_properties(${library} PROPERTIES EXPORT_NAME ${short})
endforeach()
set(config ${CMAKE_INSTALL_LIBDIR}/cmake/toolcomp)
set(headers ${CMAKE_INSTALL_INCLUDEDIR}/toolcomp)

install(TARGETS toolcomp RUNTIME)
install(TARGETS toolcomp_c EXPORT c LIBRARY PUBLIC_HEADER)
install(TARGETS ${engines} EXPORT engines ARCHIVE)
install(DIRECTORY spec model fast DESTINATION ${headers} FILES_MATCHING PATTERN "*.h" PATTERN formal EXCLUDE PATTERN coverage EXCLUDE)
install(FILES ${PROJECT_BINARY_DIR}/generated/spec/clauses/clauses.h DESTINATION ${headers}/spec/clauses)
install(FILES ${PROJECT_BINARY_DIR}/generated/spec/parameters/keys.h
  ${PROJECT_BINARY_DIR}/generated/spec/parameters/alarm_causes.h DESTINATION ${headers}/spec/parameters)
install(EXPORT c NAMESPACE toolcomp:: FILE toolcompC.cmake DESTINATION ${config})
install(EXPORT engines NAMESPACE toolcomp:: FILE toolcompEngines.cmake DESTINATION ${config})
configure_package_config_file(cmake/toolcompConfig.cmake.in ${PROJECT_BINARY_DIR}/toolcompConfig.cmake
  INSTALL_DESTINATION ${config})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/toolcompConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/toolcompConfig.cmake ${PROJECT_BINARY_DIR}/toolcompConfigVersion.cmake
  DESTINATION ${config})

# The way from lib/pkgconfig back to the prefix: an installed tree may be moved.
file(RELATIVE_PATH up /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)
string(REGEX REPLACE "/$" "" up "${up}")
foreach(name toolcomp toolcomp-engines)
  configure_file(cmake/${name}.pc.in ${PROJECT_BINARY_DIR}/${name}.pc @ONLY)
  install(FILES ${PROJECT_BINARY_DIR}/${name}.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
endforeach()

# What the command reads (host/data_folder.h): controllers by name (docs/adapters.md), the golden corpus, hard
# cases, and first inputs of a search. Schemas are installed with the files for editors (cli/manual.cmake).
set(data ${CMAKE_INSTALL_DATADIR}/toolcomp)
install(DIRECTORY adapters DESTINATION ${data} COMPONENT data USE_SOURCE_PERMISSIONS PATTERN __pycache__ EXCLUDE)
foreach(folder golden hard regression seeds)
  install(DIRECTORY corpus/${folder} DESTINATION ${data}/corpus COMPONENT data)
endforeach()
install(FILES corpus/proofs/unproven.json DESTINATION ${data}/corpus/proofs COMPONENT data)
install(DIRECTORY examples DESTINATION ${data} COMPONENT data PATTERN __pycache__ EXCLUDE)
# Test vectors that need nothing of ours (docs/starter.md).
install(DIRECTORY corpus/starter/ DESTINATION ${CMAKE_INSTALL_DATADIR}/toolcomp-starter USE_SOURCE_PERMISSIONS
  PATTERN sources EXCLUDE PATTERN generate.py EXCLUDE PATTERN LICENSE EXCLUDE PATTERN __pycache__ EXCLUDE)
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})
