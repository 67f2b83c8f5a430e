// Which lines a link of a requirement is about: the function right below it.
#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace canproof::host {

/// The first and the last line of the function below line `link` of a source; both count from 1. {0, 0}: there is none.
/// `lines` are those of code_only().
std::pair<std::size_t, std::size_t> function_below(const std::vector<std::string>& lines, std::size_t link);

}  // namespace canproof::host
