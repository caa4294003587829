// SPDX-License-Identifier: MIT
// Source: RFC 8259.
#include "io/base/json.h"

#include <algorithm>
#include <charconv>
#include <cstring>

#include "io/base/failure.h"
#include "io/base/json_text.h"

namespace flg::io {

std::span<const JsonMember> Json::members() const {
    return is_object() ? std::span(value_.members, size_) : std::span<const JsonMember>();
}

const Json* Json::find(std::string_view name) const {
    const auto all = members();
    const auto found = std::lower_bound(
        all.begin(), all.end(), name, [](const JsonMember& member, std::string_view key) { return member.name < key; });
    return found != all.end() && found->name == name ? &found->value : nullptr;
}

bool Json::operator==(const Json& other) const {
    if (type_ != other.type_ || size_ != other.size_) return false;
    switch (type_) {
        case Type::number: return value_.number == other.value_.number;
        case Type::string: return string() == other.string();
        case Type::array: return std::equal(value_.items, value_.items + size_, other.value_.items);
        case Type::object:
            return std::equal(value_.members, value_.members + size_, other.value_.members,
                              [](const auto& a, const auto& b) { return a.name == b.name && a.value == b.value; });
        default: return value_.count == other.value_.count;
    }
}

class JsonParser {
public:
    JsonParser(Bytes text, uint32_t max_levels, std::string_view part, std::string_view only,
               std::pmr::memory_resource& arena)
        : text_(as_text(text)), max_levels_(max_levels), part_(part), only_(only), arena_(arena) {
        constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";
        if (text_.starts_with(byte_order_mark)) at_ = byte_order_mark.size();
    }

    Json document() {
        const Json root = value(0, true);
        skip_space();
        // Some programs fill up with zeros.
        if (at_ < text_.size() && text_[at_] != '\0') refuse();
        return root;
    }

private:
    struct OpenMember {
        std::string_view name;
        Json value;
        uint32_t order;  // in the object
    };

    // Where parsing stopped, counted from 1.
    [[noreturn]] void refuse() const { fail(FLG_ERROR_FORMAT, byte_place(part_, at_ + 1), "is no JSON"); }

    char peek() const { return at_ < text_.size() ? text_[at_] : '\0'; }
    void expect(char c) {
        if (at_ >= text_.size() || text_[at_] != c) refuse();
        ++at_;
    }
    bool take(char c) {
        if (at_ >= text_.size() || text_[at_] != c) return false;
        ++at_;
        return true;
    }
    void skip_space() {
        while (at_ < text_.size() && std::string_view(" \t\n\r").find(text_[at_]) != std::string_view::npos) ++at_;
    }
    void word(std::string_view word) {
        for (const char c : word) expect(c);
    }

    // What is not kept is checked only.
    Json value(uint32_t level, bool keep) {
        skip_space();
        if (level > max_levels_) {
            fail(FLG_ERROR_LIMIT, String(part_), "its JSON nests deeper than %u levels", max_levels_);
        }
        Json result;
        switch (peek()) {
            case '{': object(level, keep, result); break;
            case '[': array(level, keep, result); break;
            case '"': {
                const std::string_view text = string(keep);
                result.type_ = Json::Type::string;
                result.value_.string = text.data();
                result.size_ = static_cast<uint32_t>(text.size());
                break;
            }
            case 't':
                word("true");
                result.type_ = Json::Type::boolean;
                result.value_.count = 1;
                break;
            case 'f':
                word("false");
                result.type_ = Json::Type::boolean;
                break;
            case 'n': word("null"); break;
            default: number(result);
        }
        return result;
    }

    void array(uint32_t level, bool keep, Json& result) {
        expect('[');
        const size_t first = items_.size();
        skip_space();
        if (!take(']')) {
            do {
                const Json item = value(level + 1, keep);
                if (keep) items_.push_back(item);
                skip_space();
            } while (take(','));
            expect(']');
        }
        const size_t count = items_.size() - first;
        result.type_ = Json::Type::array;
        result.size_ = static_cast<uint32_t>(count);
        result.value_.items = copy(items_.data() + first, count);
        items_.resize(first);
    }

    void object(uint32_t level, bool keep, Json& result) {
        expect('{');
        const size_t first = members_.size();
        skip_space();
        if (!take('}')) {
            do {
                skip_space();
                const std::string_view name = string(keep);
                skip_space();
                expect(':');
                const bool keep_member = keep && (level > 0 || only_.empty() || name == only_);
                const Json member = value(level + 1, keep_member);
                if (keep_member) members_.push_back({name, member, static_cast<uint32_t>(members_.size() - first)});
                skip_space();
            } while (take(','));
            expect('}');
        }
        result.type_ = Json::Type::object;
        result.value_.members = nullptr;
        if (members_.size() == first) return;
        const auto begin = members_.begin() + static_cast<std::ptrdiff_t>(first);
        std::sort(begin, members_.end(), [](const OpenMember& a, const OpenMember& b) {
            return a.name != b.name ? a.name < b.name : a.order > b.order;
        });
        const auto end = std::unique(begin, members_.end(),
                                     [](const OpenMember& a, const OpenMember& b) { return a.name == b.name; });
        result.size_ = static_cast<uint32_t>(end - begin);
        JsonMember* const to = take_room<JsonMember>(result.size_);
        for (size_t i = 0; i < result.size_; ++i)
            std::construct_at(to + i, JsonMember{members_[first + i].name, members_[first + i].value});
        result.value_.members = to;
        members_.resize(first);
    }

