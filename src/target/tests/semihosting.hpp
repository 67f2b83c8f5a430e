// SPDX-License-Identifier: Apache-2.0
// Functions that give an image in QEMU its console and its command line.
#pragma once

#include <string>
#include <vector>

namespace canproof::target {

/// Opens the console and returns the words of the command line, the image's own name first.
std::vector<std::string> begin_image();

/// Removes `--name=value` from `words` and returns the value; empty when it is absent.
std::string take_option(std::vector<std::string>& words, const std::string& name);

}  // namespace canproof::target
