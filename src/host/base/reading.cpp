#include "host/base/reading.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>

namespace canproof::host {

namespace {

constexpr std::size_t piece_size = 65536;
const std::string byte_order_mark = "\xEF\xBB\xBF";

}  // namespace

std::string read_file(const std::filesystem::path& path, std::size_t most) {
    if (std::filesystem::is_directory(path)) {
        throw InputError{fmt::format("{} is a folder; name a file", path.string())};
    }
    std::ifstream in{path, std::ios::binary};
    if (!in) {
        throw InputError{fmt::format("cannot read {} ({})", path.string(), std::strerror(errno))};
    }
    std::string bytes;
    std::array<char, piece_size> piece{};
    while (in && bytes.size() <= most) {
        in.read(piece.data(), piece.size());
        bytes.append(piece.data(), static_cast<std::size_t>(in.gcount()));
    }
    check_read(in, path.string());
    if (bytes.size() > most) {
        throw InputError{fmt::format("{} has more than {} bytes; name another file", path.string(), most)};
    }
    return bytes;
}

void check_read(const std::istream& in, const std::string& name) {
    if (in.bad()) {
        throw InputError{fmt::format("{} cannot be read to its end", name)};
    }
}

bool LineReader::next() {
    std::array<char, longest_line + 1> buffer{};
    in_.getline(buffer.data(), buffer.size());
    check_read(in_, name_);
    const auto count = static_cast<std::size_t>(in_.gcount());
    if (in_.fail() && count == 0) {
        return false;
    }
    ++number_;
    if (in_.fail()) {
        throw InputError{
            fmt::format("{}: a line has more than {} characters; is this a file of text?", where(), longest_line)};
    }
    // The count takes the line's end in, which the last line may lack.
    line_.assign(buffer.data(), in_.eof() ? count : count - 1);
    if (number_ == 1 && line_.compare(0, byte_order_mark.size(), byte_order_mark) == 0) {
        line_.erase(0, byte_order_mark.size());
    }
    if (!line_.empty() && line_.back() == '\r') {
        line_.pop_back();
    }
    return true;
}

std::string LineReader::where() const {
    return fmt::format("{}:{}", name_, number_);
}

}  // namespace canproof::host
