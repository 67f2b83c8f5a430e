// SPDX-License-Identifier: Apache-2.0
// Reads lines from a descriptor. Does not wait for the rest of an incomplete line.
#pragma once

#include <string>
#include <vector>

namespace canproof::host {

class LineInput {
  public:
    static constexpr std::size_t longest_line = 4096;

    explicit LineInput(int descriptor) : descriptor_{descriptor} {}

    int descriptor() const { return descriptor_; }
    bool is_open() const { return open_; }
    /// Returns the complete lines that have arrived, without empty lines. Must be called when the descriptor is ready.
    /// Drops the beginning of a line when it has more than `longest_line` bytes and no line break has arrived. The last
    /// line may lack a line break.
    std::vector<std::string> read_lines();

  private:
    int descriptor_;
    std::string pending_;
    bool open_{true};
};

}  // namespace canproof::host
