// The electronic data sheet (CiA 306) of a device, and its dictionary in other forms.
#pragma once

#include <string>

#include "host/speccompiler/register.hpp"

namespace canproof::host {

/// CiA 306 EDS: CRLF, dated by the manual, the same bytes on every run.
std::string write_eds(const Register& content, const Part& device);
/// CiA 311 XDD (ISO 15745 profile containers).
std::string write_xdd(const Register& content, const Part& device);
/// The dictionary as JSON: one member an object, with its entries.
std::string write_object_json(const Register& content, const Part& device);
/// The dictionary as a Markdown table for reading.
std::string write_object_markdown(const Register& content, const Part& device);

}  // namespace canproof::host
