// SPDX-License-Identifier: Apache-2.0
// Saves and restores parameters in a memory with any content, with power cuts at any byte. After each start the
// conformance slave has the values that a naive reader finds in the memory, never a value of an invalid bank. After a
// power cut these are the old set or the new set, unless the input itself has changed bytes of a bank. Input: records
// of ten bytes: the event, its argument, and eight bytes of data.
#include <algorithm>

#include "firmware/canopen/lss_store.hpp"
#include "fuzz/support/claims.hpp"
#include "fuzz/support/frame_probe.hpp"
#include "fuzz/support/journal_memory.hpp"
#include "fuzz/support/record_mutator.hpp"
#include "fuzz/support/require.hpp"
#include "fuzz/support/require_consistent.hpp"
#include "fuzz/support/tampering.hpp"
#include "generated/canopen/requirements.hpp"
#include "host/sim/devices/generic_device.hpp"
#include "properties/support/naive_store.hpp"
#include "tests/support/slave_register.hpp"

namespace {

using namespace canproof;
using fuzz::require;
using naive_store::Values;

constexpr std::size_t record_size = 10;
constexpr std::size_t most_records = 60;
constexpr std::size_t memory_size = 2048;
constexpr std::uint16_t uncut = 0xFFFF;
constexpr std::uint8_t node_id = 5;

class World {
  public:
    /// Erases the memory (all bytes FFh) while the device is off.
    void restart() {
        edit([](fuzz::Image& image) { image.assign(memory_size, 0xFF); });
    }

    void happen(const std::uint8_t* record) {
        const unsigned how = record[1];
        const std::uint8_t* const data = record + 2;
        const std::uint16_t place = read_u16(ByteView{data, 2}, 0);
        switch (record[0] % 9U) {
            case 0:
                return damage(place, how % 7U, data + 2);
            case 1:
                return edit([&](fuzz::Image& image) {
                    format_.make_sound(image, how % 2U, read_u32(ByteView{data, 4}, 0));
                });
            case 2:
                return power_on();
            case 3:
            case 4:
                return write_entry(place, data + 2);
            case 5:
                return execute(0x1010, 1 + how % 4U, "save", place);
            case 6:
                return execute(0x1011, 1 + how % 4U, "load", place);
            case 7:
                return edit([&](fuzz::Image& image) {
                    std::fill(image.begin() + place % memory_size, image.end(), how % 2U == 0 ? data[2] : 0xFF);
                });
            default:
                return store_lss({data[2], read_u32(ByteView{data + 3, 4}, 0)}, place);
        }
    }

  private:
    /// Changes the memory while the device is off.
    template <typename Edit>
    void edit(const Edit& change) {
        fuzz::Image image = memory_.image();
        change(image);
        tampering_.note_edit(memory_.image(), image);
        memory_.replace(image);
        power_on();
    }
    void damage(std::size_t at, std::size_t count, const std::uint8_t* bytes) {
        edit([&](fuzz::Image& image) {
            for (std::size_t i = 0; i < count && i < 6; ++i) {
                image[(at + i) % memory_size] = bytes[i];
            }
        });
    }

