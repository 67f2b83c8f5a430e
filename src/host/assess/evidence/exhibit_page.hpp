// SPDX-License-Identifier: Apache-2.0
// The page of an exhibit (the result of one tool): generated from its data, or written by the tool and put into the
// frame of the pack.
#pragma once

#include <string>

#include "host/assess/evidence/exhibit.hpp"
#include "host/report/page.hpp"

namespace canproof::host {

/// Returns, as markup, the body of the page for an exhibit that has no page of its own: figures, CSV tables, plots.
std::string exhibit_page(const Exhibit& exhibit);
/// Returns the page that the tool has written, in the frame of the pack: the content of its `<main>` without the
/// heading, after the state and the open points. Returns a page without `<main>` unchanged.
std::string framed_page(const Exhibit& exhibit, const PageFrame& frame);

}  // namespace canproof::host
