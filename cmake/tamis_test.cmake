# tamis_test(name source...): one GoogleTest program of a layer; it may include the library's own headers.
include(GoogleTest)
function(tamis_test name)
  add_executable(${name} ${ARGN})
  tamis_target(${name})
  target_include_directories(${name} PRIVATE ${PROJECT_SOURCE_DIR}/src)
  target_link_libraries(${name} PRIVATE tamis::tamis GTest::gtest_main)
  gtest_discover_tests(${name} DISCOVERY_MODE PRE_TEST PROPERTIES TIMEOUT ${TAMIS_TEST_TIMEOUT})
endfunction()
