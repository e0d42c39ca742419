# Python for Windows where this machine cross-compiles: CMake's own FindPython wants an interpreter of that version that runs here.
# TAMIS_WINDOWS_PYTHON is the folder of scripts/windows_python.sh, Python_EXECUTABLE the interpreter that builds the wheel.
set(Python_FOUND TRUE)
set(Python_VERSION 3.12)  # of the stable ABI: the oldest that nanobind inside the module can use
set(SKBUILD_SABI_VERSION ${Python_VERSION})
set(SKBUILD_SOABI cp312)
set(SKBUILD_SOSABI "")  # a module's file is _core.pyd
set(Python_INTERPRETER_ID Python)
set(Python_INCLUDE_DIRS ${TAMIS_WINDOWS_PYTHON}/include)
add_executable(Python::Interpreter IMPORTED)
set_target_properties(Python::Interpreter PROPERTIES IMPORTED_LOCATION ${Python_EXECUTABLE})
foreach(name Module SABIModule)
  add_library(Python::${name} INTERFACE IMPORTED)
  target_include_directories(Python::${name} INTERFACE ${Python_INCLUDE_DIRS})
  target_link_libraries(Python::${name} INTERFACE ${TAMIS_WINDOWS_PYTHON}/libs/python3.lib)
endforeach()
