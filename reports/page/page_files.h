// The texts of page.css, page.js and turning.js, which are compiled into the program.
#pragma once

namespace isobench {

extern const char* const page_style;
extern const char* const page_script;
extern const char* const turning_script;

}  // namespace isobench
