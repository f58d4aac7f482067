# SPDX-License-Identifier: Apache-2.0
# Makes C++ of the trace page: index.html with the style sheets and scripts that it names in their places, in pieces.
# Usage: cmake -D PAGE=FOLDER -D OUTPUT=FILE -P embed_page.cmake
file(READ ${PAGE}/index.html rest)
set(pieces "")
function(add_piece text)
  set(pieces "${pieces}    R\"~~~(${text})~~~\",\n" PARENT_SCOPE)
endfunction()
set(mark "<link rel=\"stylesheet\" href=\"([^\"]+)\">|<script src=\"([^\"]+)\"></script>|<!-- runs -->")
while(rest MATCHES "${mark}")
  set(found "${CMAKE_MATCH_0}")
  set(style "${CMAKE_MATCH_1}")
  set(script "${CMAKE_MATCH_2}")
  string(FIND "${rest}" "${found}" at)
  string(SUBSTRING "${rest}" 0 ${at} before)
  string(LENGTH "${found}" length)
  math(EXPR at "${at} + ${length}")
  string(SUBSTRING "${rest}" ${at} -1 rest)
  add_piece("${before}")
  if(style)
    file(READ ${PAGE}/${style} content)
    add_piece("<style>\n${content}</style>")
  elseif(script)
    file(READ ${PAGE}/${script} content)
    add_piece("<script>\n${content}</script>")
  else()
    add_piece("${found}")
  endif()
endwhile()
add_piece("${rest}")
file(WRITE ${OUTPUT} "// Made of ${PAGE} by cmake/embed_page.cmake.
#include \"hw_model/view/page_text.h\"

namespace pyrasim::hw {
namespace {

constexpr std::string_view pieces[]{
${pieces}};

}  // namespace

const std::span<const std::string_view> page_text{pieces};

}  // namespace pyrasim::hw
")
