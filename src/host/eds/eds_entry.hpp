// One entry of an EDS: data type, access, default, limits.
#pragma once

#include <optional>
#include <string>

#include "host/eds/ini.hpp"
#include "host/speccompiler/register.hpp"

namespace canproof::host {

/// Where faults and notes of a file go.
struct EdsTelling {
    const std::string& file;
    Faults& faults;
    Faults& notes;

    void fault(unsigned line, std::string what, std::string mend) const {
        faults.emplace_back(Place{file, line}, std::move(what), std::move(mend));
    }
    void note(unsigned line, std::string what, std::string mend) const {
        notes.emplace_back(Place{file, line}, std::move(what), std::move(mend));
    }
};

/// What the keys of `section` say of one entry. `service_words()` of its index are the caller's.
Entry read_eds_entry(const IniSection& section, std::uint8_t subindex, const EdsTelling& tell);

/// Puts a value (DefaultValue, ParameterValue) into an entry whose type is known.
void set_eds_value(Entry& entry, const IniValue& value, const EdsTelling& tell);

}  // namespace canproof::host
