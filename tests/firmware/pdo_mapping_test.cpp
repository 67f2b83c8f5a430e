// SPDX-License-Identifier: Apache-2.0
// Tests how the mapping of a PDO is resolved to the places of the mapped values in memory
// (firmware/canopen/pdo_mapping.hpp).
#include "firmware/canopen/pdo_mapping.hpp"

#include "generated/canopen/requirements.hpp"
#include "tests/support/slave_bench.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

/// Records for which objects a mapping reports a change to the TPDOs. They wait for changes if `waits`.
class Reports final : public ObjectAccess {
  public:
    explicit Reports(bool waits) : waits_{waits} {}

    Result<ByteView, AbortCode> read(std::uint16_t /*index*/, std::uint8_t /*subindex*/) override {
        return Result<ByteView, AbortCode>::failure(AbortCode::object_missing);
    }
    AbortCode write(std::uint16_t /*index*/, std::uint8_t /*sub*/, ByteView /*value*/, Instant /*now*/) override {
        return AbortCode::object_missing;
    }
    Result<WritePlace, AbortCode> writable(std::uint16_t /*index*/, std::uint8_t /*subindex*/) override {
        return Result<WritePlace, AbortCode>::failure(AbortCode::object_missing);
    }
    AbortCode before_received(const EntryRef& /*entry*/, std::uint64_t /*bits*/) override { return AbortCode::none; }
    void after_put(const EntryRef& entry, bool changes, Instant /*now*/) override {
        EXPECT_TRUE(changes);
        objects.push_back(entry.index);
    }
    bool is_watched(std::uint64_t marks) const override {
        asked = marks;
        return waits_;
    }

    std::vector<std::uint16_t> objects;
    mutable std::uint64_t asked{0};

  private:
    bool waits_;
};

using Words = std::array<std::uint32_t, 4>;

/// Four objects of two bytes each in the RAM image: 2000h to 2002h one after the other, and 2003h 16 bytes behind
/// 2000h, at the end. Two objects in flash: 2010h and 2011h. 1A00h can map four entries.
class SmallDictionary {
  public:
    SmallDictionary() {
        slots_.fill(no_object);
        for (std::size_t at = 0; at < objects_.size(); ++at) {
            std::size_t slot = object_slot(objects_[at].index, tables_.slot_factor, slots_.size());
            while (slots_[slot] != no_object) {
                slot = (slot + 1) % slots_.size();
            }
            slots_[slot] = static_cast<std::uint16_t>(at);
        }
    }

    /// Returns the data of a PDO that maps the 16 bits of each object in `mapped`.
    std::uint64_t carried(const std::vector<std::uint16_t>& mapped) { return resolve(mapped).values(objects_view_); }
    /// Returns the values of 2000h to 2003h after the reception of `data` in a PDO that maps the 16 bits of each object
    /// in `mapped`.
    Words received(const std::vector<std::uint16_t>& mapped, std::uint64_t data, Reports& reports) {
        resolve(mapped).apply(data_frame(0x205, 8, data), objects_view_, reports, Instant{});
        return {objects_view_.read(0x2000, 0), objects_view_.read(0x2001, 0), objects_view_.read(0x2002, 0),
                objects_view_.read(0x2003, 0)};
    }

  private:
    /// Sets each of the four objects in the image to A000h + index. Returns the mapping of the objects in `mapped`.
    PdoMapping resolve(const std::vector<std::uint16_t>& mapped) {
        objects_view_.write(0x1A00, 0, static_cast<std::uint32_t>(mapped.size()));
        for (std::size_t i = 0; i < mapped.size(); ++i) {
            objects_view_.write(0x1A00, static_cast<std::uint8_t>(i + 1), (std::uint32_t{mapped[i]} << 16U) | 16U);
        }
        for (const std::uint16_t index : std::array<std::uint16_t, 4>{0x2000, 0x2001, 0x2002, 0x2003}) {
            objects_view_.write(index, 0, 0xA000U + index);
        }
        PdoMapping mapping;
        mapping.resolve(objects_view_, 0x1A00, Slots<PdoLine>{places_});
        return mapping;
    }

