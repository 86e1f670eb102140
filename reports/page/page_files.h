// The texts of page.css, page.js and view_3d.js, which are compiled into the program.
#pragma once

namespace isobench {

extern const char* const page_style;
extern const char* const page_script;
extern const char* const view_3d_script;

}  // namespace isobench
