include(GoogleTest)

function(tamis_test_options name)
  tamis_target(${name})
  tamis_optimise_less(${name})
endfunction()

# Makes an executable a program of tests.
function(tamis_test_program name)
  tamis_test_options(${name})
  target_precompile_headers(${name} REUSE_FROM tamis_test_headers)
endfunction()

# WebAssembly has no threads, no clock of processor time, no memory that is forbidden, and one floating-point state.
set(TAMIS_NOT_HERE)
if(EMSCRIPTEN)
  set(TAMIS_NOT_HERE "InParts.*:CountingSort.FindsPlacesByBucketThenInOrder:BusyDetector.AnswersOneThread*:Roots.need_little_stack:\
*CancellationWait*:*HardPaths*:HardPairs.*:Crowd.CancellingIsAskedForAllTheTime:ExactRecontact.TakesNoMoreBitsThanTwoTimesNeed:\
LentThreads.*:*Invariance.AnyNumberOfThreads*:*PairStreams.*/2:ProximityOrder.*:*CallerState*:*InCallersState*:*OfThreads*:*GuardPages*")
endif()

# tamis_test(name source...): one GoogleTest program of a layer; it may include the library's own headers.
function(tamis_test name)
  add_executable(${name} ${ARGN})
  tamis_test_program(${name})
  target_include_directories(${name} PRIVATE ${PROJECT_SOURCE_DIR}/src)
  target_link_libraries(${name} PRIVATE tamis::tamis GTest::gtest_main)
  if(EMSCRIPTEN OR WIN32)  # Node and Wine take longer to start than most tests take
    add_test(NAME ${name} COMMAND ${name} --gtest_brief=1 --gtest_filter=-${TAMIS_NOT_HERE})
    set_tests_properties(${name} PROPERTIES TIMEOUT ${TAMIS_TEST_TIMEOUT}0)  # of many tests
    return()
  endif()
  gtest_discover_tests(${name} DISCOVERY_MODE PRE_TEST PROPERTIES TIMEOUT ${TAMIS_TEST_TIMEOUT})
endfunction()

# An executable that is never run: it has the settings of the tests, so that they can reuse its precompiled headers.
file(CONFIGURE OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/test_headers.cpp CONTENT "int main() {}\n")
add_executable(tamis_test_headers ${CMAKE_CURRENT_BINARY_DIR}/test_headers.cpp)
tamis_test_options(tamis_test_headers)
target_link_libraries(tamis_test_headers PRIVATE GTest::gtest)
target_precompile_headers(tamis_test_headers PRIVATE ${tamis_common_headers} <gtest/gtest.h>)
