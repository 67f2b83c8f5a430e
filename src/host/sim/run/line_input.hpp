// SPDX-License-Identifier: Apache-2.0
// Reads lines of a descriptor without waiting for incomplete ones.
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
    /// Returns the complete lines that have arrived, without empty ones; call it when there is input. A line that is
    /// too long for any frame is dropped. The last line may lack a line break.
    std::vector<std::string> read_lines();

  private:
    int descriptor_;
    std::string pending_;
    bool open_{true};
};

}  // namespace canproof::host