    template <class T>
    T* take_room(size_t count) {
        return static_cast<T*>(arena_.allocate(count * sizeof(T), alignof(T)));
    }
    template <class T>
    const T* copy(const T* values, size_t count) {
        T* const to = count == 0 ? nullptr : take_room<T>(count);
        std::copy_n(values, count, to);
        return to;
    }

    // A view of the text where that is possible.
    std::string_view string(bool keep) {
        expect('"');
        const size_t first = at_;
        bool escapes = false;
        unescaped_.clear();
        while (true) {
            const size_t run = at_;
            while (at_ < text_.size() && text_[at_] != '"' && text_[at_] != '\\') {
                const size_t size = utf8_size(text_.substr(at_));
                if (size == 0 || static_cast<unsigned char>(text_[at_]) < ' ') refuse();
                at_ += size;
            }
            if (escapes || peek() == '\\') unescaped_.append(text_.substr(run, at_ - run));
            if (take('"')) break;
            expect('\\');
            escapes = true;
            unescape();
        }
        if (!escapes) return text_.substr(first, at_ - 1 - first);
        return {keep ? copy(unescaped_.data(), unescaped_.size()) : nullptr, keep ? unescaped_.size() : 0};
    }

    void unescape() {
        constexpr std::string_view names = "\"\\/bfnrt", values = "\"\\/\b\f\n\r\t";
        if (const size_t known = at_ < text_.size() ? names.find(text_[at_]) : names.npos; known != names.npos) {
            ++at_;
            unescaped_ += values[known];
            return;
        }
        expect('u');
        uint32_t code = hex_digits();
        constexpr uint32_t high = 0xd800, low = 0xdc00, end = 0xe000;
        if (code >= low && code < end) refuse();
        if (code >= high && code < low) {
            word("\\u");
            const uint32_t second = hex_digits();
            if (second < low || second >= end) refuse();
            code = 0x10000 + ((code - high) << 10 | (second - low));
        }
        const auto put = [&](uint32_t byte) { unescaped_ += static_cast<char>(byte); };
        if (code < 0x80) return put(code);
        if (code < 0x800) {
            put(0xc0 | code >> 6);
        } else {
            if (code < 0x10000) {
                put(0xe0 | code >> 12);
            } else {
                put(0xf0 | code >> 18);
                put(0x80 | (code >> 12 & 0x3f));
            }
            put(0x80 | (code >> 6 & 0x3f));
        }
        put(0x80 | (code & 0x3f));
    }

    uint32_t hex_digits() {
        uint32_t code = 0;
        for (int i = 0; i < 4; ++i, ++at_) {
            uint32_t digit = 0;
            if (at_ >= text_.size() || std::from_chars(&text_[at_], &text_[at_] + 1, digit, 16).ec != std::errc{})
                refuse();
            code = code << 4 | digit;
        }
        return code;
    }

    void digits() {
        const size_t first = at_;
        while (peek() >= '0' && peek() <= '9') ++at_;
        if (at_ == first) refuse();
    }

    void number(Json& result) {
        const size_t first = at_;
        const bool negative = take('-');
        const bool below_one = take('0');
        if (!below_one) digits();
        bool whole = !negative;
        if (take('.')) {
            whole = false;
            digits();
        }
        const bool has_exponent = take('e') || take('E');
        const bool small = has_exponent ? peek() == '-' : below_one;
        if (has_exponent) {
            whole = false;
            if (!take('-')) take('+');
            digits();
        }
        const char* const begin = text_.data() + first;
        const char* const end = text_.data() + at_;
        if (whole && std::from_chars(begin, end, result.value_.count).ec == std::errc{}) {
            result.type_ = Json::Type::count;
            return;
        }
        result.type_ = Json::Type::number;
        result.value_.number = 0;
        if (std::from_chars(begin, end, result.value_.number).ec == std::errc{} || small) return;
        fail(FLG_ERROR_FORMAT, byte_place(part_, at_), "is no JSON: holds a number beyond those of doubles");
    }

    const std::string_view text_;
    const uint32_t max_levels_;
    const std::string_view part_, only_;
    std::pmr::memory_resource& arena_;
    size_t at_ = 0;
    // Of the lists and objects that are open; the innermost one's are the last.
    Vector<Json> items_;
    Vector<OpenMember> members_;
    String unescaped_;
};

JsonDocument::JsonDocument(Bytes text, uint32_t max_levels, std::string_view part, std::string_view only)
    : root_(JsonParser(text, max_levels, part, only, arena_).document()) {}

}  // namespace flg::io
