// SPDX-License-Identifier: Apache-2.0
// Treats C++ sources as text: comments, literals, words, and blocks in braces.
#pragma once

#include <cstddef>
#include <string>

namespace canproof::host {

/// Returns whether `c` can be part of a name or a number.
bool is_word(char c);

/// Returns the source with spaces in place of comments and literals. All other characters keep their line and column.
std::string code_only(const std::string& source);

/// Returns the source without comments, and without spaces outside literals except one space between two words.
std::string without_layout(const std::string& source);

/// Returns the position after the closing brace of the first block in braces at or after `at`. Returns the end of the
/// text when there is no such block. Braces in literals do not count. `text` must have no comments.
std::size_t block_end(const std::string& text, std::size_t at);

}  // namespace canproof::host
