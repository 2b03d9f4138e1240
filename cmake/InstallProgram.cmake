# The program, the verifier in Python, and the manual page and completions, which the program writes itself.
install(TARGETS sunder_cli COMPONENT program)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/verifier/python/sunder_verify
  DESTINATION ${CMAKE_INSTALL_DATADIR}/sunder/python COMPONENT program FILES_MATCHING PATTERN "*.py")
install(FILES ${PROJECT_SOURCE_DIR}/docs/schema/report.schema.json ${PROJECT_SOURCE_DIR}/docs/schema/scene.schema.json
  DESTINATION ${CMAKE_INSTALL_DATADIR}/sunder/schema COMPONENT program)
if(NOT CMAKE_CROSSCOMPILING)
  foreach(made "--man;man/man1/sunder.1" "--completion=bash;bash-completion/completions/sunder"
               "--completion=zsh;zsh/site-functions/_sunder" "--completion=fish;fish/vendor_completions.d/sunder.fish")
    list(GET made 0 option)
    list(GET made 1 file)
    get_filename_component(folder ${file} DIRECTORY)
    set(written ${PROJECT_BINARY_DIR}/share/${file})
    file(MAKE_DIRECTORY ${PROJECT_BINARY_DIR}/share/${folder})
    install(CODE "execute_process(COMMAND \"$<TARGET_FILE:sunder_cli>\" ${option} OUTPUT_FILE \"${written}\"
      COMMAND_ERROR_IS_FATAL ANY)" COMPONENT program)
    install(FILES ${written} DESTINATION ${CMAKE_INSTALL_DATADIR}/${folder} COMPONENT program)
  endforeach()
endif()
