#include "host/trace/toml_records.hpp"

#include <toml++/toml.h>

#include "host/bus/candump.hpp"

namespace canproof::host {

void read_toml_records(const std::filesystem::path& file, const std::function<void(TomlItem&)>& read) {
    Faults faults;
    try {
        const toml::table table = toml::parse_file(file.string());
        TomlItem whole{table, file.string(), faults};
        read(whole);
        whole.finish();
    } catch (const toml::parse_error& error) {
        faults.emplace_back(Place{file.string(), static_cast<unsigned>(error.source().begin.line)},
                            std::string{error.description()}, "mend the TOML");
    }
    if (!faults.empty()) {
        throw InputError{faults.front().text()};
    }
}

}  // namespace canproof::host
