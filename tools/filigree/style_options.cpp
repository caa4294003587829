// SPDX-License-Identifier: MIT
#include "style_options.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <map>

#include "choices.h"
#include "documents/failure.h"
#include "documents/progress.h"
#include "documents/text_file.h"
#include "support/curve_source.h"

namespace flg::cli {
namespace {

using samples::CurveSource;

constexpr size_t kMaxFurther = 7;
constexpr uint32_t kMaxPatchSizes = 8, kMaxPatch = 1024;
// Weight of attributes that are not lengths, where none is given: this share of the style's length for a difference of
// 1.
constexpr double kWeightPerLength = 0.01;

const std::map<std::string, FlgAttribute> kAttributes = {
    {"radius", FLG_ATTRIBUTE_RADIUS}, {"radii", FLG_ATTRIBUTE_RADII}, {"angle", FLG_ATTRIBUTE_ANGLE},
    {"width", FLG_ATTRIBUTE_WIDTH},   {"speed", FLG_ATTRIBUTE_SPEED}, {"color", FLG_ATTRIBUTE_COLOR}};
constexpr std::string_view kUser = "user";
const std::map<std::string, FlgMetric> kAngles = {{"s1", FLG_METRIC_CIRCLE}, {"rp1", FLG_METRIC_PROJECTIVE}};
constexpr const char* kMatching = "semi";

// FLG_ATTRIBUTE_POSITION, which no style transfers, for other words.
FlgAttribute attribute_of(const std::string& word) {
    const auto found = kAttributes.find(word);
    if (found != kAttributes.end()) return found->second;
    uint32_t number = 0;
    const char* end = word.data() + word.size();
    if (!word.starts_with(kUser)) return FLG_ATTRIBUTE_POSITION;
    const auto [stop, error] = std::from_chars(word.data() + kUser.size(), end, number);
    const bool known =
        error == std::errc() && stop == end && number < uint32_t{FLG_ATTRIBUTE_FORCE_32BIT} - FLG_ATTRIBUTE_USER;
    return known ? static_cast<FlgAttribute>(FLG_ATTRIBUTE_USER + number) : FLG_ATTRIBUTE_POSITION;
}

std::string name_of_attribute(FlgAttribute attribute) {
    if (attribute < FLG_ATTRIBUTE_USER) return name_of(kAttributes, attribute);
    return std::string(kUser) + std::to_string(attribute - FLG_ATTRIBUTE_USER);
}

bool has_angle(FlgAttribute attribute) {
    return attribute == FLG_ATTRIBUTE_ANGLE || attribute == FLG_ATTRIBUTE_RADII;
}

bool is_length(FlgAttribute attribute) {
    return attribute == FLG_ATTRIBUTE_RADIUS || attribute == FLG_ATTRIBUTE_RADII || attribute == FLG_ATTRIBUTE_WIDTH;
}

// NAME:VALUE -> the two; VALUE is "" where there is none.
std::pair<std::string, std::string> split(const std::string& word) {
    const size_t colon = word.find(':');
    if (colon == std::string::npos) return {word, ""};
    return {word.substr(0, colon), word.substr(colon + 1)};
}

bool read_number(const std::string& text, float& value) {
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    return error == std::errc() && end == text.data() + text.size() && std::isfinite(value);
}

FlgCurveSet create_set(FlgContext context, const FlgCurveSetView& view, const std::string& name) {
    FlgCurveSet set = {};
    check(flgCurveSetCreate(context, &view, &set), name);
    return set;
}

CurveSource load_curves(const std::string& name, Report& report) {
    say_step("reading " + name);
    CurveSource source(name);
    for (const std::string& warning : source.warnings()) report.warn(source.name() + ": " + warning);
    return source;
}

double total_length(const FlgCurveSetView& view) {
    double length = 0.0;
    for (uint32_t c = 0; c < view.curve_count; ++c) length += samples::curve_length(view, c);
    return length;
}

void check_matching(const std::string& word) {
    if (word == "discrete") throw CLI::ValidationError("--matching", "discrete matching has left the product");
    if (word != kMatching) throw CLI::ValidationError("--matching", "'" + word + "' is none of " + kMatching);
}

}  // namespace

StyleOptions::StyleOptions() : desc_(flgStyleDefaults()) {}

void StyleOptions::add_to(CLI::App& app, const std::string& smoothing) {
    std::string names;
    for (const std::string& name : scenes::library_names()) names += (names.empty() ? "" : ", ") + name;
    app.add_option_function<std::vector<std::string>>(
           "--style",
           [this](const std::vector<std::string>& styles) {
               style_ = styles.front();
               further_.assign(styles.begin() + 1, styles.end());
           },
           "The example: all curves of a file as one style, or builtin:NAME (" + names +
               "). Given several times: styles 0, 1, ... among which --drive NAME=style:A:B chooses")
        ->allow_extra_args(false);
    app.add_option("--style-file", style_file_,
                   "With --style: write the prepared style there. Without: read it from there, and prepare nothing")
        ->type_name("CACHE");
    const auto add = [this](CLI::Option* option) { preparing_.push_back(option); };
    add(app.add_option("--guide", guide_,
                       "The style's unstyled form, as many curves; made from the style if not given"));
    add(app.add_option("--patch", desc_.patch, "p, points each way that are compared before a jump, 1 to 1024")
            ->capture_default_str()
            ->check(CLI::Range(1u, kMaxPatch).description("")));
    add(app.add_option("--points", desc_.point_count, "Points of the style, 0: as many as its curves ask for")
            ->capture_default_str());
    add(app.add_option_function<std::vector<std::string>>(
               "--multiresolution", [this](const auto& words) { parse_patch_sizes(words); },
               "Several patch sizes instead, at most 8, each with its weight")
            ->delimiter(',')
            ->type_name("P:W,..."));
    add(app.add_option("--alpha", desc_.alpha, "Length that the guide keeps, 0 to 1: dL/dt = (alpha - 1) int kappa^2")
            ->capture_default_str()
            ->check(between_including(0.0, 1.0)));
    add(app.add_option(smoothing, desc_.smoothing,
                       "How far the guide is smoothed, > 0: a multiple of the amount chosen from the style. Smaller: "
                       "large waves stay in the guide; larger: more of the example is style. --save-guide shows it")
            ->capture_default_str()
            ->check(above_zero()));
    add(app.add_option("--beta", desc_.beta, "Closeness against evenness in the matching, between 0 and 1")
            ->capture_default_str()
            ->check(between(0.0, 1.0)));
    add(app.add_option_function<std::string>("--matching", &check_matching,
                                             "How guide points find their places on the style: anywhere on it")
            ->type_name(kMatching)
            ->default_str(kMatching));
    add(app.add_option_function<std::vector<std::string>>(
               "--attributes", [this](const auto& words) { parse_attributes(words); },
               "What is transferred besides the shape, of the columns that the style's file has: radius, radii, width, "
               "angle, speed, color, and the host's own, user0, user1, ...; a number after a colon is its weight in "
               "metres, how much a difference of 1 counts (angle:0.02; 0: it follows the shape); default 1 for "
               "lengths, a hundredth of the style's length for others")
            ->delimiter(',')
            ->type_name("NAME[:WEIGHT],..."));
    add(app.add_option_function<std::string>(
               "--caps", [this](const std::string& text) { parse_caps(text); },
               "Parts of the example that strokes begin and end with, once: lengths of its start and of its end, "
               "metres; "
               "auto: what comes before the first and after the last repetition")
            ->type_name("START:END|auto"));
    add(add_choice(
        app, "--angle", angle_, kAngles,
        "Ribbons whose sides differ (s1) or not (rp1, half a turn changes nothing), and ellipses (radii) likewise"));
}

void StyleOptions::parse_attributes(const std::vector<std::string>& words) {
    for (const std::string& word : words) {
        const auto [name, weight] = split(word);
        Attribute attribute = {attribute_of(name), -1.0f};
        if (attribute.attribute == FLG_ATTRIBUTE_POSITION) {
            throw CLI::ValidationError(
                "--attributes",
                "'" + name + "' is none of radius, radii, width, angle, speed, color, user0, user1, ...");
        }
        if (name.size() < word.size() && (!read_number(weight, attribute.weight) || attribute.weight < 0.0f)) {
            throw CLI::ValidationError("--attributes", "'" + weight + "' is not a weight, a number >= 0");
        }
        attributes_.push_back(attribute);
    }
}

void StyleOptions::parse_patch_sizes(const std::vector<std::string>& words) {
    if (words.size() > kMaxPatchSizes) throw CLI::ValidationError("--multiresolution", "takes at most 8 patch sizes");
    for (const std::string& word : words) {
        const auto [size, weight] = split(word);
        float patch = 0.0f, counts = 1.0f;
        if (!read_number(size, patch) || patch < 1.0f || patch > kMaxPatch || patch != std::floor(patch) ||
            (size.size() < word.size() && (!read_number(weight, counts) || !(counts > 0.0f)))) {
            throw CLI::ValidationError("--multiresolution",
                                       "'" + word + "' is not P:W with P from 1 to 1024 and W > 0");
        }
        patch_sizes_.push_back({static_cast<uint32_t>(patch), counts});
    }
}

void StyleOptions::parse_caps(const std::string& text) {
    constexpr float found = -1.0f;
    const auto [start, end] = split(text);
    desc_.start_cap = desc_.end_cap = found;
    if (text == "auto") return;
    if (!read_number(start, desc_.start_cap) || !read_number(end, desc_.end_cap) || desc_.start_cap < 0.0f ||
        desc_.end_cap < 0.0f) {
        throw CLI::ValidationError("--caps", "'" + text + "' is neither auto nor START:END, two numbers >= 0");
    }
}

void StyleOptions::check_usage() const {
    if (further_.size() > kMaxFurther) throw UsageError("--style: takes at most 8 styles");
    if (!further_.empty() && (!guide_.empty() || !style_file_.empty())) {
        throw UsageError((guide_.empty() ? "--style-file" : "--guide") +
                         std::string(": is of one style, not of several"));
    }
    if (style_.empty() && style_file_.empty()) {
        throw UsageError("--style is required, or --style-file with a style that was saved (filigree --help)");
    }
    if (style_.empty()) {
        for (const CLI::Option* option : preparing_) {
            if (option->count() == 0) continue;
            throw UsageError(option->get_name() + ": a style from a file is prepared already; give --style, too");
        }
    } else {
        require_writable(style_file_);
    }
    const auto turns = [](const Attribute& a) { return has_angle(a.attribute); };
    if (angle_ != FLG_METRIC_AUTO && std::none_of(attributes_.begin(), attributes_.end(), turns)) {
        throw UsageError("--angle: needs angle or radii among --attributes");
    }
}

void StyleOptions::describe(Report& report) const {
    if (further_.empty() && !style_.empty()) report.parameters["style"] = style_;
    if (!further_.empty()) {
        report.parameters["style"].push_back(style_);
        for (const std::string& name : further_) report.parameters["style"].push_back(name);
    }
    if (!style_file_.empty()) report.parameters["style_file"] = style_file_;
    if (style_.empty()) return;
    if (!guide_.empty()) report.parameters["guide"] = guide_;
    report.parameters["patch"] = desc_.patch;
    if (desc_.point_count != 0) report.parameters["points"] = desc_.point_count;
    for (const FlgPatchSize& size : patch_sizes_) {
        report.parameters["multiresolution"].push_back({size.patch, as_written(size.weight)});
    }
    report.parameters["alpha"] = as_written(desc_.alpha);
    report.parameters["guide_smoothing"] = as_written(desc_.smoothing);
    report.parameters["beta"] = as_written(desc_.beta);
    report.parameters["matching"] = kMatching;
    if (desc_.start_cap != 0.0f || desc_.end_cap != 0.0f) {
        report.parameters["caps"] = {as_written(desc_.start_cap), as_written(desc_.end_cap)};
    }
    for (const Attribute& a : attributes_) report.parameters["attributes"].push_back(name_of_attribute(a.attribute));
    if (angle_ != FLG_METRIC_AUTO) report.parameters["angle"] = name_of(kAngles, angle_);
}

std::vector<FlgStyleAttribute> StyleOptions::attributes(double style_length) const {
    std::vector<FlgStyleAttribute> list;
    for (const Attribute& a : attributes_) {
        const double usual = is_length(a.attribute) ? 1.0 : kWeightPerLength * style_length;
        list.push_back({a.attribute, has_angle(a.attribute) ? angle_ : FLG_METRIC_AUTO,
                        a.weight < 0.0f ? static_cast<float>(usual) : a.weight, 0});
    }
    return list;
}

FlgStyle StyleOptions::start(FlgContext context, Report& report, FlgJob& out_job) const {
    out_job = {};
    return style_.empty() ? load(context, report) : learn(context, style_, report, out_job);
}

std::vector<FlgStyle> StyleOptions::start_further(FlgContext context, Report& report,
                                                  std::vector<Pending>& jobs) const {
    std::vector<FlgStyle> styles;
    for (const std::string& name : further_) {
        Pending pending = {{}, name};
        styles.push_back(learn(context, name, report, pending.job));
        jobs.push_back(pending);
    }
    return styles;
}

FlgStyle StyleOptions::learn(FlgContext context, const std::string& name, Report& report, FlgJob& out_job) const {
    FlgStyleDesc desc = desc_;
    const CurveSource style = load_curves(name, report);
    desc.style = create_set(context, style.view(), name);
    report.counts["style_curves"] = style.view().curve_count;
    report.counts["style_curve_points"] = style.point_count();
    if (!guide_.empty()) desc.guide = create_set(context, load_curves(guide_, report).view(), guide_);
    const std::vector<FlgStyleAttribute> list = attributes(total_length(style.view()));
    desc.attributes = list.empty() ? nullptr : list.data();
    desc.attribute_count = static_cast<uint32_t>(list.size());
    desc.patch_sizes = patch_sizes_.empty() ? nullptr : patch_sizes_.data();
    desc.patch_size_count = static_cast<uint32_t>(patch_sizes_.size());
    FlgStyle prepared = {};
    check(flgStyleCreate(context, &desc, &prepared, &out_job), name);
    return prepared;
}

FlgStyle StyleOptions::load(FlgContext context, Report& report) const {
    std::ifstream file(style_file_, std::ios::binary);
    if (!file) throw InputError(style_file_ + ": can't be opened");
    const std::vector<char> bytes{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    if (file.bad()) throw InputError(style_file_ + ": can't be read");
    FlgStyle style = {};
    check(flgStyleCreateFromData(context, bytes.data(), bytes.size(), &style), style_file_);
    report.counts["style_file_bytes"] = bytes.size();
    return style;
}

void StyleOptions::describe_caps(FlgContext context, FlgStyle style, Report& report) const {
    FlgStyleInfo info = {};
    info.struct_size = sizeof info;
    check(flgStyleGetInfo(context, style, &info), subject());
    report.counts["start_cap_points"] = info.start_cap_points;
    report.counts["end_cap_points"] = info.end_cap_points;
    if (desc_.start_cap < 0.0f && info.start_cap_points + info.end_cap_points == 0) {
        report.warn("--caps auto: " + style_ + " has no part before its first repetition or after its last one");
    }
}

void StyleOptions::save(FlgContext context, FlgStyle style, Report& report) const {
    if (style_.empty() || style_file_.empty()) return;
    size_t size = 0;
    check(flgStyleGetData(context, style, nullptr, 0, &size), style_);
    std::string bytes(size, '\0');
    check(flgStyleGetData(context, style, bytes.data(), bytes.size(), &size), style_);
    write_text_file(style_file_, bytes);
    report.counts["style_file_bytes"] = size;
}

}  // namespace flg::cli
