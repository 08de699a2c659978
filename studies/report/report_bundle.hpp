#pragma once

/// @file
/// The page's program, style and licence notices, built from report/ and linked into this program. All are empty
/// in a build that had node, npm or its registry out of reach (report/build); then there is no page.

#include <string_view>

namespace unbruised::studies {

std::string_view report_script();   ///< one JavaScript file without imports
std::string_view report_style();    ///< CSS
std::string_view report_notices();  ///< plain text: licences of the libraries inside the script

}  // namespace unbruised::studies
