#include "host/assess/evidence/argument.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "host/register/toml_records.hpp"

namespace canproof::host {

namespace {

void read_claims(TomlItem& whole, Argument& argument) {
    for (auto& item : whole.items("claim")) {
        const Claim claim{item.text("id"), item.text_or("parent", ""), item.text("text"), item.texts("evidence", false),
                          item.text_or("limits", "")};
        const auto known = [&claim](const Claim& other) { return other.id == claim.parent; };
        if (!claim.parent.empty() && std::none_of(argument.claims.begin(), argument.claims.end(), known)) {
            item.fault(item.place("parent"), fmt::format("there is no claim `{}` before this one", claim.parent),
                       "name one that stands above");
        }
        argument.claims.push_back(claim);
        item.finish();
    }
}

void read_tables(TomlItem& whole, Argument& argument) {
    for (auto& item : whole.items("evidence")) {
        argument.evidence.push_back({item.text("key"), item.text("title"), item.text("made_by")});
        item.finish();
    }
    for (auto& item : whole.items("technique")) {
        argument.techniques.push_back({item.text("table"), item.text("name"), item.text("level"),
                                       item.word("state", {"shown", "partly", "not"}, ""), item.text("how")});
        item.finish();
    }
    for (auto& item : whole.items("tool")) {
        argument.tools.push_back(
            {item.text("name"), item.text_or("package", ""), item.text("hides"), item.text("noticed")});
        item.finish();
    }
}

}  // namespace

Argument read_argument(const std::filesystem::path& file) {
    Argument argument;
    read_toml_records(file, [&argument](TomlItem& whole) {
        read_claims(whole, argument);
        read_tables(whole, argument);
    });
    return argument;
}

}  // namespace canproof::host