    static constexpr EntryRow word(std::uint16_t offset, std::uint8_t rights) {
        return {offset, 2, no_limit, 0, DataType::unsigned16, rights, Service::none};
    }
    static constexpr EntryRow line(std::uint8_t subindex) {
        const bool first = subindex == 0;
        return {static_cast<std::uint16_t>(subindex * 4U),
                static_cast<std::uint16_t>(first ? 1U : 4U),
                no_limit,
                subindex,
                first ? DataType::unsigned8 : DataType::unsigned32,
                rights::read | rights::write,
                Service::none};
    }
    static constexpr std::uint8_t in_image = rights::read | rights::write | rights::tpdo;
    static constexpr std::uint8_t in_flash = rights::read | rights::constant | rights::tpdo;

    std::array<ObjectRow, 7> objects_{{{0x1A00, 0, 5, ObjectKind::record},
                                       {0x2000, 5, 1, ObjectKind::var},
                                       {0x2001, 6, 1, ObjectKind::var},
                                       {0x2002, 7, 1, ObjectKind::var},
                                       {0x2003, 8, 1, ObjectKind::var},
                                       {0x2010, 9, 1, ObjectKind::var},
                                       {0x2011, 10, 1, ObjectKind::var}}};
    std::array<EntryRow, 11> entries_{{line(0), line(1), line(2), line(3), line(4), word(20, in_image),
                                       word(22, in_image), word(24, in_image), word(36, in_image), word(0, in_flash),
                                       word(2, in_flash)}};
    std::array<std::uint8_t, 4> constants_{0x10, 0xF0, 0x11, 0xF0};
    std::array<std::uint8_t, 38> image_{};
    std::array<std::uint16_t, 16> slots_{};
    std::array<PdoLine, 4> places_{};
    DictionaryTables tables_{
        table_view(objects_), table_view(entries_), {}, {}, table_view(constants_), table_view(image_), 0,
        table_view(slots_),   0x9E3779B1U};
    ObjectDictionary objects_view_{tables_, MutableBytes{image_}, LimitAbort::high_low};
};

}  // namespace

