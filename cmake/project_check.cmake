# project_check(name command...): a check of the source tree or of built files. Exit code 77 skips it.
function(project_check name)
  add_test(NAME project.${name} COMMAND ${ARGN} WORKING_DIRECTORY ${PROJECT_SOURCE_DIR} COMMAND_EXPAND_LISTS)
  set_tests_properties(project.${name} PROPERTIES LABELS "project;${CMAKE_DIRECTORY_LABELS}" SKIP_RETURN_CODE 77 TIMEOUT 3000)
endfunction()
