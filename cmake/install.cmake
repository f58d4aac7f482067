# SPDX-License-Identifier: Apache-2.0
# What `cmake --install` puts where, in two components: the program with its data, and what others build upon.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)
set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/pyrasim)
set(header_folder ${CMAKE_INSTALL_INCLUDEDIR}/pyrasim)

# The libraries, as pyrasim::core and pyrasim::hw; inside this project those names mean the same.
foreach(part IN ITEMS core hw run systemc flags fst)
  add_library(pyrasim::${part} ALIAS pyrasim_${part})
  set_target_properties(pyrasim_${part} PROPERTIES EXPORT_NAME ${part})
endforeach()

# Headers are included by the same names as in this project: "scene/load_scene.h", "hw_model/processor.h".
file(GLOB_RECURSE core_headers CONFIGURE_DEPENDS src/*.h)
list(FILTER core_headers EXCLUDE REGEX "/src/(cli|run)/")
file(GLOB run_headers CONFIGURE_DEPENDS src/run/*.h)
file(GLOB_RECURSE machine_headers CONFIGURE_DEPENDS hw_model/*.h)
target_sources(pyrasim_core PUBLIC FILE_SET HEADERS BASE_DIRS src FILES ${core_headers})
target_sources(pyrasim_hw PUBLIC FILE_SET HEADERS BASE_DIRS . FILES ${machine_headers})
target_sources(pyrasim_run PUBLIC FILE_SET HEADERS BASE_DIRS src FILES ${run_headers})
install(TARGETS pyrasim_core pyrasim_hw pyrasim_run pyrasim_systemc pyrasim_flags pyrasim_fst EXPORT pyrasim
        ARCHIVE COMPONENT development
        FILE_SET HEADERS DESTINATION ${header_folder} COMPONENT development
        INCLUDES DESTINATION ${header_folder})

install(EXPORT pyrasim NAMESPACE pyrasim:: FILE pyrasimTargets.cmake DESTINATION ${package_folder}
        COMPONENT development)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/pyrasimConfigVersion.cmake COMPATIBILITY SameMinorVersion)
configure_package_config_file(cmake/pyrasimConfig.cmake.in ${PROJECT_BINARY_DIR}/pyrasimConfig.cmake
                              INSTALL_DESTINATION ${package_folder} PATH_VARS CMAKE_INSTALL_DATADIR)
install(FILES ${PROJECT_BINARY_DIR}/pyrasimConfig.cmake ${PROJECT_BINARY_DIR}/pyrasimConfigVersion.cmake
        DESTINATION ${package_folder} COMPONENT development)

install(TARGETS pyrasim RUNTIME COMPONENT program)
install(DIRECTORY scenes machines docs/schemas DESTINATION ${CMAKE_INSTALL_DATADIR}/pyrasim COMPONENT program)

# The manual page and the shells' completion are what the program says of itself.
set(documents ${PROJECT_BINARY_DIR}/documents)
install(CODE "
  foreach(document IN ITEMS \"man>pyrasim.1\" \"completion bash>pyrasim\" \"completion zsh>_pyrasim\"
                            \"completion fish>pyrasim.fish\")
    string(REGEX MATCH \"(.*)>(.*)\" whole \"\${document}\")
    set(file \"${documents}/\${CMAKE_MATCH_2}\")
    separate_arguments(arguments UNIX_COMMAND \"\${CMAKE_MATCH_1}\")
    file(MAKE_DIRECTORY \"${documents}\")
    execute_process(COMMAND \"$<TARGET_FILE:pyrasim>\" \${arguments} OUTPUT_FILE \"\${file}\" COMMAND_ERROR_IS_FATAL ANY)
  endforeach()" COMPONENT program)
install(FILES ${documents}/pyrasim.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT program)
install(FILES ${documents}/pyrasim DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions COMPONENT program)
install(FILES ${documents}/pyrasim.fish DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d
        COMPONENT program)
# zsh looks in one folder for what is installed by hand, in another one for packages.
install(FILES ${documents}/_pyrasim DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/site-functions COMPONENT by_hand)
install(FILES ${documents}/_pyrasim DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/vendor-completions COMPONENT program
        EXCLUDE_FROM_ALL)

include(cmake/package.cmake)
