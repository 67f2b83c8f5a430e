#include "host/replay/stimulus.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>

#include "host/bus/candump.hpp"

namespace canproof::host {

namespace {

double parse_value(const std::string& text, const std::string& where) {
    char* end = nullptr;
    const double value = std::strtod(text.c_str(), &end);
    if (text.empty() || *end != '\0' || !std::isfinite(value)) {
        throw InputError{fmt::format("{}: value `{}` is no number; write seconds,signal,value", where, text)};
    }
    return value;
}

}  // namespace

std::vector<Stimulus> read_stimuli(std::istream& in, const std::string& name) {
    std::vector<Stimulus> all;
    std::string line;
    for (int number = 1; std::getline(in, line); ++number) {
        if (!line.empty() && line.back() == '\r') {
            line.pop_back();
        }
        if (line.empty() || (number == 1 && line == "seconds,signal,value")) {
            continue;
        }
        const std::string where = fmt::format("{}:{}", name, number);
        const auto first = line.find(',');
        const auto second = first == std::string::npos ? first : line.find(',', first + 1);
        if (second == std::string::npos) {
            throw InputError{fmt::format("{}: `{}` has no three fields; write seconds,signal,value", where, line)};
        }
        Stimulus one;
        one.time = parse_seconds(line.substr(0, first), where);
        one.signal = line.substr(first + 1, second - first - 1);
        one.value = parse_value(line.substr(second + 1), where);
        if (!all.empty() && one.time < all.back().time) {
            throw InputError{fmt::format("{}: time goes backwards; sort the stimuli by time", where)};
        }
        all.push_back(one);
    }
    return all;
}

}  // namespace canproof::host
