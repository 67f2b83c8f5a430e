// SPDX-License-Identifier: Apache-2.0
// Theorem on writes to the dictionary: a refused write changes no byte of the memory that contains the values.
#include "generated/canopen/requirements.hpp"
#include "properties/proofs/support/any_node.hpp"

namespace canproof::proofs {

void a_refused_write_changes_no_byte() {
    shows(
        "a write of up to eight bytes to any object of the CAN-CBX-AO412 and any sub-index, in any state of a node "
        "without PDOs and with no emergency message waiting, that is refused changes no byte of the image");
    proves<req::CO_SDO_011>();
    AnyNode any_node{};
    const std::uint16_t index = generated::cbx_ao412::object_rows[each(generated::cbx_ao412::object_rows.size())].index;
    const auto subindex = any<std::uint8_t>();
    const auto bytes = any<std::array<std::uint8_t, 8U>>();
    const std::size_t size = any<std::size_t>();
    assume(size <= bytes.size());
    const std::size_t at = any<std::size_t>();
    assume(at < generated::cbx_ao412::image_size);
    const std::uint8_t before = any_node.dictionary.image[at];
    const AbortCode code = any_node.node.write(index, subindex, ByteView{bytes.data(), size}, any_time());
    claim((code == AbortCode::none) || (any_node.dictionary.image[at] == before));
}

}  // namespace canproof::proofs
