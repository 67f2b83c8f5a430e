// Lines of a descriptor as they come, without ever waiting for the rest of one.
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
    /// Whole lines that have arrived, empty ones left out; call when there is input. A line too long for any frame is
    /// dropped. The last line may lack its end.
    std::vector<std::string> read_lines();

  private:
    int descriptor_;
    std::string pending_;
    bool open_{true};
};

}  // namespace canproof::host
