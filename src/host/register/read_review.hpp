// Reviews as reviews.toml holds them.
#pragma once

#include <map>
#include <string>

#include "host/register/register.hpp"
#include "host/register/toml_item.hpp"

namespace canproof::host {

/// Adds one [[review]]: who read which items when, by id.
void read_review(TomlItem& item, std::map<std::string, Review>& reviews);

}  // namespace canproof::host
