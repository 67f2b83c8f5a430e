// SPDX-License-Identifier: Apache-2.0
#include "host/sim/bus/bus_faults.hpp"

#include <fmt/format.h>

#include <sstream>

#include "host/base/input_error.hpp"
#include "host/base/number_text.hpp"

namespace canproof::host {

namespace {

[[noreturn]] void refuse(const std::string& word) {
    throw InputError{fmt::format(
        "bus fault `{}` is not understood; write for example corrupted=0.01,lost=0.001,bus-off=0.0001,seed=7 with "
        "rates from 0 to 0.9 and a seed of up to 18 digits",
        word)};
}

double rate_of(const std::string& text, const std::string& word) {
    constexpr double highest = 0.9;  // at a higher rate hardly any frame gets through
    const auto rate = decimal_number(text);
    if (!rate || *rate < 0.0 || *rate > highest) {
        refuse(word);
    }
    return *rate;
}

std::uint64_t seed_of(const std::string& text, const std::string& word) {
    if (text.empty() || text.size() > 18 || text.find_first_not_of("0123456789") != std::string::npos) {
        refuse(word);
    }
    return std::stoull(text);
}

}  // namespace

BusFaultRates parse_bus_faults(const std::string& text) {
    BusFaultRates rates;
    std::istringstream words{text};
    for (std::string word; std::getline(words, word, ',');) {
        const auto equals = word.find('=');
        const std::string name = word.substr(0, equals);
        const std::string value = equals == std::string::npos ? "" : word.substr(equals + 1);
        if (name == "corrupted") {
            rates.corrupted = rate_of(value, word);
        } else if (name == "lost") {
            rates.lost = rate_of(value, word);
        } else if (name == "bus-off") {
            rates.bus_off = rate_of(value, word);
        } else if (name == "seed") {
            rates.seed = seed_of(value, word);
        } else {
            refuse(word);
        }
    }
    return rates;
}

}  // namespace canproof::host
