// SPDX-License-Identifier: MIT
// How `stylize` comes by its style: learnt from curves with many options, or read from a style file.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "documents/report.h"
#include "filigree/filigree.h"

namespace flg::cli {

class StyleOptions {
public:
    StyleOptions();
    // `smoothing`: what the option for the guide's is called, where a command has another of that name.
    void add_to(CLI::App& app, const std::string& smoothing = "--smoothing");

    // Refuses what does not go together (UsageError) and files that can't be written.
    void check_usage() const;
    void describe(Report& report) const;
    // A style that is prepared by `out_job` (null: ready at once, from the style file).
    FlgStyle start(FlgContext context, Report& report, FlgJob& out_job) const;
    // Those behind the first, prepared alike; their jobs are appended.
    struct Pending {
        FlgJob job;
        std::string subject;
    };
    std::vector<FlgStyle> start_further(FlgContext context, Report& report, std::vector<Pending>& jobs) const;
    // Keeps the style, ready by now, if a file is wanted.
    void save(FlgContext context, FlgStyle style, Report& report) const;
    // How long a prepared style's caps are. Warns where none were found.
    void describe_caps(FlgContext context, FlgStyle style, Report& report) const;
    size_t count() const { return further_.size() + 1; }
    // Styles from files may have caps too.
    bool may_have_caps() const { return style_.empty() || desc_.start_cap != 0.0f || desc_.end_cap != 0.0f; }
    bool may_have_end_cap() const { return style_.empty() || desc_.end_cap != 0.0f; }
    // What errors are about.
    const std::string& subject() const { return style_.empty() ? style_file_ : style_; }

private:
    struct Attribute {
        FlgAttribute attribute;
        float weight;  // negative: not given
    };

    FlgStyle learn(FlgContext context, const std::string& name, Report& report, FlgJob& out_job) const;
    FlgStyle load(FlgContext context, Report& report) const;
    std::vector<FlgStyleAttribute> attributes(double style_length) const;
    void parse_attributes(const std::vector<std::string>& words);
    void parse_patch_sizes(const std::vector<std::string>& words);
    void parse_caps(const std::string& text);

    std::string style_, guide_, style_file_;
    std::vector<std::string> further_;
    std::vector<Attribute> attributes_;
    std::vector<FlgPatchSize> patch_sizes_;
    FlgMetric angle_ = FLG_METRIC_AUTO;
    FlgStyleDesc desc_;
    // Options that say how a style is prepared: they mean nothing to one that is loaded.
    std::vector<CLI::Option*> preparing_;
};

}  // namespace flg::cli
