// SPDX-License-Identifier: Apache-2.0
// Faults of slaves whose dictionary differs from the data sheet.
#include <algorithm>

#include "tests/conformance/zoo/distortions.hpp"
#include "tests/conformance/zoo/faults.hpp"

namespace canproof::test::zoo {

namespace {

host::Object& object_in(host::Part& part, std::uint16_t index) {
    return *std::find_if(part.objects.begin(), part.objects.end(),
                         [index](const host::Object& one) { return one.index == index; });
}

host::Entry& entry_in(host::Part& part, std::uint16_t index, std::uint8_t subindex) {
    std::vector<host::Entry>& entries = object_in(part, index).entries;
    return *std::find_if(entries.begin(), entries.end(),
                         [subindex](const host::Entry& one) { return one.subindex == subindex; });
}

Distortion has_entry(std::uint16_t index, std::uint8_t subindex, std::function<void(host::Entry&)> alter) {
    return has_dictionary([=](host::Part& part) { alter(entry_in(part, index, subindex)); });
}

void without_last_word(host::Part& part) {
    object_in(part, 0x2101).entries.pop_back();
}

void without_label(host::Part& part) {
    const auto gone = std::remove_if(part.objects.begin(), part.objects.end(),
                                     [](const host::Object& one) { return one.index == 0x2301; });
    part.objects.erase(gone, part.objects.end());
}

}  // namespace

Faults dictionary_faults() {
    return {
        {"od-default", "od", "has another default than the data sheet (2201h)", "605#4001220000000000",
         "585#4F01220002000000", "585#4F01220008000000",
         has_entry(0x2201, 0, [](host::Entry& entry) { entry.value = std::int64_t{8}; })},
        {"od-entry-missing", "od", "lacks an entry of the data sheet (2101h:04)", "605#4001210400000000",
         "585#4B01210400000000", "585#8001210411000906", has_dictionary(without_last_word)},
        {"od-object-missing", "od", "lacks an object of the data sheet (2301h)", "605#4001230000000000",
         "585#4101230036000000", "585#8001230000000206", has_dictionary(without_label)},
        {"od-type", "od", "has an entry of another size (2207h)", "605#4007220000000000", "585#4307220000000000",
         "585#4B07220000000000", has_entry(0x2207, 0, [](host::Entry& entry) { entry.type = "UNSIGNED16"; })},
        {"od-read-only", "od", "refuses to write an entry that the data sheet lets write (2201h)",
         "605#2F01220002000000", "585#6001220000000000", "585#8001220002000106",
         has_entry(0x2201, 0, [](host::Entry& entry) { entry.access = "ro"; })},
        {"od-writable", "od", "lets an entry be written that the data sheet has as constant (1018h:03)",
         "605#2318100302000100", "585#8018100302000106", "585#6018100300000000",
         has_entry(0x1018, 3, [](host::Entry& entry) { entry.access = "rw"; })},
        {"od-identity", "od", "has another revision than the data sheet", "605#4018100300000000",
         "585#4318100302000100", "585#4318100303000100",
         has_entry(0x1018, 3, [](host::Entry& entry) { entry.value = std::int64_t{0x00010003}; })},
        {"od-string-cut", "od", "cuts the device name", "605#4008100000000000", "585#4108100011000000",
         "585#4108100010000000",
         has_entry(0x1008, 0, [](host::Entry& entry) { entry.value = std::string{"Conformance slav"}; })},
        {"od-highest-subindex", "od", "has a highest sub-index that is too low (1018h:00)", "605#4018100000000000",
         "585#4F18100004000000", "585#4F18100003000000",
         has_entry(0x1018, 0, [](host::Entry& entry) { entry.value = std::int64_t{3}; })},
        {"od-write-lost", "od", "confirms a write and keeps the old value (2201h)",
         "605#2F01220008000000 605#4001220000000000", "585#4F01220008000000", "585#4F01220002000000",
         takes_requests_as([](WrongSlave&, const Frame& frame) {
             const bool writes = is_expedited_download(frame) && index_of(frame) == 0x2201;
             return writes ? with_value(frame, 2) : frame;
         })},
    };
}

}  // namespace canproof::test::zoo
