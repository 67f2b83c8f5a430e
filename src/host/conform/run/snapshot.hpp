// SPDX-License-Identifier: Apache-2.0
// The parameters of the slave at the start of a run, and the means to restore them.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "host/conform/link/sdo_client.hpp"
#include "host/conform/sheet/conform_sheet.hpp"

namespace canproof::host::conform {

class Snapshot {
  public:
    /// Longest value in bytes. Longer values are not part of the snapshot.
    static constexpr std::size_t longest_value = 64;

    /// Reads every entry that can be read and written, except commands, DOMAINs and values longer than longest_value.
    /// Returns a sentence for each entry that the slave answers wrongly. Such an entry is not part of the snapshot, nor
    /// is one whose upload the slave aborts.
    std::vector<std::string> take(SdoClient& sdo, const ConformSheet& sheet);
    /// Writes the snapshot's values to the entries of `places` that have changed, in an order that a slave accepts.
    /// Then reads these entries again. Returns a sentence for each entry that could not be restored. Throws NoAnswer
    /// when the slave stops answering.
    std::vector<std::string> put_back(SdoClient& sdo, const std::set<ObjectPlace>& places);
    /// Returns whether the last put_back() wrote at least one entry.
    bool has_written() const { return has_written_; }
    std::size_t size() const { return values_.size(); }
    std::set<ObjectPlace> places() const;
    /// Returns the value of an entry; nullptr when the entry is not part of the snapshot.
    const Bytes* find(const ObjectPlace& place) const;

  private:
    using Places = std::set<ObjectPlace>;

    Places changed(SdoClient& sdo, const Places& places) const;
    void write(SdoClient& sdo, const ObjectPlace& place);
    void write(SdoClient& sdo, const ObjectPlace& place, std::int64_t number);
    void put_back_pdo(SdoClient& sdo, std::uint16_t communication, Places& open);
    void put_back_sync(SdoClient& sdo, Places& open);
    void put_back_others(SdoClient& sdo, const Places& open);

    std::map<ObjectPlace, Bytes> values_;
    bool has_written_{false};
};

}  // namespace canproof::host::conform
