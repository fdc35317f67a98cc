#pragma once
// What a file was made from, as a short text that the file carries.

#include <string>
#include <string_view>

namespace morphkit::media {

/// 16 hexadecimal digits. The same on every machine; made to tell versions apart, not to withstand forgery.
std::string digest_of(std::string_view bytes);

/// What a file says in its "Software" or comment: "morphkit, from 0123456789abcdef".
std::string made_from_mark(std::string_view made_from);

}  // namespace morphkit::media
