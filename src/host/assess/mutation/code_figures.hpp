// SPDX-License-Identifier: Apache-2.0
// The record of how many mutants of each source the tests notice: reports/code_figures.csv, which `canproof mutate
// --code` writes. A source whose code is unchanged keeps its figures, so that a run can judge single files.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "host/assess/mutation/mutation_outcome.hpp"
#include "host/assess/mutation/mutation_table.hpp"

namespace canproof::host {

/// The figures (counts of mutants) of one source.
struct FileFigures {
    std::string code;  ///< mark (hash) of its code, without comments, layout and links, when it was judged
    OperatorCount count;
};

/// The figures (counts of mutants) of each source, by its path.
using CodeFigures = std::map<std::string, FileFigures>;

/// Reads the record; returns an empty record when the file does not exist. Throws InputError with the line of invalid
/// content.
CodeFigures read_code_figures(const std::filesystem::path& file);
/// Returns the record as CSV: a heading, and one line for each source, sorted by path.
std::string write_code_figures(const CodeFigures& figures);

/// Replaces the figures of all sources in `outcomes`, which must have all mutants of each of them, and removes those of
/// sources that no longer exist. `root` is the project's folder.
void note_figures(CodeFigures& figures, const std::vector<MutationOutcome>& outcomes,
                  const std::filesystem::path& root);

/// The figures (counts of mutants) of each layer of the code: the sums over the layer's sources.
struct LayerTable {
    std::string text;                   ///< a table in Markdown
    std::vector<std::string> unjudged;  ///< sources without figures of their present code, with their number of mutants
    std::size_t open{0};                ///< number of surviving mutants without a reason
};

/// Adds up the figures by layer. `mutants` are all present mutants: a source whose code or number of mutants differs
/// from the record is listed, and its old figures do not count.
LayerTable layer_table(const CodeFigures& figures, const std::vector<AlteredCell>& mutants,
                       const std::filesystem::path& root);

}  // namespace canproof::host
