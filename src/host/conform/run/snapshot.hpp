// The parameters of the slave as they were at the start of a run, and how they are put back.
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
    /// Longer values are left alone.
    static constexpr std::size_t longest_value = 64;

    /// Reads every entry that can be read and written, commands and DOMAINs apart. Gives those that the slave answers
    /// wrongly, a sentence each: they are not part of it.
    std::vector<std::string> take(SdoClient& sdo, const ConformSheet& sheet);
    /// Writes back those of `places` that read otherwise, in an order that a slave accepts, and reads them again.
    /// Gives what could not be put back, a sentence each. Throws NoAnswer.
    std::vector<std::string> put_back(SdoClient& sdo, const std::set<ObjectPlace>& places);
    /// Whether the last put_back() had to write.
    bool has_written() const { return has_written_; }
    std::size_t size() const { return values_.size(); }
    std::set<ObjectPlace> places() const;
    /// Nothing when the entry is not part of it.
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
