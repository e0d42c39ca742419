// The files that tamis-lab paper writes: tables as CSV, and one report in Markdown.
#pragma once
#include <filesystem>
#include <span>
#include <string>

#include "paper/command/evaluation/run.hpp"

namespace tamis::lab {

/// table1.csv: a row for each scene, step and method.
void write_paper_table(const std::filesystem::path& folder, std::span<const SceneResult> results);
/// stages.csv: the pairs that enter each stage.
void write_paper_stages(const std::filesystem::path& folder, std::span<const SceneResult> results);
/// report.md. `size` says at what size the scenes were run.
void write_paper_report(const std::filesystem::path& folder, std::span<const SceneResult> results,
                        const std::string& size);

/// 1 - leaving / entering: the part that is culled; 0 if nothing entered.
double culled_part(std::uint64_t entering, std::uint64_t leaving);

}  // namespace tamis::lab
