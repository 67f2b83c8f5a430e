// What an image in QEMU needs of the machine around it.
#pragma once

#include <string>
#include <vector>

namespace canproof::target {

/// Opens the console and gives the words of the command line, the image's own name first.
std::vector<std::string> begin_image();

/// The value of `--name=value` among `words`, taken out of them; empty without it.
std::string take_option(std::vector<std::string>& words, const std::string& name);

}  // namespace canproof::target
