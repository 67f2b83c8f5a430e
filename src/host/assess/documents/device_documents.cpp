// SPDX-License-Identifier: Apache-2.0
#include "host/assess/documents/device_documents.hpp"

#include "host/assess/documents/applicability.hpp"
#include "host/assess/documents/error_matrix.hpp"
#include "host/assess/documents/failure_modes.hpp"
#include "host/assess/documents/hardware_interface.hpp"
#include "host/assess/documents/interface_control.hpp"
#include "host/assess/documents/safety_manual.hpp"
#include "host/assess/documents/threats.hpp"

namespace canproof::host {

std::vector<Document> device_documents(const Register& content, const Part& part, const Analysis& analysis) {
    std::vector<Document> all{safety_manual(content, part, analysis),     hardware_interface(part, analysis),
                              interface_control(content, part, analysis), error_matrix(content, part, analysis),
                              failure_modes(content, part, analysis),     threats(part, analysis)};
    for (const auto& document : all) {
        check_shared_items(document, content, analysis.shared, part);
    }
    return all;
}

}  // namespace canproof::host
