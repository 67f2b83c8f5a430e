// SPDX-License-Identifier: Apache-2.0
#include "host/register/read_item.hpp"

namespace canproof::host {

void read_id(TomlItem& item, Item& into) {
    into.id = item.text("id");
    into.id_place = item.place("id");
}

void read_common(TomlItem& item, Item& into, bool text_required) {
    into.place = item.place();
    into.text = text_required ? item.text("text") : item.text_or("text", "");
    const bool derived = item.boolean_or("derived", false);
    if (derived) {
        into.derived = item.text("reason");
    }
    into.sources = item.texts("source", !derived);
    into.source_place = item.place(item.has("source") ? "source" : "derived");
}

}  // namespace canproof::host
