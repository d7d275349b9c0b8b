# `cmake --install`: the program with what it loads, and the SDK that plugins are built with.
include(CMakePackageConfigHelpers)
set(package ${PROJECT_BINARY_DIR}/package)
set(package_destination lib/cmake/leadline)

install(TARGETS leadline RUNTIME DESTINATION bin)
set_target_properties(leadline_navigation PROPERTIES INSTALL_RPATH $ORIGIN/../..)
install(TARGETS leadline_navigation LIBRARY DESTINATION lib/leadline/plugins)
install(TARGETS leadline-console LIBRARY DESTINATION lib)
set_target_properties(leadline-console PROPERTIES INSTALL_RPATH $ORIGIN)
install(DIRECTORY ${PROJECT_BINARY_DIR}/charts/ DESTINATION share/leadline/charts)
install(DIRECTORY ${PROJECT_BINARY_DIR}/magnetic/ DESTINATION share/leadline/magnetic
  FILES_MATCHING PATTERN "*.wmm" PATTERN "*.wmm.cof")

install(TARGETS leadline-core plugins_sdk EXPORT leadline LIBRARY DESTINATION lib)
foreach(folder core/types core/messages core/flow core/geo plugins/sdk)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/${folder}/ DESTINATION include/leadline/${folder}
    FILES_MATCHING PATTERN "*.h" PATTERN tools EXCLUDE PATTERN magnetic EXCLUDE)
endforeach()
install(FILES ${PROJECT_BINARY_DIR}/generated/plugins/sdk/interface_version.h
  DESTINATION include/leadline/plugins/sdk)

install(EXPORT leadline NAMESPACE leadline:: FILE leadlineTargets.cmake DESTINATION ${package_destination})
configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/leadlineConfig.cmake.in
  ${package}/leadlineConfig.cmake INSTALL_DESTINATION ${package_destination})
write_basic_package_version_file(${package}/leadlineConfigVersion.cmake COMPATIBILITY ExactVersion)
install(FILES ${package}/leadlineConfig.cmake ${package}/leadlineConfigVersion.cmake
  ${PROJECT_SOURCE_DIR}/cmake/leadline_plugin.cmake DESTINATION ${package_destination})
