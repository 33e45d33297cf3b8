// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include <glark/c/edit.h>
#include <glark/edit.h>

#include "glark/clients/common/c_boundary.h"

using glark::c::array_of;
using glark::c::needed;
namespace edit = glark::edit;

struct glark_edit_session {
  edit::Session session;
};

namespace {

static_assert(static_cast<int>(edit::Element::file) == GLARK_EDIT_FILE);

template <class Step>
glark_code guarded(glark_error* error, const Step& step) {
  return glark::c::guarded<edit::Error>(error, step);
}

}  // namespace

glark_edit_session_options glark_edit_default_session_options(void) {
  const edit::SessionOptions options;
  return {options.target, options.memory, options.threads};
}

glark_code glark_edit_session_open(const char* scan, const char* folder, const glark_edit_session_options* options,
                                   glark_edit_session** session, glark_error* error) {
  return guarded(error, [&] {
    glark_edit_session*& result = needed(session, "session");
    edit::SessionOptions how;
    if (options != nullptr) {
      how.target = options->target;
      how.memory = options->memory;
      how.threads = options->threads;
    }
    result = new glark_edit_session{edit::Session(&needed(scan, "scan"), &needed(folder, "folder"), how)};
  });
}

void glark_edit_session_free(glark_edit_session* session) { delete session; }

glark_code glark_edit_session_apply(glark_edit_session* session, const char* operation, glark_error* error) {
  return guarded(error,
                 [&] { needed(session, "session").session.apply(edit::parse(&needed(operation, "operation"))); });
}

size_t glark_edit_session_operations(const glark_edit_session* session) {
  return session == nullptr ? 0 : session->session.operations();
}

size_t glark_edit_session_size(const glark_edit_session* session) {
  return session == nullptr ? 0 : session->session.editor().size();
}

const double* glark_edit_session_positions(const glark_edit_session* session) {
  return session == nullptr ? nullptr : session->session.editor().positions().data();
}

glark_floats glark_edit_session_normals(const glark_edit_session* session) {
  return session == nullptr ? glark_floats{} : array_of(session->session.editor().normals());
}

glark_bytes glark_edit_session_colours(const glark_edit_session* session) {
  return session == nullptr ? glark_bytes{} : array_of(session->session.editor().colours());
}

glark_code glark_edit_session_save(const glark_edit_session* session, const char* output, glark_error* error) {
  return guarded(error, [&] { needed(session, "session").session.save(&needed(output, "output")); });
}
