// SPDX-License-Identifier: Apache-2.0
// Saves and restores parameters in a memory with any content, with power cuts at any byte. After each start a slave has
// the values that a naive reader finds in the memory, never a value of an invalid bank. After a power cut these are the
// old set or the new set, unless the input itself has changed bytes of a bank. Every input runs with a small slave, and
// some inputs also with the whole conformance slave (Samples::whole_one_in). Input: records of ten bytes: the event,
// its argument, and eight bytes of data.
#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "firmware/canopen/lss_store.hpp"
#include "fuzz/support/claims.hpp"
#include "fuzz/support/frame_probe.hpp"
#include "fuzz/support/journal_memory.hpp"
#include "fuzz/support/read_sample.hpp"
#include "fuzz/support/record_mutator.hpp"
#include "fuzz/support/require.hpp"
#include "fuzz/support/require_consistent.hpp"
#include "fuzz/support/small_slave.hpp"
#include "fuzz/support/stored_image.hpp"
#include "fuzz/support/tampering.hpp"
#include "generated/canopen/requirements.hpp"
#include "host/sim/devices/generic_device.hpp"
#include "properties/support/naive_store.hpp"
#include "properties/support/same_bytes.hpp"
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
    explicit World(const host::Part& part) : description_{host::describe(part)} {}

    /// Runs an input. The slave is on at its end.
    void run(const std::uint8_t* data, std::size_t size) {
        restart();
        const std::size_t count = std::min(size / record_size, most_records);
        for (std::size_t i = 0; i < count; ++i) {
            happen(data + i * record_size);
        }
        switch_on();
    }

  private:
    /// Begins an input: a new device, which is off, and an erased memory (all bytes FFh).
    void restart() {
        device_.emplace(description_, memory_, queue_);
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

    /// Switches the device on if it is off, and checks what it has loaded.
    void switch_on() {
        if (!is_on_) {
            power_on();
        }
    }

    /// Changes the memory while the device is off. The next event that needs the device switches it on.
    template <typename Edit>
    void edit(const Edit& change) {
        edited_ = memory_.image();
        change(edited_);
        tampering_.note_edit(memory_.image(), edited_);
        memory_.replace(edited_);
        is_known_ = false;
        is_on_ = false;
    }
    void damage(std::size_t at, std::size_t count, const std::uint8_t* bytes) {
        edit([&](fuzz::Image& image) {
            for (std::size_t i = 0; i < count && i < 6; ++i) {
                image[(at + i) % memory_size] = bytes[i];
            }
        });
    }

    /// Returns what a naive reader finds in the memory. Reads the memory only after a change.
    const naive_store::Content& content() {
        if (!is_known_) {
            format_.read(memory_.image(), node_id, content_);
            is_known_ = true;
        }
        return content_;
    }

    void power_on() {
        queue_ = TransmitQueue{};
        device_->power_on(node_id, Instant{});
        is_on_ = true;
        fuzz::require_consistent(*device_);
        const naive_store::Content& held = content();
        require(device_->node().has_error(ErrorId::stored_set_checksum) == held.is_corrupt, "a corrupt set is told");
        expected_.bytes = defaults_;
        format_.take(held.values.groups, held.values.bytes, expected_);
        require_values();
        drain();
    }
    /// Requires that the device has the expected values. At a start, the slave sets 1020h (verify configuration) to 0
    /// if the configuration that 1020h describes was not saved with it, so 1020h is left out.
    void require_values() {
        image_.copy(device_->objects().image().view(), present_);
        const auto verified = present_.begin() + static_cast<std::ptrdiff_t>(verify_.first);
        std::copy_n(verified, verify_.second, expected_.bytes.data() + verify_.first);
        if (!same_bytes(present_, expected_.bytes)) {
            for (const naive_store::Stored& one : format_.entries()) {
                const auto begin = present_.begin() + static_cast<std::ptrdiff_t>(one.at);
                require(
                    std::equal(begin, begin + static_cast<std::ptrdiff_t>(one.size), expected_.bytes.data() + one.at),
                    "value", one.address.first);
            }
        }
    }
    /// Returns the default of each entry.
    static naive_store::Bytes defaults_of(const naive_store::Format& format,
                                          const host::GenericDescription& description) {
        fuzz::JournalMemory blank{fuzz::Image(memory_size, 0xFF)};
        TransmitQueue queue;
        host::GenericDevice device{description, blank, queue};
        device.power_on(node_id, Instant{});
        naive_store::Bytes all(format.payload_size());
        fuzz::StoredImage{format, device.objects().tables()}.copy(device.objects().image().view(), all);
        return all;
    }
    /// Returns the place of 1020h (verify configuration) among the stored values, and its size.
    static std::pair<std::size_t, std::size_t> verify_of(const naive_store::Format& format) {
        std::pair<std::size_t, std::size_t> place{0, 0};
        for (const naive_store::Stored& one : format.entries()) {
            if (one.address.first == 0x1020) {
                place.first = place.second == 0 ? one.at : place.first;
                place.second += one.size;
            }
        }
        return place;
    }

    /// Sends a request. Returns the abort code of an abort, or the first byte of any other answer; 0 without an answer.
    std::uint32_t ask(const Frame& request) {
        fuzz::deliver(*device_, request, Instant{});
        fuzz::require_consistent(*device_);
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
            switch_on();
            ask(download(static_cast<std::uint16_t>(one.address.first), static_cast<std::uint8_t>(one.address.second),
                         bytes, one.size));
        }
    }

    /// Saves or restores parameter groups, with a power cut at `place`. A save stores the present values of its groups
    /// and keeps the stored values of the other groups. A restore also keeps the other groups (CiA 301, 7.5.2.13).
    void execute(std::uint16_t index, unsigned sub, const char* signature, std::uint16_t place) {
        switch_on();
        before_ = content();
        expected_ = before_.values;
        if (index == 0x1010) {
            image_.copy(device_->objects().image().view(), present_);
            format_.take(naive_store::groups_of(sub), present_, expected_);
        } else {
            format_.clear(naive_store::groups_of(sub), expected_);
        }
        edited_ = memory_.image();
        memory_.open_journal();
        std::array<std::uint8_t, 4> word{};
        std::copy_n(signature, word.size(), word.begin());
        const std::uint32_t answer = ask(download(index, static_cast<std::uint8_t>(sub), word.data(), word.size()));
        is_known_ = false;
        if (answer == 0) {
            return;  // SDO is not served in this state
        }
        require(answer == 0x60, "saved", answer);
        require(content().values == expected_, "what is saved");
        if (place == uncut) {
            return tampering_.note_write(edited_, memory_.image());
        }
        const std::size_t written = memory_.written();
        memory_.cut_after(place % (written + 1));
        is_known_ = false;
        const naive_store::Values& found = content().values;
        require(found == expected_ || found == before_.values || is_foreign(banks_), "old or new");
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
        edited_ = memory_.image();
        memory_.open_journal();
        is_known_ = false;
        require(store.store(given) == LssError::none, "stored");
        require(is(store.load(shipped), wanted), "what is stored");
        if (place == uncut) {
            return tampering_.note_write(edited_, memory_.image());
        }
        memory_.cut_after(place % (memory_.written() + 1));
        const LssConfiguration found = store.load(shipped);
        require(is(found, wanted) || is(found, before) || is_foreign(slots_), "old or new configuration");
    }
    static bool is(const LssConfiguration& a, const LssConfiguration& b) {
        return a.node_id == b.node_id && a.bit_rate == b.bit_rate;
    }

    static naive_store::Format format_of(const host::GenericDescription& description) {
        naive_store::Format format{description.rows.tables()};
        require(2 * format.bank_size() + LssStore::size <= memory_size, "the memory is large enough");
        return format;
    }

    const host::GenericDescription description_;
    const naive_store::Format format_{format_of(description_)};
    const fuzz::StoredImage image_{format_, description_.rows.tables()};
    const naive_store::Bytes defaults_{defaults_of(format_, description_)};
    const std::pair<std::size_t, std::size_t> verify_{verify_of(format_)};  ///< place and size of 1020h
    fuzz::JournalMemory memory_{fuzz::Image(memory_size, 0xFF)};
    TransmitQueue queue_;
    std::optional<host::GenericDevice> device_;
    bool is_on_{false};     ///< whether the device has loaded the present content of the memory
    bool is_known_{false};  ///< whether `content_` is the present content of the memory
    naive_store::Content content_{format_.nothing()};
    naive_store::Content before_{format_.nothing()};
    naive_store::Values expected_{content_.values};
    naive_store::Bytes present_{content_.values.bytes};  ///< the present values of the device
    fuzz::Image edited_;                                 ///< a second image of the memory
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

/// Lets the environment variable CANPROOF_WHOLE_ONE_IN say how many inputs also run with the whole slave.
extern "C" int LLVMFuzzerInitialize(int*, char***) {
    fuzz::read_sample("CANPROOF_WHOLE_ONE_IN", fuzz::samples.whole_one_in);
    return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static World small{fuzz::small_slave()};
    static World whole{test::slave_part()};
    fuzz::Digest hash;
    hash.add(ByteView{data, size});
    fuzz::begin_checks(hash.value());
    small.run(data, size);
    if (fuzz::samples.is_whole(hash.value())) {
        whole.run(data, size);
    }
    return 0;
}
