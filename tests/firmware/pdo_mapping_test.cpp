// A mapping object of the conformance slave, resolved (firmware/canopen/pdo_mapping.hpp).
#include "firmware/canopen/pdo_mapping.hpp"

#include "generated/canopen/requirements.hpp"
#include "tests/support/slave_bench.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

TEST(Mapping, HoldsWhatItNamesAndNothingElse) {
    verifies<req::CO_PDO_015>();
    const host::DictionaryRows rows{slave().rows};
    const DictionaryTables tables{rows.tables()};
    std::vector<std::uint8_t> image(rows.layout.image.size());
    ObjectDictionary objects{tables, MutableBytes{image.data(), image.size()}, LimitAbort::high_low};
    objects.load_defaults(ParameterGroup::communication, 5);
    std::array<PdoLine, 8> places{};
    PdoMapping mapping;
    mapping.resolve(objects, 0x1A00, Slots<PdoLine>{places});  // as shipped: 2001h:1 and 2001h:2, a byte each
    EXPECT_EQ(mapping.length(), 2U);
    EXPECT_TRUE(mapping.maps(0x2001, 1));
    EXPECT_TRUE(mapping.maps(0x2001, 2));
    EXPECT_FALSE(mapping.maps(0x2001, 3));
    EXPECT_FALSE(mapping.maps(0x2101, 1));
    EXPECT_FALSE(mapping.maps(0, 0));
}

}  // namespace canproof::test
