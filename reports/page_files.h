// page.css and page.js, which lie beside this and are compiled into the program.
#pragma once

namespace isobench {

extern const char* const page_style;
extern const char* const page_script;

}  // namespace isobench
