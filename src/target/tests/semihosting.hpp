// SPDX-License-Identifier: Apache-2.0
// The functions that an image in QEMU needs from the host.
#pragma once

#include <string>
#include <vector>

namespace canproof::target {

/// Opens the console and returns the words of the command line, the image's own name first.
std::vector<std::string> begin_image();

/// Removes `--name=value` from `words` and returns the value; empty when it is absent.
std::string take_option(std::vector<std::string>& words, const std::string& name);

}  // namespace canproof::target
