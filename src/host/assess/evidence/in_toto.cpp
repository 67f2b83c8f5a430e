// SPDX-License-Identifier: Apache-2.0
#include "host/assess/evidence/in_toto.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <optional>
#include <regex>
#include <vector>

#include "host/assess/evidence/provenance.hpp"
#include "host/assess/evidence/verify_pack.hpp"
#include "host/base/sha256.hpp"
#include "host/base/signature.hpp"

namespace canproof::host {

namespace {

using Json = nlohmann::json;  // nlohmann::json sorts the members, as canonical JSON requires

constexpr const char* step_name = "evidence";

/// Returns a text in quotes. Canonical JSON escapes the quote and the backslash and nothing else.
std::string canonical_text(const std::string& text) {
    std::string quoted{"\""};
    for (const char one : text) {
        quoted += one == '"' || one == '\\' ? std::string{'\\', one} : std::string(1, one);
    }
    return quoted + "\"";
}

/// Returns canonical JSON, the bytes that are signed: sorted members, no blanks, no fractions.
std::string canonical(const Json& value) {
    if (value.is_string()) {
        return canonical_text(value.get<std::string>());
    }
    if (!value.is_structured()) {
        return value.dump();
    }
    std::string text;
    for (const auto& [name, member] : value.items()) {
        text += (text.empty() ? "" : ",") + (value.is_object() ? canonical_text(name) + ":" : "") + canonical(member);
    }
    return value.is_object() ? "{" + text + "}" : "[" + text + "]";
}

/// A signing key with the description that in-toto requires.
struct Signer {
    std::filesystem::path file;
    Json key;
    std::string id;  ///< SHA-256 of the description
};

std::optional<Signer> signer_with(const std::filesystem::path& private_key) {
    const PublicKey known = public_key_of(private_key);
    const bool is_edwards = known.kind == "ED25519";
    if (!is_edwards && known.kind != "EC prime256v1") {
        return std::nullopt;
    }
    Signer made{private_key, {}, ""};
    made.key = {{"keytype", is_edwards ? "ed25519" : "ecdsa"},
                {"scheme", is_edwards ? "ed25519" : "ecdsa-sha2-nistp256"},
                {"keyid_hash_algorithms", Json::array({"sha256", "sha512"})},
                {"keyval", {{"public", known.text}}}};
    made.id = sha256(canonical(made.key));
    made.key["keyid"] = made.id;
    return made;
}

/// Returns the text of a metadata file: the object and a signature of its canonical form.
std::string signed_text(const Json& object, const Signer& signer) {
    std::string hex;
    for (const char one : sign(canonical(object), signer.file)) {
        hex += fmt::format("{:02x}", static_cast<unsigned char>(one));
    }
    const Json signature{{"keyid", signer.id}, {"sig", hex}};
    return Json{{"signed", object}, {"signatures", Json::array({signature})}}.dump(1) + "\n";
}

Json hashes_of(const std::map<std::string, std::string>& sums) {
    Json all = Json::object();
    for (const auto& [name, sum] : sums) {
        all[name] = {{"sha256", sum}};
    }
    return all;
}

/// Returns the expiry date of the layout: the end of the tenth year after the year of the pack. A layout must have an
/// expiry date.
std::string expiry_of(const Provenance& provenance) {
    const int year = std::stoi(provenance.date.substr(0, 4));
    return fmt::format("{:04}-12-31T23:59:59Z", year + 10);
}

/// A shell command that compares the files of the pack with the checksums in manifest.json. It fails if a file is
/// missing.
constexpr const char* check_sums = R"sh(sed -n 's/^ *"\(.*\)": "\([0-9a-f]\{64\}\)",\{0,1\}$/\2  \1/p' manifest.json |
sha256sum --check --quiet)sh";

Json rule(const std::vector<std::string>& words) {
    return words;
}

Json step_of(const Signer& signer) {
    return {{"_type", "step"},
            {"name", step_name},
            {"expected_materials", Json::array({rule({"ALLOW", "*"})})},
            {"expected_products", Json::array({rule({"CREATE", "*"}), rule({"DISALLOW", "*"})})},
            {"pubkeys", Json::array({signer.id})},
            {"expected_command", Json::array()},
            {"threshold", 1}};
}

/// Returns the inspection of the in-toto layout, which a verifier runs in the folder of the pack. The rules of the
/// inspection refuse a file that the step `evidence` did not make.
Json inspection() {
    const Json rules =
        Json::array({rule({"REQUIRE", "manifest.json"}), rule({"MATCH", "*", "WITH", "PRODUCTS", "FROM", step_name}),
                     rule({"ALLOW", manifest_signature}), rule({"ALLOW", in_toto_layout}), rule({"DISALLOW", "*"})});
    return {{"_type", "inspection"},
            {"name", "pack"},
            {"expected_materials", rules},
            {"expected_products", rules},
            {"run", rule({"sh", "-c", check_sums})}};
}

Json layout_of(const Provenance& provenance, const Signer& signer) {
    return {{"_type", "layout"},
            {"expires", expiry_of(provenance)},
            {"readme", "The evidence pack of canproof " + provenance.commit},
            {"keys", {{signer.id, signer.key}}},
            {"steps", Json::array({step_of(signer)})},
            {"inspect", Json::array({inspection()})}};
}

Json link_of(const PackFiles& products, const std::map<std::string, std::string>& materials,
             const Provenance& provenance) {
    std::map<std::string, std::string> sums;
    for (const auto& [name, bytes] : products) {
        sums[name] = sha256(bytes);
    }
    return {{"_type", "link"},
            {"name", step_name},
            {"command", rule({"canproof", "evidence", "--sign", "KEY"})},
            {"materials", hashes_of(materials)},
            {"products", hashes_of(sums)},
            {"byproducts", Json::object()},
            {"environment", {{"commit", provenance.commit}, {"configuration", provenance.configuration}}}};
}

}  // namespace

bool is_in_toto_file(const std::string& name) {
    static const std::regex link{R"(in-toto/evidence\.[0-9a-f]{8}\.link)"};
    return name == in_toto_layout || std::regex_match(name, link);
}

PackFiles in_toto_files(const PackFiles& products, const std::map<std::string, std::string>& materials,
                        const Provenance& provenance, const std::filesystem::path& private_key) {
    const std::optional<Signer> signer = signer_with(private_key);
    if (!signer) {
        return {};
    }
    const std::string link = fmt::format("in-toto/{}.{}.link", step_name, signer->id.substr(0, 8));
    return {{in_toto_layout, signed_text(layout_of(provenance, *signer), *signer)},
            {link, signed_text(link_of(products, materials, provenance), *signer)}};
}

}  // namespace canproof::host
