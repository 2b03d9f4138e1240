# find_package(sunder CONFIG) gives sunder::core and sunder::io. One export set each, so that the core can be used where
# the readers' packages are not installed.
include(CMakePackageConfigHelpers)
set(SUNDER_CMAKE_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/sunder)

foreach(part core io)
  if(TARGET sunder_${part})
    install(TARGETS sunder_${part} EXPORT sunder_${part}_targets COMPONENT library
      FILE_SET HEADERS DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT library)
    install(EXPORT sunder_${part}_targets FILE sunder_${part}_targets.cmake NAMESPACE sunder::
      DESTINATION ${SUNDER_CMAKE_DIR} COMPONENT library)
  endif()
endforeach()

foreach(component library program)
  install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT ${component})
endforeach()

configure_package_config_file(cmake/sunderConfig.cmake.in ${PROJECT_BINARY_DIR}/sunderConfig.cmake
  INSTALL_DESTINATION ${SUNDER_CMAKE_DIR})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/sunderConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/sunderConfig.cmake ${PROJECT_BINARY_DIR}/sunderConfigVersion.cmake
  DESTINATION ${SUNDER_CMAKE_DIR} COMPONENT library)