    void power_on() {
        queue_ = TransmitQueue{};
        device_.power_on(node_id, Instant{});
        fuzz::require_consistent(device_);
        const bool corrupt = format_.is_corrupt(memory_.image());
        require(device_.node().has_error(ErrorId::stored_set_checksum) == corrupt, "a corrupt set is told");
        const Values saved = format_.read(memory_.image(), node_id);
        for (std::size_t i = 0; i < entries_.size(); ++i) {
            const naive_store::Stored& one = format_.entries()[i];
            const auto found = saved.find(one.address);
            // At a start, the slave sets 1020h (verify configuration) to 0 if the configuration that 1020h describes
            // was not saved with it.
            require(one.address.first == 0x1020 ||
                        has_value(entries_[i], found == saved.end() ? defaults_[i] : found->second),
                    "value", one.address.first);
        }
        drain();
    }
    /// Returns whether an entry has this value, to which zeros are added after the end of a string.
    bool has_value(const EntryRef& entry, const naive_store::Bytes& expected) const {
        const ByteView bytes = device_.objects().value(entry);
        const auto end = expected.begin() + static_cast<std::ptrdiff_t>(bytes.size());
        return bytes.size() <= expected.size() && std::equal(expected.begin(), end, bytes.data()) &&
               std::all_of(end, expected.end(), [](std::uint8_t byte) { return byte == 0; });
    }
    static EntryRef entry_of(const host::GenericDevice& device, const naive_store::Stored& one) {
        return device.objects()
            .find(static_cast<std::uint16_t>(one.address.first), static_cast<std::uint8_t>(one.address.second))
            .value();
    }
    static naive_store::Bytes value(const host::GenericDevice& device, const naive_store::Stored& one) {
        const ByteView bytes = device.objects().value(entry_of(device, one));
        naive_store::Bytes all(bytes.data(), bytes.data() + bytes.size());
        all.resize(one.size);  // a string is padded with zeros
        return all;
    }
    /// Returns the default of each entry.
    static std::vector<naive_store::Bytes> defaults_of(const naive_store::Format& format) {
        fuzz::JournalMemory blank{fuzz::Image(memory_size, 0xFF)};
        TransmitQueue queue;
        host::GenericDevice device{test::slave_part(), blank, queue};
        device.power_on(node_id, Instant{});
        std::vector<naive_store::Bytes> all;
        for (const naive_store::Stored& one : format.entries()) {
            all.push_back(value(device, one));
        }
        return all;
    }
    static std::vector<EntryRef> entries_of(const naive_store::Format& format, const host::GenericDevice& device) {
        std::vector<EntryRef> all;
        for (const naive_store::Stored& one : format.entries()) {
            all.push_back(entry_of(device, one));
        }
        return all;
    }

    /// Sends a request. Returns the abort code of an abort, or the first byte of any other answer; 0 without an answer.
    std::uint32_t ask(const Frame& request) {
        fuzz::deliver(device_, request, Instant{});
        fuzz::require_consistent(device_);
        std::uint32_t answer = 0;
        while (!queue_.empty()) {
            const Frame frame = queue_.pop();
            if (frame.id == 0x585) {
                require(answer == 0 && frame.length == 8, "one answer");
                answer = frame.data[0] == 0x80 ? read_u32(frame.payload(), 4) : frame.data[0];
            }
        }
        return answer;
    }
    void drain() {
        while (!queue_.empty()) {
            queue_.pop();
        }
    }
    static Frame download(std::uint16_t index, std::uint8_t sub, const std::uint8_t* bytes, std::size_t size) {
        Frame frame = data_frame(0x605, 8);
        frame.data[0] = static_cast<std::uint8_t>(0x23U | ((4U - size) << 2U));
        write_le(MutableBytes{frame.data}, 1, 2, index);
        frame.data[3] = sub;
        std::copy_n(bytes, size, frame.data.begin() + 4);
        return frame;
    }
    void write_entry(std::size_t chosen, const std::uint8_t* bytes) {
        const naive_store::Stored& one = format_.entries()[chosen % format_.entries().size()];
        if (one.size <= 4) {
            ask(download(static_cast<std::uint16_t>(one.address.first), static_cast<std::uint8_t>(one.address.second),
                         bytes, one.size));
        }
    }

