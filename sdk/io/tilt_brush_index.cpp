// SPDX-License-Identifier: MIT
// metadata.json holds much that isn't needed. Only BrushIndex, an array of strings in the root object, is kept while the
// text is parsed: a document of everything takes many times the text's size, and hostile text packs well. The last
// BrushIndex counts where there are several.
#include "io/tilt_brush_index.h"

#include <nlohmann/json.hpp>

#include "io/failure.h"

namespace flg::io {

namespace {

using Json = nlohmann::json;

constexpr size_t most_brushes = size_t{1} << 16;
constexpr uint32_t most_depth = 256;

// A handler of nlohmann's SAX parser; all its functions say whether to go on, failures are thrown.
class BrushIndexReader {
public:
    explicit BrushIndexReader(const std::string& part) : part_(part) {}

    bool found() const { return found_; }
    std::vector<std::string> take() { return std::move(guids_); }

    bool null() { return other_value(); }
    bool boolean(bool) { return other_value(); }
    bool number_integer(Json::number_integer_t) { return other_value(); }
    bool number_unsigned(Json::number_unsigned_t) { return other_value(); }
    bool number_float(Json::number_float_t, const std::string&) { return other_value(); }
    bool binary(Json::binary_t&) { return other_value(); }
    bool string(std::string& value) {
        if (!in_index_) return other_value();
        if (guids_.size() == most_brushes) fail(FLG_ERROR_LIMIT, index_place(), "has more than 65536 brushes");
        guids_.push_back(std::move(value));
        return true;
    }
    bool key(std::string& name) {
        announced_ = depth_ == 1 && name == "BrushIndex";
        return true;
    }
    bool start_object(size_t) {
        other_value();
        return deeper();
    }
    bool end_object() {
        --depth_;
        return true;
    }
    bool start_array(size_t) {
        if (announced_) {
            announced_ = false;
            found_ = in_index_ = true;
            guids_.clear();
        } else {
            other_value();
        }
        return deeper();
    }
    bool end_array() {
        --depth_;
        in_index_ = false;  // nothing nests in it
        return true;
    }
    bool parse_error(size_t position, const std::string&, const Json::exception&) {
        fail(FLG_ERROR_FORMAT, byte_place(part_, position), "is no JSON");
    }

private:
    std::string index_place() const { return part_ + ".BrushIndex"; }

    bool other_value() const {
        if (announced_) fail(FLG_ERROR_FORMAT, index_place(), "is no array");
        if (in_index_) {
            fail(FLG_ERROR_FORMAT, index_place() + "[" + std::to_string(guids_.size()) + "]", "is no string");
        }
        return true;
    }
    bool deeper() {
        if (++depth_ > most_depth) fail(FLG_ERROR_LIMIT, part_, "nests more than %u deep", most_depth);
        return true;
    }

    const std::string& part_;
    std::vector<std::string> guids_;
    uint32_t depth_ = 0;
    bool announced_ = false;  // the value to come is the index
    bool in_index_ = false;
    bool found_ = false;
};

}  // namespace

std::vector<std::string> read_brush_index(Bytes metadata, const std::string& part) {
    BrushIndexReader reader(part);
    Json::sax_parse(metadata.begin(), metadata.end(), &reader);
    if (!reader.found()) fail(FLG_ERROR_FORMAT, part, "has no BrushIndex");
    return reader.take();
}

}  // namespace flg::io
