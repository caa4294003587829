// SPDX-License-Identifier: MIT
#include "tangle_document.h"

#include <memory>

#include "documents/failure.h"
#include "filigree/filigree_io.h"

namespace flg::cli {

namespace {

void check_io(FlgResult result) {
    if (result != FLG_OK) throw InputError(flgIoErrorGetMessage());
}

}  // namespace

bool is_document(const nlohmann::json& file) {
    return file.is_object() && file.contains("filigree");
}

void replay_document(Session& session, FlgTangle tangle, const std::string& name, Report& report) {
    FlgTangleFile read = nullptr;
    check_io(flgTangleFileRead(name.c_str(), nullptr, &read));
    const std::unique_ptr<FlgTangleFileT, void (*)(FlgTangleFile)> file(read, flgTangleFileRelease);
    FlgTangleHistory history = {};
    history.struct_size = sizeof history;
    check_io(flgTangleFileGetHistory(file.get(), &history));
    FlgJob job = {};
    check(flgTangleReplay(session.context(), tangle, &history, nullptr, &job), name);
    session.finish({{{job, name}}}, report);
}

void write_document(const Session& session, FlgTangle tangle, const std::string& name) {
    FlgTangleHistory history = {};
    history.struct_size = sizeof history;
    check(flgTangleGetHistory(session.context(), tangle, &history), name);
    check_io(flgTangleFileWrite(name.c_str(), &history, nullptr));
}

}  // namespace flg::cli
