#include "host/cli/built_in.hpp"

#include <fmt/format.h>

#include "host/bus/candump.hpp"
#include "host/embedded_spec.hpp"

namespace canproof::host {

const Register& built_in_register() {
    static const LoadResult loaded = load_register(embedded_spec());
    return loaded.content;
}

const Part& device_named(const std::string& name) {
    const Part* part = built_in_register().part(name);
    if (part == nullptr || !part->is_device()) {
        throw InputError{fmt::format("there is no device `{}`; `canproof devices` lists them", name)};
    }
    return *part;
}

}  // namespace canproof::host
