# How every floor declares what it builds: its tests, micro-benchmarks and fuzz targets.

# isobench_tests(floor [LABEL label] LIBRARIES … SOURCES … [THREADS test …])
#
# One program a floor and label. LABEL is "unit" unless given, or one of
#   slow     minutes instead of seconds
#   volumes  needs the real volumes; skips without ISOBENCH_DATA
#   cluster  starts a Slurm cluster on this machine; skips where there is no Slurm
#   browser  opens the page in Chromium; skips where there is none
# and is what `ctest --label-regex` chooses by. Tests named by THREADS are about threads and carry the label "threads" as
# well: the thread sanitizer runs them.
function(isobench_tests floor)
  cmake_parse_arguments(arg "" "LABEL" "LIBRARIES;SOURCES;THREADS" ${ARGN})
  if(NOT ISOBENCH_TESTS)
    return()
  endif()
  if(NOT arg_LABEL)
    set(arg_LABEL unit)
  endif()
  set(program ${floor}_${arg_LABEL}_tests)
  add_executable(${program} ${arg_SOURCES})
  target_link_libraries(${program} PRIVATE ${arg_LIBRARIES} GTest::gtest GTest::gtest_main)
  # Most of a test's code runs once: compiling it takes longer than -O1 loses.
  target_compile_options(${program} PRIVATE $<$<CONFIG:Release>:-O1>)
  add_dependencies(isobench_${arg_LABEL}_tests ${program})
  set(common NO_PRETTY_VALUES TEST_PREFIX ${floor}/ DISCOVERY_TIMEOUT 60)
  # The long ones begin first, so that no core waits for the last of them alone.
  set(cost 0)
  if(NOT arg_LABEL STREQUAL unit)
    set(cost 100)
  endif()
  set(others "")
  if(arg_THREADS)
    list(JOIN arg_THREADS ":" threads)
    gtest_discover_tests(${program} TEST_FILTER "${threads}" ${common}
      PROPERTIES TIMEOUT 900 COST ${cost} LABELS "${arg_LABEL};threads")
    set(others TEST_FILTER "-${threads}")
  endif()
  gtest_discover_tests(${program} ${others} ${common} PROPERTIES TIMEOUT 900 COST ${cost} LABELS ${arg_LABEL})
endfunction()

# isobench_benchmarks(floor LIBRARIES … SOURCES …): one benchmark program a floor.
function(isobench_benchmarks floor)
  if(NOT ISOBENCH_BENCHMARKS)
    return()
  endif()
  cmake_parse_arguments(arg "" "" "LIBRARIES;SOURCES" ${ARGN})
  add_executable(${floor}_benchmarks ${arg_SOURCES})
  target_link_libraries(${floor}_benchmarks PRIVATE ${arg_LIBRARIES} benchmark::benchmark benchmark::benchmark_main)
endfunction()

# isobench_fuzz_targets(floor LIBRARIES … SOURCES … TARGETS name …): see foundation/testing/fuzz_target.h. Call it after
# isobench_tests(), whose unit tests get one for each target's corpus.
function(isobench_fuzz_targets floor)
  cmake_parse_arguments(arg "" "" "LIBRARIES;SOURCES;TARGETS" ${ARGN})
  set(generated ${PROJECT_BINARY_DIR}/generated/${floor})
  set(templates ${PROJECT_SOURCE_DIR}/foundation/testing)
  set(declarations "")
  set(tests "")
  if(ISOBENCH_FUZZERS)
    add_library(isobench_${floor}_fuzz STATIC ${arg_SOURCES})
    target_link_libraries(isobench_${floor}_fuzz PUBLIC ${arg_LIBRARIES})
  endif()
  foreach(name ${arg_TARGETS})
    string(REPLACE "-" "_" function ${name})
    string(APPEND declarations "bool fuzz_${function}(std::string_view bytes);\n")
    string(APPEND tests
      "TEST(Corpus, ${function}) { try_corpus(\"${CMAKE_CURRENT_SOURCE_DIR}/corpus/${name}\", fuzz_${function}); }\n")
    if(ISOBENCH_FUZZERS)
      configure_file(${templates}/fuzz_entry.cpp.in ${generated}/fuzz_${function}.cpp @ONLY)
      add_executable(fuzz-${name} ${generated}/fuzz_${function}.cpp)
      target_link_libraries(fuzz-${name} PRIVATE isobench_${floor}_fuzz)
      target_link_options(fuzz-${name} PRIVATE -fsanitize=fuzzer)
      add_dependencies(fuzzers fuzz-${name})
    endif()
  endforeach()
  if(TARGET ${floor}_unit_tests)
    configure_file(${templates}/corpus_test.cpp.in ${generated}/corpus_test.cpp @ONLY)
    target_sources(${floor}_unit_tests PRIVATE ${arg_SOURCES} ${generated}/corpus_test.cpp)
  endif()
endfunction()

# isobench_code_of_readme(readme output): the first C++ block of a README as a source file, so that the text is compiled
# and cannot go stale.
function(isobench_code_of_readme readme output)
  file(READ ${readme} code)
  string(FIND "${code}" "```cpp\n" start)
  string(SUBSTRING "${code}" ${start} -1 code)
  string(SUBSTRING "${code}" 7 -1 code)
  string(FIND "${code}" "```" end)
  string(SUBSTRING "${code}" 0 ${end} code)
  file(CONFIGURE OUTPUT ${output} CONTENT "${code}" @ONLY)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${readme})
endfunction()

# With CMAKE_UNITY_BUILD, sources of one folder are compiled several at a time, because most of a compiler's time goes
# into the headers of Eigen, TBB, VTK and GoogleTest. Names in a folder's anonymous namespaces must therefore differ;
# those of other folders never meet.
function(isobench_unity_groups target)
  get_target_property(sources ${target} SOURCES)
  get_target_property(base ${target} SOURCE_DIR)
  foreach(source ${sources})
    cmake_path(ABSOLUTE_PATH source BASE_DIRECTORY ${base})
    cmake_path(IS_PREFIX PROJECT_BINARY_DIR ${source} is_generated)
    if(is_generated OR NOT source MATCHES "\\.cpp$")
      continue()
    endif()
    cmake_path(GET source PARENT_PATH folder)
    cmake_path(RELATIVE_PATH folder BASE_DIRECTORY ${PROJECT_SOURCE_DIR})
    string(MAKE_C_IDENTIFIER "${folder}" folder)
    math(EXPR count_${folder} "0${count_${folder}} + 1")
    math(EXPR group "(${count_${folder}} - 1) / ${ISOBENCH_UNITY_SIZE}")
    set_property(SOURCE ${source} TARGET_DIRECTORY ${target} PROPERTY UNITY_GROUP ${folder}_${group})
  endforeach()
  set_property(TARGET ${target} PROPERTY UNITY_BUILD_MODE GROUP)
endfunction()
