// C++ sources as text: comments, literals, words, blocks in braces.
#pragma once

#include <cstddef>
#include <string>

namespace canproof::host {

/// Whether `c` may stand in a name or a number.
bool is_word(char c);

/// A source with its comments and the contents of its literals as spaces; each line keeps its place and length.
std::string code_only(const std::string& source);

/// A source without comments and without spaces outside literals; a space stays between two words.
std::string without_layout(const std::string& source);

/// Where the first block in braces at or after `at` ends, behind its brace; the end of the text when none does.
/// Braces in literals do not count. `text` has no comments.
std::size_t block_end(const std::string& text, std::size_t at);

}  // namespace canproof::host
