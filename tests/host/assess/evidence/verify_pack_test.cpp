// SPDX-License-Identifier: Apache-2.0
// Tests that an evidence pack is rejected when it was changed after it was written, or when another key signed it.
#include "host/assess/evidence/verify_pack.hpp"

#include <gmock/gmock.h>

#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>

#include "host/assess/evidence/in_toto.hpp"
#include "host/assess/evidence/pack.hpp"
#include "host/assess/evidence/provenance.hpp"
#include "host/base/child_process.hpp"
#include "host/base/input_error.hpp"
#include "host/base/signature.hpp"

namespace canproof::host::test {

namespace {

namespace fs = std::filesystem;

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

class SignedPack : public ::testing::Test {
  protected:
    SignedPack() {
        fs::remove_all(folder_);
        fs::create_directories(pack_);
        const PackFiles files{{"a.txt", "one"}, {"b.txt", "two"}};
        for (const auto& [name, text] : files) {
            write(name, text);
        }
        manifest_ = write_manifest(files, {});
        write("manifest.json", manifest_);
    }
    ~SignedPack() override { fs::remove_all(folder_); }

    void write(const std::string& name, const std::string& text) const {
        std::ofstream{pack_ / name, std::ios::binary} << text;
    }
    /// Makes a key pair with the OpenSSL program: NAME.key and NAME.pub. Returns their common path without the ending.
    fs::path key(const std::string& name, const std::vector<std::string>& kind) const {
        const fs::path stem = folder_ / name;
        std::vector<std::string> words{"openssl", "genpkey", "-out", stem.string() + ".key"};
        words.insert(words.end(), kind.begin(), kind.end());
        EXPECT_TRUE(output_of(words).has_value());
        EXPECT_TRUE(
            output_of({"openssl", "pkey", "-in", stem.string() + ".key", "-pubout", "-out", stem.string() + ".pub"})
                .has_value());
        return stem;
    }
    std::vector<std::string> faults(const fs::path& key = {}) const { return faults_of_pack(pack_, key); }

    fs::path folder_{fs::path{::testing::TempDir()} / "signed_pack"};
    fs::path pack_{folder_ / "pack"};
    std::string manifest_;
};

}  // namespace

TEST_F(SignedPack, PackThatDiffersFromItsManifestIsRejected) {
    EXPECT_THAT(faults(), IsEmpty());
    write("a.txt", "three");
    fs::remove(pack_ / "b.txt");
    write("c.txt", "new");
    EXPECT_THAT(faults(),
                ElementsAre("a.txt differs from the manifest", "b.txt is missing", "c.txt is not in the manifest"));
}

TEST_F(SignedPack, SignatureIsVerifiedByTheSigningKeyOnly) {
    for (const auto& kind : std::vector<std::vector<std::string>>{
             {"-algorithm", "ed25519"}, {"-algorithm", "EC", "-pkeyopt", "ec_paramgen_curve:P-256"}}) {
        const fs::path mine = key("mine", kind);
        const fs::path other = key("other", kind);
        fs::remove(pack_ / manifest_signature);
        EXPECT_THAT(faults(mine.string() + ".pub"), ElementsAre(HasSubstr("there is no manifest.json.sig")));
        write(manifest_signature, sign(manifest_, mine.string() + ".key"));
        EXPECT_THAT(faults(mine.string() + ".pub"), IsEmpty());
        EXPECT_THAT(faults(other.string() + ".pub"), ElementsAre(HasSubstr("is not valid for")));
        write("manifest.json", manifest_ + " ");
        EXPECT_THAT(faults(mine.string() + ".pub"), ElementsAre(HasSubstr("is not valid for")));
        write("manifest.json", manifest_);
    }
}

TEST_F(SignedPack, SignatureIsVerifiedByTheOpenSslProgram) {
    const fs::path mine = key("mine", {"-algorithm", "EC", "-pkeyopt", "ec_paramgen_curve:P-256"});
    write(manifest_signature, sign(manifest_, mine.string() + ".key"));
    const auto verified = [&] {
        return output_of({"openssl", "dgst", "-sha256", "-verify", mine.string() + ".pub", "-signature",
                          (pack_ / manifest_signature).string(), (pack_ / "manifest.json").string()});
    };
    EXPECT_EQ(verified().value_or(""), "Verified OK\n");
    write("manifest.json", manifest_ + " ");
    EXPECT_FALSE(verified().has_value());
}

TEST_F(SignedPack, OnlyLayoutAndLinkOfInTotoMayBeMissingInTheManifest) {
    fs::create_directories(pack_ / "in-toto");
    write("in-toto/root.layout", "{}");
    write("in-toto/evidence.0123abcd.link", "{}");
    EXPECT_THAT(faults(), IsEmpty());
    write("in-toto/evidence.0123abcd.link.html", "{}");
    EXPECT_THAT(faults(), ElementsAre("in-toto/evidence.0123abcd.link.html is not in the manifest"));
}

TEST_F(SignedPack, InTotoMetadataIsWrittenForEd25519AndP256Only) {
    Provenance provenance;
    provenance.date = "2024-02-29T12:00:00Z";
    const auto files_for = [&](const std::vector<std::string>& kind) {
        return in_toto_files({{"a.txt", "abc"}}, {{"run", std::string(64, '1')}}, provenance,
                             key("in_toto", kind).string() + ".key");
    };
    EXPECT_THAT(files_for({"-algorithm", "ed448"}), IsEmpty());
    EXPECT_THAT(files_for({"-algorithm", "EC", "-pkeyopt", "ec_paramgen_curve:P-384"}), IsEmpty());
    EXPECT_EQ(files_for({"-algorithm", "EC", "-pkeyopt", "ec_paramgen_curve:P-256"}).size(), 2U);
    const PackFiles files = files_for({"-algorithm", "ed25519"});
    ASSERT_EQ(files.size(), 2U);
    for (const auto& [name, text] : files) {
        EXPECT_TRUE(is_in_toto_file(name)) << name;
    }
    // The layout expires ten years after 2024, on the last day of the year; 29 February is not in every year.
    EXPECT_THAT(files.at("in-toto/root.layout"), HasSubstr("\"expires\": \"2034-12-31T23:59:59Z\""));
    const auto link = nlohmann::json::parse(files.begin()->second).at("signed");
    EXPECT_EQ(link.at("materials").at("run").at("sha256"), std::string(64, '1'));
    // SHA-256 of "abc" as FIPS 180-4 prints it
    EXPECT_EQ(link.at("products").at("a.txt").at("sha256"),
              "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
}

TEST_F(SignedPack, InTotoMetadataWithEd25519IsReproducible) {
    Provenance provenance;
    provenance.date = "2024-01-01T00:00:00Z";
    const std::string mine = key("mine", {"-algorithm", "ed25519"}).string() + ".key";
    EXPECT_EQ(in_toto_files({{"a.txt", "abc"}}, {}, provenance, mine),
              in_toto_files({{"a.txt", "abc"}}, {}, provenance, mine));
}

TEST_F(SignedPack, InvalidKeyAndMissingOrInvalidManifestAreErrors) {
    EXPECT_THROW(sign("x", pack_ / "a.txt"), InputError);
    EXPECT_THROW(is_signed("x", "y", pack_ / "a.txt"), InputError);
    EXPECT_THROW(faults_of_pack(folder_, {}), InputError);
    write("manifest.json", "{}");
    EXPECT_THROW(faults(), InputError);
}

}  // namespace canproof::host::test
