# leadline_plugin(NAME straight-line KIND engine SOURCES a.cpp [LINKS x::y]): the loadable module
# leadline_straight_line.so. Its metadata (name, kind, interface number and hash) is written here as
# leadline_plugin.json, which Q_PLUGIN_METADATA of the plugin's root class names. KIND: engine or decoder.
function(leadline_plugin)
  cmake_parse_arguments(ARG "" "NAME;KIND" "SOURCES;LINKS" ${ARGN})
  string(REPLACE "-" "_" target leadline_${ARG_NAME})
  add_library(${target} MODULE ${ARG_SOURCES})
  leadline_plugin_metadata(${target} [[{
  "name": "@ARG_NAME@",
  "kind": "@ARG_KIND@",
  "interface": @LEADLINE_INTERFACE_NUMBER@,
  "interface_hash": "@LEADLINE_INTERFACE_HASH@"
}
]])
  target_link_libraries(${target} PRIVATE leadline::sdk ${ARG_LINKS})
  target_compile_features(${target} PRIVATE cxx_std_20)
  # The program's own arithmetic: no fused multiply-add, so that a replay gives the same bits everywhere.
  target_compile_options(${target} PRIVATE -ffp-contract=off)
  set_target_properties(${target} PROPERTIES PREFIX "" AUTOMOC ON POSITION_INDEPENDENT_CODE ON)
  if(NOT LEADLINE_SANITIZE)
    target_link_options(${target} PRIVATE -Wl,-z,defs)  # what is missing is told here, not at sea
  endif()
endfunction()

# Writes leadline_plugin.json where moc finds it. AUTOMOC does not see that the file changed, only that the
# include path did: the folder is named after the content.
function(leadline_plugin_metadata target template)
  string(CONFIGURE "${template}" content @ONLY)
  string(SHA256 hash "${content}")
  string(SUBSTRING ${hash} 0 16 hash)
  set(folder ${CMAKE_CURRENT_BINARY_DIR}/${target}_metadata/${hash})
  file(CONFIGURE OUTPUT ${folder}/leadline_plugin.json CONTENT "${content}" @ONLY)
  target_include_directories(${target} PRIVATE ${folder})
endfunction()