// Each object in the RAM image has the value A000h + index; 2010h and 2011h in flash have F010h and F011h. From the
// start of 2000h, 2001h or 2002h, the image has at least eight more bytes; from the start of 2003h, it has two.
TEST(Mapping, PdoCarriesAdjacentAndScatteredValues) {
    verifies<req::CO_PDO_028>();
    SmallDictionary small;
    EXPECT_EQ(small.carried({0x2000, 0x2001, 0x2002}), 0xC002'C001'C000U);
    EXPECT_EQ(small.carried({0x2001, 0x2002}), 0xC002'C001U);
    EXPECT_EQ(small.carried({0x2000, 0x2002}), 0xC002'C000U);
    EXPECT_EQ(small.carried({0x2002, 0x2001, 0x2000}), 0xC000'C001'C002U);
    EXPECT_EQ(small.carried({0x2001, 0x2000}), 0xC000'C001U) << "in descending order";
    EXPECT_EQ(small.carried({0x2000, 0x2000}), 0xC000'C000U);
    EXPECT_EQ(small.carried({0x2000, 0x2003}), 0xC003'C000U) << "16 bytes apart";
    EXPECT_EQ(small.carried({0x2003}), 0xC003U) << "the last two bytes of the image";
    EXPECT_EQ(small.carried({0x2000, 0x2010, 0x2011}), 0xF011'F010'C000U);
    EXPECT_EQ(small.carried({0x2010, 0x2011}), 0xF011'F010U);
    EXPECT_EQ(small.carried({0x2010, 0x2000}), 0xC000'F010U);
}

TEST(Mapping, RpdoSetsOnlyTheMappedValues) {
    verifies<req::CO_PDO_001>();
    SmallDictionary small;
    Reports reports{false};
    const std::uint64_t data = 0x4444'3333'2222'1111U;
    EXPECT_EQ(small.received({0x2000, 0x2001, 0x2002}, data, reports), (Words{0x1111, 0x2222, 0x3333, 0xC003}));
    EXPECT_EQ(small.received({0x2000, 0x2001}, data, reports), (Words{0x1111, 0x2222, 0xC002, 0xC003}));
    EXPECT_EQ(small.received({0x2001}, data, reports), (Words{0xC000, 0x1111, 0xC002, 0xC003}));
    EXPECT_EQ(small.received({0x2001, 0x2002}, data, reports), (Words{0xC000, 0x1111, 0x2222, 0xC003}));
    EXPECT_EQ(small.received({0x2001, 0x2000}, data, reports), (Words{0x2222, 0x1111, 0xC002, 0xC003}));
    EXPECT_EQ(small.received({0x2000, 0x2002}, data, reports), (Words{0x1111, 0xC001, 0x2222, 0xC003}));
    EXPECT_EQ(small.received({0x2003}, data, reports), (Words{0xC000, 0xC001, 0xC002, 0x1111}));
}

TEST(Mapping, RpdoReportsExactlyTheChangedValuesToWaitingTpdos) {
    verifies<req::CO_PDO_015>();
    SmallDictionary small;
    using Objects = std::vector<std::uint16_t>;
    const auto reported = [&](const Objects& mapped, std::uint64_t data) {
        Reports reports{true};
        small.received(mapped, data, reports);
        return reports.objects;
    };
    const Objects row{0x2000, 0x2001, 0x2002};
    EXPECT_EQ(reported(row, 0xC002'C001'C000U), Objects{});
    EXPECT_EQ(reported(row, 0xC002'C0F1'C000U), Objects{0x2001});
    EXPECT_EQ(reported(row, 0xF002'C001'C001U), (Objects{0x2000, 0x2002}));
    EXPECT_EQ(reported(row, 0xFFFF'C002'C001'C000U), Objects{}) << "only bits behind the mapped values differ";
    EXPECT_EQ(reported({0x2002, 0x2000}, 0xC000'0002U), Objects{0x2002}) << "in descending order";
}

// The marks of 2000h, 2001h and 2002h are bits (index + index / 16 + sub-index) mod 64: 2200h, 2201h and 2202h mod 64
// are 0, 1 and 2.
TEST(Mapping, RpdoReportsNothingWhileNoTpdoWaitsForItsValues) {
    verifies<req::CO_PDO_015>();
    SmallDictionary small;
    Reports reports{false};
    small.received({0x2000, 0x2001, 0x2002}, 0x3333'2222'1111U, reports);
    EXPECT_EQ(reports.asked, 0b111U);
    EXPECT_TRUE(reports.objects.empty());
}

TEST(Mapping, PdoContainsOnlyTheMappedValues) {
    verifies<req::CO_PDO_015>();
    const host::DictionaryRows rows{slave().rows};
    const DictionaryTables tables{rows.tables()};
    std::vector<std::uint8_t> image(rows.layout.image.size());
    ObjectDictionary objects{tables, MutableBytes{image.data(), image.size()}, LimitAbort::high_low};
    objects.load_defaults(ParameterGroup::communication, 5);
    std::array<PdoLine, 8> places{};
    PdoMapping mapping;
    mapping.resolve(objects, 0x1A00, Slots<PdoLine>{places});  // the default mapping: 2001h:1 and 2001h:2
    EXPECT_EQ(mapping.length(), 2U);
    EXPECT_TRUE(mapping.maps(0x2001, 1));
    EXPECT_TRUE(mapping.maps(0x2001, 2));
    EXPECT_FALSE(mapping.maps(0x2001, 3));
    EXPECT_FALSE(mapping.maps(0x2101, 1));
    EXPECT_FALSE(mapping.maps(0, 0));
}

}  // namespace canproof::test
