// SPDX-License-Identifier: Apache-2.0
// The record of how many mutants of each source the tests notice: reports/code_figures.csv, which `canproof mutate
// --code` writes. A source whose code is unchanged keeps its figures, so that a run may test the mutants of single
// files only.
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
    std::string code;  ///< hash of the source's code (without comments and layout) when its mutants were tested
    OperatorCount count;
};

/// The figures (counts of mutants) of each source, by its path.
using CodeFigures = std::map<std::string, FileFigures>;

/// Reads the record; returns an empty record when the file does not exist. Throws InputError with the line of invalid
/// content.
CodeFigures read_code_figures(const std::filesystem::path& file);
/// Returns the record as CSV: a heading, and one line for each source, sorted by path.
std::string write_code_figures(const CodeFigures& figures);

/// Replaces the figures of each source in `outcomes`, which must contain all mutants of this source. Removes the
/// figures of sources that no longer exist. `root` is the project's folder.
void note_figures(CodeFigures& figures, const std::vector<MutationOutcome>& outcomes,
                  const std::filesystem::path& root);

/// The figures (counts of mutants) of each layer of the code: the sums over the layer's sources.
struct LayerTable {
    std::string text;  ///< a table in Markdown
    /// sources whose present code no mutation run has tested, with their number of mutants
    std::vector<std::string> unjudged;
    std::size_t open{0};  ///< number of surviving mutants without a reason
};

/// Adds up the figures by layer. `mutants` are all mutants of the present code. A source whose code or number of
/// mutants differs from its figures goes to `unjudged`, and these figures do not count.
LayerTable layer_table(const CodeFigures& figures, const std::vector<AlteredCell>& mutants,
                       const std::filesystem::path& root);

}  // namespace canproof::host