    /// Saves or restores parameter groups, with a power cut at `place`. A save stores the present values of its groups
    /// and keeps the stored values of the other groups. A restore also keeps the other groups (CiA 301, 7.5.2.13).
    void execute(std::uint16_t index, unsigned sub, const char* signature, std::uint16_t place) {
        const fuzz::Image before = memory_.image();
        Values expected = format_.read(before, node_id);
        for (const naive_store::Stored& one : format_.entries()) {
            if (((naive_store::groups_of(sub) >> one.group) & 1U) == 0) {
                continue;
            }
            if (index == 0x1010) {
                expected[one.address] = value(device_, one);
            } else {
                expected.erase(one.address);
            }
        }
        memory_.open_journal();
        std::array<std::uint8_t, 4> word{};
        std::copy_n(signature, word.size(), word.begin());
        const std::uint32_t answer = ask(download(index, static_cast<std::uint8_t>(sub), word.data(), word.size()));
        if (answer == 0) {
            return;  // SDO is not served in this state
        }
        require(answer == 0x60, "saved", answer);
        require(format_.read(memory_.image(), node_id) == expected, "what is saved");
        if (place == uncut) {
            return tampering_.note_write(before, memory_.image());
        }
        const std::size_t written = memory_.written();
        memory_.cut_after(place % (written + 1));
        const Values found = format_.read(memory_.image(), node_id);
        require(found == expected || found == format_.read(before, node_id) || is_foreign(banks_), "old or new");
        power_on();
    }

    bool is_foreign(const std::array<std::size_t, 2>& pair) const {
        return tampering_.is_foreign(pair[0]) || tampering_.is_foreign(pair[1]);
    }

    /// Stores node-ID and bit rate by LSS, which has its own store at the end of the memory. A node-ID other than 1 to
    /// 127 and 255 counts as not stored.
    void store_lss(const LssConfiguration& given, std::uint16_t place) {
        constexpr LssConfiguration shipped{127, 125000};
        const bool counts = given.node_id == 255 || (given.node_id >= 1 && given.node_id <= 127);
        const LssConfiguration& wanted = counts ? given : shipped;
        LssStore store{memory_};
        const LssConfiguration before = store.load(shipped);
        const fuzz::Image image = memory_.image();
        memory_.open_journal();
        require(store.store(given) == LssError::none, "stored");
        require(is(store.load(shipped), wanted), "what is stored");
        if (place == uncut) {
            return tampering_.note_write(image, memory_.image());
        }
        memory_.cut_after(place % (memory_.written() + 1));
        const LssConfiguration found = store.load(shipped);
        require(is(found, wanted) || is(found, before) || is_foreign(slots_), "old or new configuration");
    }
    static bool is(const LssConfiguration& a, const LssConfiguration& b) {
        return a.node_id == b.node_id && a.bit_rate == b.bit_rate;
    }

    static const naive_store::Format& format() {
        static const naive_store::Format one = [] {
            fuzz::JournalMemory memory{fuzz::Image(memory_size, 0xFF)};
            TransmitQueue queue;
            const host::GenericDevice device{test::slave_part(), memory, queue};
            return naive_store::Format{device.objects().tables()};
        }();
        require(2 * one.bank_size() + LssStore::size <= memory_size, "the memory is large enough");
        return one;
    }

    const naive_store::Format& format_{format()};
    const std::vector<naive_store::Bytes> defaults_{defaults_of(format_)};
    fuzz::JournalMemory memory_{fuzz::Image(memory_size, 0xFF)};
    TransmitQueue queue_;
    host::GenericDevice device_{test::slave_part(), memory_,
                                queue_};  ///< device for all inputs, because making a device takes long
    const std::vector<EntryRef> entries_{entries_of(format_, device_)};  ///< in the order of format_.entries()
    fuzz::Tampering tampering_;
    const std::array<std::size_t, 2> banks_{tampering_.add_part(0, format_.bank_size()),
                                            tampering_.add_part(format_.bank_size(), format_.bank_size())};
    const std::array<std::size_t, 2> slots_{
        tampering_.add_part(memory_size - LssStore::size, LssStore::slot_size),
        tampering_.add_part(memory_size - LssStore::slot_size, LssStore::slot_size)};
};

}  // namespace

CANPROOF_FUZZ_RECORDS(record_size)
CANPROOF_FUZZ_CLAIMS(req::CO_STORE_001, req::CO_STORE_002, req::CO_STORE_003, req::CO_STORE_004, req::CO_STORE_005,
                     req::CO_STORE_013)

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static World world;
    fuzz::begin_checks(data, size);
    world.restart();
    const std::size_t count = std::min(size / record_size, most_records);
    for (std::size_t i = 0; i < count; ++i) {
        world.happen(data + i * record_size);
    }
    return 0;
}
