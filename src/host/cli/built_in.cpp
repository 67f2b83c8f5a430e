#include "host/cli/built_in.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "host/bus/candump.hpp"
#include "host/embedded_spec.hpp"

namespace canproof::host {

namespace {

/// Part numbers are printed in capitals, names of devices are not.
bool same(const std::string& number, const std::string& name) {
    const auto lower = [](unsigned char c) { return std::tolower(c); };
    return std::equal(number.begin(), number.end(), name.begin(), name.end(), [&](char a, char b) {
        return lower(static_cast<unsigned char>(a)) == lower(static_cast<unsigned char>(b));
    });
}

}  // namespace

const Register& built_in_register() {
    static const LoadResult loaded = load_register(embedded_spec());
    return loaded.content;
}

const Part& device_named(const std::string& name) {
    const Part* part = built_in_register().part(name);
    for (const Part& other : built_in_register().parts) {
        const auto& numbers = other.info.part_numbers;
        if (part == nullptr &&
            std::any_of(numbers.begin(), numbers.end(), [&](const auto& n) { return same(n, name); })) {
            part = &other;
        }
    }
    if (part == nullptr || !part->is_device()) {
        throw InputError{fmt::format("there is no device `{}`; `canproof devices` lists them", name)};
    }
    return *part;
}

}  // namespace canproof::host
