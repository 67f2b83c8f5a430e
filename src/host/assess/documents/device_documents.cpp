// SPDX-License-Identifier: Apache-2.0
#include "host/assess/documents/device_documents.hpp"

#include "host/assess/documents/error_matrix.hpp"
#include "host/assess/documents/failure_modes.hpp"
#include "host/assess/documents/hardware_interface.hpp"
#include "host/assess/documents/interface_control.hpp"
#include "host/assess/documents/safety_manual.hpp"
#include "host/assess/documents/threats.hpp"

namespace canproof::host {

std::vector<Document> device_documents(const Register& content, const Part& part, const Analysis& analysis) {
    return {safety_manual(content, part),           hardware_interface(part),
            interface_control(content, part),       error_matrix(content, part, analysis),
            failure_modes(content, part, analysis), threats(part, analysis)};
}

}  // namespace canproof::host
