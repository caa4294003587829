// SPDX-License-Identifier: MIT
// JSON that is read and JSON that is refused, as parts of glTF documents that no reader looks at.
#include "io/gltf_files.h"

namespace flg::test {
namespace {

std::string with_extras(std::string_view json) {
    std::string text = Document().text();
    return text.insert(1, "\"extras\": " + std::string(json) + ", ");
}

TEST(Json, OfEveryKindIsRead) {
    const Folder folder;
    for (const char* json : {"null",
                             "true",
                             "false",
                             "0",
                             "-0",
                             "-1",
                             "12.5",
                             "1e5",
                             "1E+5",
                             "1e-5",
                             "0.1e1",
                             "1e-400",
                             "0.0e999",
                             "18446744073709551616",
                             "\"\"",
                             R"("\"\\\/\b\f\n\r\t\u00e4\uD83D\uDE00")",
                             "\"\x7f\xc3\xa4\xed\x9f\xbf\"",
                             "\"\xf0\x90\x8d\x88\xf4\x8f\xbf\xbf\"",
                             "[]",
                             "[ ]",
                             "{}",
                             "{ }",
                             " [ 1 , [ 2 ] ] ",
                             R"({"a":1,"a":{"b":[]},"":0})",
                             "\t\r\n 1"}) {
        EXPECT_EQ(read(folder.put("a.gltf", with_extras(json))).error, "") << json;
    }
    EXPECT_EQ(read(folder.put("a.gltf", "\xef\xbb\xbf" + Document().text())).error, "");
    EXPECT_EQ(read(folder.put("a.gltf", Document().text() + " \n")).error, "");
    EXPECT_EQ(read(folder.put("a.gltf", Document().text() + std::string(3, '\0'))).error, "");
}

TEST(Json, ThatIsNoneIsRefused) {
    const Folder folder;
    for (const char* json : {"",
                             "nul",
                             "True",
                             "+1",
                             "01",
                             "1.",
                             ".5",
                             "1e",
                             "1e+",
                             "--1",
                             "- 1",
                             "0x1",
                             "1e400",
                             "-1e400",
                             "NaN",
                             "'a'",
                             "\"",
                             "\"a",
                             "\"\n\"",
                             "\"\x1f\"",
                             R"("\a")",
                             R"("\u12")",
                             R"("\u12g4")",
                             R"("\ud83d")",
                             R"("\ud83d\u0041")",
                             R"("\ude00")",
                             "\"\xc3\"",
                             "\"\xc0\xaf\"",
                             "\"\xe0\x9f\xbf\"",
                             "\"\xed\xa0\x80\"",
                             "\"\xf0\x8f\xbf\xbf\"",
                             "\"\xf4\x90\x80\x80\"",
                             "\"\xff\"",
                             "[1",
                             "[1,]",
                             "[,1]",
                             "[1 2]",
                             "[1}",
                             "{\"a\"}",
                             "{\"a\":}",
                             "{a:1}",
                             "{\"a\":1,}",
                             "{\"a\":1",
                             "{1:1}",
                             "{\"a\" 1}",
                             "/**/1"}) {
        const Read refused = read(folder.put("a.gltf", with_extras(json)));
        EXPECT_EQ(refused.result, FLG_ERROR_FORMAT) << json;
        EXPECT_NE(refused.error.find("is no JSON"), std::string::npos) << json << ": " << refused.error;
    }
    EXPECT_EQ(read(folder.put("a.gltf", Document().text() + "1")).result, FLG_ERROR_FORMAT);
    // As deep as may be, and one level more.
    const auto nested = [](size_t levels) { return std::string(levels, '[') + std::string(levels, ']'); };
    EXPECT_EQ(read(folder.put("a.gltf", with_extras(nested(128)))).error, "");
    expect_refused(folder.put("a.gltf", with_extras(nested(129))), FLG_ERROR_LIMIT, "", "deeper than 128 levels");
    expect_refused(folder.put("a.gltf", with_extras(nested(1'000'000))), FLG_ERROR_LIMIT, "", "deeper than 128 levels");
}

// The last of several members of one name counts, as in other readers.
TEST(Json, TheLastMemberOfANameCounts) {
    const Folder folder;
    std::string text = Document().text();
    text.insert(1, R"("accessors": 3, "meshes": [], "\u0061ccessors": {}, )");
    EXPECT_EQ(read(folder.put("a.gltf", text)).positions().size(), 12u);
}

}  // namespace
}  // namespace flg::test
