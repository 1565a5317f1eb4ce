# Installed: the command and the libraries of the specification and both engines, found by find_package(toolcomp).
include(CMakePackageConfigHelpers)

set(libraries toolcomp_options toolcomp_spec toolcomp_exact toolcomp_model toolcomp_fast)
foreach(library ${libraries})
  string(REPLACE "toolcomp_" "" short ${library})
  set_target_properties(${library} PROPERTIES EXPORT_NAME ${short})
endforeach()
install(TARGETS toolcomp RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(TARGETS ${libraries} EXPORT toolcomp ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(DIRECTORY spec model fast DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/toolcomp FILES_MATCHING PATTERN "*.h")
install(FILES ${PROJECT_BINARY_DIR}/generated/spec/clauses/clauses.h DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/toolcomp/spec/clauses)
install(FILES ${PROJECT_BINARY_DIR}/generated/spec/parameters/keys.h DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/toolcomp/spec/parameters)
install(EXPORT toolcomp NAMESPACE toolcomp:: FILE toolcompTargets.cmake DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/toolcomp)
configure_package_config_file(cmake/toolcompConfig.cmake.in ${PROJECT_BINARY_DIR}/toolcompConfig.cmake
  INSTALL_DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/toolcomp)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/toolcompConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/toolcompConfig.cmake ${PROJECT_BINARY_DIR}/toolcompConfigVersion.cmake
  DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/toolcomp)
# Where certify --controller NAME looks (docs/adapters.md).
install(DIRECTORY adapters DESTINATION ${CMAKE_INSTALL_DATADIR}/toolcomp PATTERN __pycache__ EXCLUDE)
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})
